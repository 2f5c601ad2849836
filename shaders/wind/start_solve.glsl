// What the flux pass found, and how much of it the solve may leave. docs/solver.md section 6, points 1 to 3. Needs
// block.glsl and a buffer `control`.
#define SUM_COUNT 4  // f0^2, b^2, speed^2; greatest f0
#define SUM_ADDED 3
#include "shaders/wind/sums.glsl"
#include "shaders/wind/total.glsl"
#include "shaders/wind/solve_control.glsl"

// Where the expected pressure makes the flux larger it is dropped, and the flux pass runs a second time without it;
// where no second one was recorded, nothing is expected of the next step.
void startSolve() {
  float total[SUM_COUNT];
  addUp(total);
  if (gl_LocalInvocationIndex != 0u) return;
  control.fluxBefore = total[0] * wind.perAir;
  control.maxFluxBefore = total[3];
  control.fluxStart = total[1] * wind.perAir;
  control.flux = control.fluxStart;
  float floorFlux = WIND_ROUNDING_FLOOR * max(wind.hx, wind.hz);
  float speedSquare = total[2] * wind.perCell;
  control.wanted = max(wind.tolerance * wind.tolerance * control.fluxBefore, floorFlux * floorFlux * speedSquare);
  control.cycles = 0u;
  bool useless = control.history != WIND_HISTORY_NONE && !(control.fluxStart <= control.fluxBefore);
  bool again = useless && wind.mayDrop != 0;
  if (useless) control.history = again ? WIND_HISTORY_NONE : WIND_HISTORY_BAD;
  setDispatches(true, again);
}
