// Joining V-cycles by conjugate residuals (Eisenstat, Elman & Schultz 1983), on level 0: before the next cycle, the
// last one's correction is made part of the solution and its effect taken off the residual. docs/solver.md section 6.
// Needs region.glsl and a buffer `control`.

layout(std430, binding = WIND_SSBO_D_IN) readonly buffer DIn { float z[]; };
layout(std430, binding = WIND_SSBO_FLUX) buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_APPLIED) buffer Applied { float applied[]; };
layout(std430, binding = WIND_SSBO_LAST_APPLIED) buffer LastApplied { float lastApplied[]; };
layout(std430, binding = WIND_SSBO_JOINED) buffer Joined { float joined[]; };
#include "shaders/wind/halves.glsl"

void loadJoined(const bool plain) {
  uint done = control.cycles;
  float alpha = control.alpha, beta = control.beta;
  bool more = done > 1u;  // there was a p before this one
  int plane = planeSize(), from = halfOf(done - 1u), to = halfOf(done);
  locate(plain);
  for (int n = 0; n < WIND_STRIP; ++n) {
    cells[n].b = 0.0;
    if (!isThere(plain, n)) continue;
    int cell = found[n];
    float ap = applied[cell] - (more ? beta * lastApplied[from + cell] : 0.0);
    float left = residualOf(done - 1u, cell) - alpha * ap;
    cells[n].b = left;
    if (!isInner(plain, n)) continue;
    if ((done & 1u) == 0u) {
      flux[cell] = left;
    } else {
      applied[plane + cell] = left;
    }
    lastApplied[to + cell] = ap;
    float p = z[cell] - (more ? beta * joined[cell] : 0.0);
    joined[plane + cell] = (more ? joined[plane + cell] : 0.0) + alpha * p;
    joined[cell] = p;
  }
}
