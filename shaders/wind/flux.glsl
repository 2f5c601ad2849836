// The right-hand side of the pressure solve, on level 0: what flows out of the cells once the pressure that is expected
// is taken off the velocity. docs/solver.md section 6, points 1 to 3. Needs region.glsl and a buffer `control`.
#define SUM_COUNT 4
#define SUM_ADDED 3
#include "shaders/wind/sums.glsl"

layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Star { float star[]; };
layout(std430, binding = WIND_SSBO_PREDICTED) readonly buffer Predicted { float predicted[]; };
layout(std430, binding = WIND_SSBO_FLUX) writeonly buffer Flux { float flux[]; };

// b of the strip from the velocity and the expected pressure; adds up f0^2, b^2 and speed^2, and finds
// the greatest f0. What the pressure's
// gradient carries out of a cell is summed from differences, which are exact where it is smooth.
void loadFlux(const bool plain, inout float sums[SUM_COUNT]) {
  bool kept = wind.mayDrop == 0 || control.history != WIND_HISTORY_NONE;  // a look at it takes long
  locate(plain);
  for (int n = 0; n < WIND_STRIP; ++n) {
    bool there = isThere(plain, n);
    cells[n].d = there && kept ? predicted[found[n]] : 0.0;
    cells[n].b = 0.0;
    if (!there) continue;
    ivec2 place = plain ? placeOf(n) : wrappedPlace(n);
    int u = uAt(place.x, place.y), w = wAt(place.x, place.y);
    float speedX = star[u], speedZ = star[w];
    cells[n].b = (star[u + 1] - speedX) * wind.hz + (star[w + wind.stride] - speedZ) * wind.hx;
    if (isInner(plain, n)) sums[2] += speedX * speedX + speedZ * speedZ;
  }
  publish();
  float carried[WIND_STRIP];
  gatherRises(plain, carried);
  for (int n = 0; n < WIND_STRIP; ++n) {
    float before = cells[n].b;
    cells[n].b = before - carried[n];
    if (!isInner(plain, n)) continue;
    sums[0] += before * before;
    sums[3] = max(sums[3], abs(before));
    sums[1] += cells[n].b * cells[n].b;
    flux[found[n]] = cells[n].b;
  }
  barrier();
}
