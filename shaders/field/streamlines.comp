#version 450 core
// Short lines through the wind as it is now, one for each seed: from a place that changes with each life, as far as
// the air would drift, followed by a moving window of which the front is the head. Stateless: seed and time give all.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/overlay.glsl"
#include "shaders/shared/flow_seed.h"
#include "shaders/shared/hash.h"

layout(local_size_x = 64) in;
layout(std430, binding = RENDER_SSBO_SEEDS) readonly buffer Seeds { FlowSeed seeds[]; };
layout(std430, binding = RENDER_SSBO_LINES) writeonly buffer Lines { vec4 lines[]; };  // x, z, part of the range, alpha
uniform int count;

const float kShortestLife = 2.2, kLongestLife = 3.8;  // s
const float kDriftPixels = 260.0;  // of a whole life at the top of the speed range
const float kWindow = 0.55;        // of a life's way that shows
const int kLeadSteps = 6;          // up to the window

// m per life.
vec2 drift(vec2 at, float reach) {
  vec2 wind = fieldWind(at);
  float speed = length(wind);
  float part = speed / frame.pixelScale.z;
  return speed > 1e-4 ? wind / speed * reach * (0.36 + 0.64 * min(part, 1.4)) : vec2(0.0);
}

// Midpoint rule.
vec2 follow(vec2 at, float reach, float share) {
  return at + share * drift(at + 0.5 * share * drift(at, reach), reach);
}

float openAir(vec2 at) {
  vec2 inside = min(at - frame.field.xy, frame.field.xy + frame.field.zw - at);
  return solidsNear(at).distanceM > 0.0 && min(inside.x, inside.y) > 0.0 ? 1.0 : 0.0;
}

void main() {
  int line = int(gl_GlobalInvocationID.x);
  if (line >= count) return;
  FlowSeed seed = seeds[line];
  uint own = pcgHash(seed.key);
  float turn = frame.viewForward.w / mix(kShortestLife, kLongestLife, hashToUnit(own)) + hashToUnit(pcgHash(own + 1u));
  float age = fract(turn);
  uint life = hashCombine(own, uint(int(floor(turn))));
  vec2 at = seed.place.xy + seed.place.z * (vec2(hashToUnit(life), hashToUnit(pcgHash(life))) - 0.5);
  float reach = metresFor(kDriftPixels * pixelUnit(), seed.place.xy);
  float tail = max(age - kWindow, 0.0);
  float lit = seed.place.w * smoothstep(0.0, 0.15, age) * (1.0 - smoothstep(0.75, 1.0, age)) * openAir(at);
  for (int i = 0; i < kLeadSteps; ++i) at = follow(at, reach, tail / float(kLeadSteps));
  float share = (age - tail) / float(FLOW_LINE_POINTS - 1);
  for (int i = 0; i < FLOW_LINE_POINTS; ++i) {
    lit *= openAir(at);
    float part = length(fieldWind(at)) / frame.pixelScale.z;
    lines[line * FLOW_LINE_POINTS + i] = vec4(at, part, lit * smoothstep(0.004, 0.03, part));
    at = follow(at, reach, share);
  }
}
