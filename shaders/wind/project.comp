#version 450 core
// The end of a step: u = q* - grad phi - grad d, phi += d, cell velocities, diagnostics. docs/solver.md sections 6 and
// 7.
// RESAMPLE_ONLY: only cell velocities, of a field that is already there.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_GROUP_X, local_size_y = WIND_GROUP_Z) in;
layout(rg32f, binding = WIND_IMAGE_CELLS) writeonly uniform image2D cellVelocities;

vec2 limited(vec2 v) {
  float speed = length(v);
  return speed > wind.maxSpeed ? v * (wind.maxSpeed / speed) : v;
}

#ifdef RESAMPLE_ONLY

layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Velocity { float velocity[]; };
#include "shaders/wind/cell_velocity.glsl"

void main() {
  ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
  if (cell.x >= wind.width || cell.y >= wind.height) return;
  imageStore(cellVelocities, cell, vec4(limited(cellVelocity(cell.x, cell.y)), 0.0, 0.0));
}

#else

layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Star { float star[]; };
layout(std430, binding = WIND_SSBO_RESULT) writeonly buffer Result { float result[]; };
layout(std430, binding = WIND_SSBO_PHI) buffer Phi { float phi[]; };
layout(std430, binding = WIND_SSBO_PREDICTED) readonly buffer Predicted { float predicted[]; };
layout(std430, binding = WIND_SSBO_D_IN) readonly buffer D { float d[]; };
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer NextPredicted { float nextPredicted[]; };
layout(std430, binding = WIND_SSBO_CONTROL) readonly buffer Control { WindControl control; };

#define GROUP_SIZE (WIND_GROUP_X * WIND_GROUP_Z)
#define SUM_COUNT 5
#define SUM_ADDED 2
shared float scratch[SUM_COUNT * GROUP_SIZE];
#include "shaders/wind/sums.glsl"
#ifndef JACOBI
layout(std430, binding = WIND_SSBO_JOINED) readonly buffer Joined { float joined[]; };
#endif
#define GHOST_TARGET result
#include "shaders/wind/ghosts.glsl"
#include "shaders/wind/gradient.glsl"

// The cells beside a cell, in the order of withoutGradient, around periodic borders.
ivec4 neighboursOf(int at, int i, int k) {
  int last = (wind.height - 1) * wind.width;
  return ivec4(i > 0 ? at - 1 : at + wind.width - 1, i < wind.width - 1 ? at + 1 : at + 1 - wind.width,
               k > 0 ? at - wind.width : at + last, k < wind.height - 1 ? at + wind.width : at - last);
}

// How the solve's last cycle joins those before, see join.glsl. Read once: many invocations reading the same few words
// again and again wait for each other.
struct Solution {
  bool kept, bad, any, more;
  float alpha, beta;
};
Solution solution;

// What the solve adds to the expected pressure of a cell, as a part of addedScale(): after a single cycle its scale is
// left out until differences are taken, so that it adds no rounding.
float addedAt(int at) {
#ifdef JACOBI
  return d[at];
#else
  if (!solution.any) return 0.0;
  if (!solution.more) return d[at];
  return joined[wind.width * wind.height + at] + solution.alpha * (d[at] - solution.beta * joined[at]);
#endif
}
float addedScale() {
#ifdef JACOBI
  return 1.0;
#else
  return solution.more ? 1.0 : solution.alpha;
#endif
}
float expectedAt(int at) { return solution.kept ? predicted[at] : 0.0; }

// The faces of a cell with nothing but air around it, without the gradient of a pressure.
vec4 withoutPlainGradient(vec4 q, float p, vec4 around, float scale) {
  vec4 rise = vec4(p - around.x, around.y - p, p - around.z, around.w - p);
  vec4 next = q - rise * (scale * vec4(wind.perHx, wind.perHx, wind.perHz, wind.perHz));
  return vec4(finiteOr(next.x, q.x), finiteOr(next.y, q.y), finiteOr(next.z, q.z), finiteOr(next.w, q.w));
}

vec4 expectedAround(ivec4 at) { return vec4(expectedAt(at.x), expectedAt(at.y), expectedAt(at.z), expectedAt(at.w)); }
vec4 addedAround(ivec4 at) { return vec4(addedAt(at.x), addedAt(at.y), addedAt(at.z), addedAt(at.w)); }

void projectCell(int i, int k, inout float sums[SUM_COUNT]) {
  int at = cellAt(i, k), u = uAt(i, k), w = wAt(i, k);
  uint flags = flagsOf(i, k);
  vec4 q = vec4(star[u], star[u + 1], star[w], star[w + wind.stride]);
  float expected = expectedAt(at), added = addedAt(at);
  // One after the other: what is left to solve is small, so its rounding is that of the small part.
  bool inside = i > 0 && k > 0 && i < wind.width - 1 && k < wind.height - 1;
  if (inside && (flags & WIND_ALL_LINKS) == WIND_ALL_LINKS) {
    ivec4 beside = ivec4(at - 1, at + 1, at - wind.width, at + wind.width);
    q = withoutPlainGradient(q, expected, expectedAround(beside), 1.0);
    q = withoutPlainGradient(q, added, addedAround(beside), addedScale());
  } else {
    ivec4 beside = neighboursOf(at, i, k);
    q = withoutGradient(q, flags, expected, expectedAround(beside), 1.0);
    q = withoutGradient(q, flags, added, addedAround(beside), addedScale());
  }
  float pressure = finiteOr(expected + addedScale() * added, 0.0);
  float next = solution.kept ? 2.0 * pressure - phi[at] : pressure;
  nextPredicted[at] = solution.bad ? 0.0 : finiteOr(next, 0.0);
  phi[at] = pressure;
  storeU(i, k, q.x);
  storeW(i, k, q.z);
  if (i == wind.width - 1) storeU(i + 1, k, q.y);
  if (k == wind.height - 1) storeW(i, k + 1, q.w);
  vec2 v = 0.5 * vec2(q.x + q.y, q.z + q.w);
  float flux = (q.y - q.x) * wind.hz + (q.w - q.z) * wind.hx;
  float square = dot(v, v);
  sums[0] += flux * flux;
  sums[1] += (flags & WIND_SOLID) != 0u ? 0.0 : square;
  sums[2] = max(sums[2], abs(flux));
  sums[3] = max(sums[3], square);
  sums[4] = max(sums[4], max(abs(v.x) * wind.perHx, abs(v.y) * wind.perHz) * wind.dt);
  imageStore(cellVelocities, ivec2(i, k), vec4(limited(v), 0.0, 0.0));
}

void main() {
  int i = int(gl_GlobalInvocationID.x);
  int first = int(gl_WorkGroupID.y) * WIND_GROUP_Z * WIND_PROJECT_STRIP + int(gl_LocalInvocationID.y);
  uint history = control.history;
  solution = Solution(history != WIND_HISTORY_NONE, history == WIND_HISTORY_BAD, control.cycles > 0u,
                      control.cycles > 1u, control.alpha, control.beta);
  float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0, 0.0, 0.0);  // flux^2, |v|^2; greatest flux, |v|^2, crossing
  for (int n = 0; n < WIND_PROJECT_STRIP; ++n) {
    int k = first + n * WIND_GROUP_Z;
    if (i < wind.width && k < wind.height) projectCell(i, k, sums);
  }
  deliver(sums);
}
#endif
