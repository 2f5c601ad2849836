#version 450 core
// The way down of the pressure solve on one level: smooth from d = 0, then hand the residual to the next level.
// docs/solver.md section 6.
// FIRST: on level 0 in the first cycle.  AGAIN: there in later cycles.  Neither: on a coarser level.
// JACOBI (level 0): `sweepCount` plain sweeps instead, without FIRST from the d there is, and no next level.
#if defined(FIRST) || defined(AGAIN) || defined(JACOBI)
#define LEVEL0
#endif
#include "shaders/wind/region.glsl"

#ifdef JACOBI
#define SWEEP_WEIGHT(m) 1.0
uniform int sweepCount;  // at most WIND_HALO
#else
#define SWEEP_WEIGHT(m) smoothingWeight(m)
const int sweepCount = WIND_GPU_SWEEPS;
layout(std430, binding = WIND_SSBO_COARSE) writeonly buffer Coarse { float coarse[]; };
#endif
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };

#if defined(FIRST)
layout(std430, binding = WIND_SSBO_CONTROL) coherent buffer Control { WindControl control; };
#include "shaders/wind/flux.glsl"
#elif defined(AGAIN)
layout(std430, binding = WIND_SSBO_CONTROL) readonly buffer Control { WindControl control; };
#include "shaders/wind/join.glsl"
#else
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
#ifdef JACOBI
layout(std430, binding = WIND_SSBO_D_IN) readonly buffer DIn { float dIn[]; };
#endif

void load() {
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    loadStencil(n, place);
    cells[n].b = place.x >= 0 ? flux[levelCell(place)] : 0.0;
#ifdef JACOBI
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
#if defined(FIRST)
  float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0);
  loadFlux(sums);
#elif defined(AGAIN)
  loadJoined();
#else
  load();
#endif
#if defined(JACOBI) && !defined(FIRST)
  publish();
  for (int m = 0; m < sweepCount; ++m) sweep(SWEEP_WEIGHT(m));
#else
  firstSweep(SWEEP_WEIGHT(0));
  for (int m = 1; m < sweepCount; ++m) sweep(SWEEP_WEIGHT(m));
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
