#version 450 core
// Distance to a solid and the height over the ground its shadow reaches, negated: the least over all solids is kept of both.
#include "shaders/include/frame.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/solid_shape.glsl"

flat in int solidIndex;
in vec2 mapWorld;
layout(location = 0) out vec2 nearest;

void main() {
  Solid solid = solids[solidIndex];
  vec2 towardsSun = normalize(frame.sunDirection.xz);
  float slope = frame.sunDirection.y / length(frame.sunDirection.xz);
  float along = rayToSolid(solid, mapWorld, towardsSun);
  float shadowHeight = along < 0.0 ? -1.0 : max(solid.level.y - along * slope - groundHeight(mapWorld), -1.0);
  nearest = vec2(distanceToSolid(solid, mapWorld), -shadowHeight);
}
