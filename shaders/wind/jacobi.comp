#version 450 core
// `pressure: jacobi`: `sweepCount` plain sweeps on the grid. docs/solver.md section 6.
// FIRST: from d = 0, after the flux is found.
#define LEVEL0
#include "shaders/wind/region.glsl"

uniform int sweepCount;  // at most WIND_HALO
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };

#ifdef FIRST
layout(std430, binding = WIND_SSBO_CONTROL) readonly buffer Control { WindControl control; };
#include "shaders/wind/flux.glsl"
#else
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_D_IN) readonly buffer DIn { float dIn[]; };

void load(const bool plain) {
  locate(plain);
  for (int n = 0; n < WIND_STRIP; ++n) {
    cells[n].b = isThere(plain, n) ? flux[found[n]] : 0.0;
    cells[n].d = isThere(plain, n) ? dIn[found[n]] : 0.0;
  }
}
#endif

#ifdef FIRST
float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0, 0.0);
#endif

void run(const bool plain) {
#ifdef FIRST
  loadFlux(plain, sums);
  for (int n = 0; n < WIND_STRIP; ++n) cells[n].d = afterFirstSweep(n, 1.0);
  const int done = 1;
#else
  load(plain);
  const int done = 0;
#endif
  publish();
  for (int m = done; m < sweepCount; ++m) sweep(plain, 1.0);
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (isInner(plain, n)) dOut[found[n]] = cells[n].d;
  }
}

void main() {
  if (isPlainRegion()) {
    run(true);
  } else {
    run(false);
  }
#ifdef FIRST
  deliver(sums);
#endif
}
