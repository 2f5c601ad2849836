#version 450 core
// The way down of the pressure solve on one level: smooth, then hand the residual to the next level. docs/solver.md
// section 6.
// FIRST (level 0): also takes the last step's pressure off the velocity (points 1 and 2 there) and starts from d = 0.
// FROM_ZERO: starts from d = 0.  JACOBI: `sweepCount` plain sweeps instead, and no next level.
#ifdef FIRST
#define LEVEL0
#define FROM_ZERO
#endif
#include "shaders/wind/region.glsl"

#ifdef JACOBI
#define SWEEP_WEIGHT(m) 1.0
#else
#define SWEEP_WEIGHT(m) smoothingWeight(m)
#endif

layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };
#ifndef FROM_ZERO
layout(std430, binding = WIND_SSBO_D_IN) readonly buffer DIn { float dIn[]; };
#endif
#ifdef FIRST
layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Star { float star[]; };
layout(std430, binding = WIND_SSBO_PHI) readonly buffer Phi { float phi[]; };
layout(std430, binding = WIND_SSBO_FLUX) writeonly buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_CONTROL) coherent buffer Control { WindControl control; };
#define SUM_COUNT 3
#define SUM_ADDED 3
#include "shaders/wind/sums.glsl"
#include "shaders/wind/solve_control.glsl"
#include "shaders/wind/gradient.glsl"
#else
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
#endif
#ifdef JACOBI
uniform int sweepCount;  // at most WIND_HALO
#else
layout(std430, binding = WIND_SSBO_COARSE) writeonly buffer Coarse { float coarse[]; };
#endif

#ifdef FIRST
// b of the strip from the velocity without the last step's pressure; adds up f0^2, b^2 and speed^2.
void loadFlux(inout float sums[SUM_COUNT]) {
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    loadStencil(n, place);
    cells[n].d = place.x >= 0 ? phi[levelCell(place)] : 0.0;
  }
  findIrregular();
  publish();
  int at = scratchAt(0);
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    cells[n].b = 0.0;
    if (place.x < 0) continue;
    int mine = at + n * WIND_REGION;
    // The rim of the region has no neighbours to read; nothing that counts comes from there.
    vec4 around = vec4(localX() > 0 ? scratch[mine - 1] : 0.0, localX() < WIND_REGION - 1 ? scratch[mine + 1] : 0.0,
                       localZ(n) > 0 ? scratch[mine - WIND_REGION] : 0.0,
                       localZ(n) < WIND_REGION - 1 ? scratch[mine + WIND_REGION] : 0.0);
    vec4 q = vec4(star[uAt(place.x, place.y)], star[uAt(place.x + 1, place.y)], star[wAt(place.x, place.y)],
                  star[wAt(place.x, place.y + 1)]);
    vec4 p = withoutGradient(q, cells[n].flags, cells[n].d, around);
    float before = (q.y - q.x) * wind.hz + (q.w - q.z) * wind.hx;
    float b = (p.y - p.x) * wind.hz + (p.w - p.z) * wind.hx;
    cells[n].b = b;
    if (!isInner(n)) continue;
    sums[0] += before * before;
    sums[1] += b * b;
    sums[2] += q.x * q.x + q.z * q.z;
    flux[levelCell(place)] = b;
  }
  barrier();
}

void startSolve(float total[SUM_COUNT]) {
  control.fluxBefore = total[0] * wind.perAir;
  control.fluxStart = total[1] * wind.perAir;
  control.flux = control.fluxStart;
  float floorFlux = WIND_ROUNDING_FLOOR * max(wind.hx, wind.hz);
  float speedSquare = total[2] * wind.perCell;
  control.wanted = max(wind.tolerance * wind.tolerance * control.fluxBefore, floorFlux * floorFlux * speedSquare);
  control.cycles = 0u;
  bool run = control.fluxStart > control.wanted;
  control.converged = run ? 0u : 1u;
  setDispatches(run);
}
#else
void load() {
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    loadStencil(n, place);
    cells[n].b = place.x >= 0 ? flux[levelCell(place)] : 0.0;
#ifndef FROM_ZERO
    cells[n].d = place.x >= 0 ? dIn[levelCell(place)] : 0.0;
#endif
  }
  findIrregular();
}
#endif

#ifndef JACOBI
// Sums the residuals of the fine cells of each coarse cell.
void restrictResidual() {
  float left[WIND_STRIP];
  residuals(left);
  barrier();
  for (int n = 0; n < WIND_STRIP; ++n) scratch[scratchAt(n)] = isInner(n) ? left[n] : 0.0;
  barrier();
  const int across = WIND_INNER / FACTOR_X, along = WIND_INNER / FACTOR_Z;
  ivec2 first = ivec2(gl_WorkGroupID.xy) * ivec2(across, along);
  for (int m = int(gl_LocalInvocationIndex); m < across * along; m += GROUP_SIZE) {
    ivec2 local = ivec2(m % across, m / across);
    ivec2 place = first + local;
    if (place.x >= level.coarseWidth || place.y >= level.coarseHeight) continue;
    float sum = 0.0;
    for (int b = 0; b < FACTOR_Z; ++b) {
      for (int a = 0; a < FACTOR_X; ++a) {
        sum += scratch[(WIND_HALO + local.y * FACTOR_Z + b) * WIND_REGION + WIND_HALO + local.x * FACTOR_X + a];
      }
    }
    coarse[place.y * level.coarseWidth + place.x] = sum;
  }
}
#endif

void main() {
#ifdef FIRST
  float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0);
  loadFlux(sums);
#else
  load();
#endif
#ifdef JACOBI
  const int count = sweepCount;
#else
  const int count = WIND_GPU_SWEEPS;
#endif
#ifdef FROM_ZERO
  firstSweep(SWEEP_WEIGHT(0));
  for (int m = 1; m < count; ++m) sweep(SWEEP_WEIGHT(m));
#else
  publish();
  for (int m = 0; m < count; ++m) sweep(SWEEP_WEIGHT(m));
#endif
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (isInner(n)) dOut[levelCell(placeOf(n))] = cells[n].d;
  }
#ifndef JACOBI
  restrictResidual();
#endif
#ifdef FIRST
  if (joinAll(sums) && gl_LocalInvocationIndex == 0u) startSolve(sums);
#endif
}
