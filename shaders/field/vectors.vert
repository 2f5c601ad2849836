#version 450 core
// Wind vectors on places that stand still in the world: one instance a seed, length and colour by speed.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/overlay.glsl"
#include "shaders/shared/flow_seed.h"

layout(std430, binding = RENDER_SSBO_SEEDS) readonly buffer Seeds { FlowSeed seeds[]; };
uniform vec2 lift;  // m over the ground, m that the depth leads

out vec3 vectorColour;
out vec2 vectorPlace;  // along, across
out float vectorAlpha;

// A slender arrow: shaft quad and head, in units of its length (x) and width (y).
const vec2 kShape[9] = vec2[9](vec2(0.0, -0.35), vec2(0.62, -0.35), vec2(0.0, 0.35), vec2(0.0, 0.35), vec2(0.62, -0.35),
                               vec2(0.62, 0.35), vec2(0.55, -1.0), vec2(1.0, 0.0), vec2(0.55, 1.0));

void main() {
  FlowSeed seed = seeds[gl_InstanceID];
  vec2 node = seed.place.xy;
  vec2 wind = fieldWind(node);
  float speed = length(wind);
  float part = speed / frame.pixelScale.z;
  vec2 along = speed > 1e-4 ? wind / speed : vec2(1.0, 0.0);
  vec2 aside = vec2(-along.y, along.x);
  // The strongest vectors nearly meet; air that rests has none.
  float len = metresFor(pixelUnit() * (7.0 + 30.0 * min(part, 1.2)), node);
  float wide = metresFor(pixelUnit() * 3.2, node);
  vec2 shape = kShape[gl_VertexID];
  vec2 at = node + along * len * (shape.x - 0.5) + aside * wide * shape.y;
  vectorColour = speedColourAt(part);
  vectorPlace = shape;
  vectorAlpha = seed.place.w * smoothstep(0.004, 0.03, part) * (solidsNear(node).distanceM > 0.0 ? 1.0 : 0.0);
  gl_Position = clipWithLead(overGround(at, lift.x), lift.y);
}
