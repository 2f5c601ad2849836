#version 450 core
// Distance to a solid and the height its shadow reaches; blended by least and greatest over all solids.
#include "shaders/include/frame.glsl"
#include "shaders/include/solid_shape.glsl"

flat in int solidIndex;
in vec2 mapWorld;
layout(location = 0) out float distanceM;
layout(location = 1) out float shadowM;

void main() {
  Solid solid = solids[solidIndex];
  distanceM = distanceToSolid(solid, mapWorld);
  vec2 towardsSun = normalize(frame.sunDirection.xz);
  float slope = frame.sunDirection.y / length(frame.sunDirection.xz);
  float along = rayToSolid(solid, mapWorld, towardsSun);
  shadowM = along < 0.0 ? -1.0 : max(solid.shape.z - along * slope, -1.0);
}
