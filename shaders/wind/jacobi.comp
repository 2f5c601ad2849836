#version 450 core
// `pressure: jacobi`: `sweepCount` plain sweeps on the grid. docs/solver.md section 6.
// FIRST: from d = 0, after the flux is found.
#define LEVEL0
#include "shaders/wind/region.glsl"

uniform int sweepCount;  // at most WIND_HALO
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };

#ifdef FIRST
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#include "shaders/wind/flux.glsl"
#else
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_D_IN) readonly buffer DIn { float dIn[]; };

bool load() {
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    loadStencil(n, place);
    cells[n].b = place.x >= 0 ? flux[levelCell(place)] : 0.0;
    cells[n].d = place.x >= 0 ? dIn[levelCell(place)] : 0.0;
  }
  return findPlain();
}
#endif

void main() {
#ifdef FIRST
  float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0);
  bool plain = loadFlux(sums);
  for (int n = 0; n < WIND_STRIP; ++n) cells[n].d = afterFirstSweep(n, 1.0);
  const int done = 1;
#else
  bool plain = load();
  const int done = 0;
#endif
  publish();
  if (plain) {
    for (int m = done; m < sweepCount; ++m) sweep(true, 1.0);
  } else {
    for (int m = done; m < sweepCount; ++m) sweep(false, 1.0);
  }
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (isInner(n)) dOut[levelCell(placeOf(n))] = cells[n].d;
  }
#ifdef FIRST
  if (joinAll(sums) && gl_LocalInvocationIndex == 0u) startSolve(sums);
#endif
}
