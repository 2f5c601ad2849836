// The right-hand side of the pressure solve, on level 0: what flows out of the cells once the pressure that is expected
// is taken off the velocity. docs/solver.md section 6, points 1 to 3. Needs region.glsl and a buffer `control`.
#define SUM_COUNT 3
#define SUM_ADDED 3
#include "shaders/wind/sums.glsl"
#include "shaders/wind/solve_control.glsl"
#include "shaders/wind/gradient.glsl"

layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Star { float star[]; };
layout(std430, binding = WIND_SSBO_PREDICTED) readonly buffer Predicted { float predicted[]; };
layout(std430, binding = WIND_SSBO_FLUX) writeonly buffer Flux { float flux[]; };

vec4 facesOfCell(ivec2 place) {
  int u = uAt(place.x, place.y), w = wAt(place.x, place.y);
  return vec4(star[u], star[u + 1], star[w], star[w + wind.stride]);
}

// b of the strip from the velocity without the expected pressure; adds up f0^2, b^2 and speed^2.
void loadFlux(inout float sums[SUM_COUNT]) {
  bool kept = control.history != 0u;
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    loadStencil(n, place);
    cells[n].d = place.x >= 0 && kept ? predicted[levelCell(place)] : 0.0;
  }
  regular = findRegular();
  publish();
  int at = scratchAt(0);
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    cells[n].b = 0.0;
    if (place.x < 0) continue;
    int mine = at + n * REGION;
    // The rim of the region has no neighbours to read; nothing that counts comes from there.
    vec4 around = vec4(localX() > 0 ? scratch[mine - 1] : 0.0, localX() < REGION - 1 ? scratch[mine + 1] : 0.0,
                       localZ(n) > 0 ? scratch[mine - REGION] : 0.0,
                       localZ(n) < REGION - 1 ? scratch[mine + REGION] : 0.0);
    vec4 q = facesOfCell(place), p;
    if (regular) {
      vec4 rise = vec4(cells[n].d - around.x, around.y - cells[n].d, cells[n].d - around.z, around.w - cells[n].d);
      p = q - rise * vec4(wind.perHx, wind.perHx, wind.perHz, wind.perHz);
    } else {
      p = withoutGradient(q, cells[n].flags, cells[n].d, around);
    }
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

// Where the expected pressure makes the flux larger it is dropped, and this pass runs a second time without it.
void startSolve(float total[SUM_COUNT]) {
  control.fluxBefore = total[0] * wind.perAir;
  control.fluxStart = total[1] * wind.perAir;
  control.flux = control.fluxStart;
  float floorFlux = WIND_ROUNDING_FLOOR * max(wind.hx, wind.hz);
  float speedSquare = total[2] * wind.perCell;
  control.wanted = max(wind.tolerance * wind.tolerance * control.fluxBefore, floorFlux * floorFlux * speedSquare);
  control.cycles = 0u;
  bool useless = control.history != 0u && !(control.fluxStart <= control.fluxBefore);
  bool run = !useless && control.fluxStart > control.wanted;
  if (useless) control.history = 0u;
  control.converged = run || useless ? 0u : 1u;
  setDispatches(run, useless);
}
