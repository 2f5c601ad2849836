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
layout(std430, binding = WIND_SSBO_PHI) readonly buffer Phi { float phi[]; };
layout(std430, binding = WIND_SSBO_D_IN) readonly buffer D { float d[]; };
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer NextPhi { float nextPhi[]; };
layout(std430, binding = WIND_SSBO_CONTROL) coherent buffer Control { WindControl control; };

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

// What the solve adds to the pressure of a cell: with multigrid the last cycle joined to those before, see join.glsl.
float solutionAt(int at) {
#ifdef JACOBI
  return d[at];
#else
  if (control.cycles == 0u) return 0.0;
  if (control.cycles == 1u) return control.alpha * d[at];
  return joined[wind.width * wind.height + at] + control.alpha * (d[at] - control.beta * joined[at]);
#endif
}

void report(float total[SUM_COUNT]) {
  control.fluxAfter = total[0] * wind.perAir;
  control.energy = 0.5 * total[1] * wind.perAir;
  control.maxFluxAfter = total[2];
  control.maxSpeedSquare = total[3];
  control.crossing = total[4];
  control.dropped = 0u;  // every work-group has read it
}

void main() {
  int i = int(gl_GlobalInvocationID.x), k = int(gl_GlobalInvocationID.y);
  float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0, 0.0, 0.0);  // flux^2, |v|^2; greatest flux, |v|^2, crossing
  if (i < wind.width && k < wind.height) {
    int at = cellAt(i, k);
    uint flags = flagsOf(i, k);
    vec4 q = vec4(star[uAt(i, k)], star[uAt(i + 1, k)], star[wAt(i, k)], star[wAt(i, k + 1)]);
    bool kept = control.dropped == 0u;
    float pressure = kept ? phi[at] : 0.0;
    ivec4 beside = neighboursOf(at, i, k);
    if (kept) q = withoutGradient(q, flags, pressure, vec4(phi[beside.x], phi[beside.y], phi[beside.z], phi[beside.w]));
    float solution = solutionAt(at);
    vec4 around = vec4(solutionAt(beside.x), solutionAt(beside.y), solutionAt(beside.z), solutionAt(beside.w));
    q = withoutGradient(q, flags, solution, around);
    nextPhi[at] = finiteOr(pressure + solution, 0.0);
    storeU(i, k, q.x);
    storeW(i, k, q.z);
    if (i == wind.width - 1) storeU(i + 1, k, q.y);
    if (k == wind.height - 1) storeW(i, k + 1, q.w);
    vec2 v = 0.5 * vec2(q.x + q.y, q.z + q.w);
    float flux = (q.y - q.x) * wind.hz + (q.w - q.z) * wind.hx;
    float square = dot(v, v);
    sums[0] = flux * flux;
    sums[1] = (flags & WIND_SOLID) != 0u ? 0.0 : square;
    sums[2] = abs(flux);
    sums[3] = square;
    sums[4] = max(abs(v.x) * wind.perHx, abs(v.y) * wind.perHz) * wind.dt;
    imageStore(cellVelocities, ivec2(i, k), vec4(limited(v), 0.0, 0.0));
  }
  if (joinAll(sums) && gl_LocalInvocationIndex == 0u) report(sums);
}
#endif
