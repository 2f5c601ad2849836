#version 450 core
// The way up of the pressure solve on one level: add the coarser level's correction, then smooth. docs/solver.md
// section 6.
// LEVEL0: also finds A z, plans how the cycle joins the ones before, and ends the solve when little enough is left.
#include "shaders/wind/region.glsl"

layout(std430, binding = WIND_SSBO_D_IN) readonly buffer DIn { float dIn[]; };
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_COARSE) readonly buffer Coarse { float coarse[]; };
layout(std430, binding = WIND_SSBO_COARSE_FACES) readonly buffer CoarseFaces { vec4 coarseFaces[]; };
#ifdef LEVEL0
layout(std430, binding = WIND_SSBO_APPLIED) buffer Applied { float applied[]; };
layout(std430, binding = WIND_SSBO_LAST_APPLIED) readonly buffer LastApplied { float lastApplied[]; };
layout(std430, binding = WIND_SSBO_CONTROL) coherent buffer Control { WindControl control; };
#define SUM_COUNT 4
#define SUM_ADDED 4
#include "shaders/wind/sums.glsl"
#include "shaders/wind/solve_control.glsl"
#include "shaders/wind/halves.glsl"
#endif

// The neighbour of a coarse cell one step along an axis, as seen across a border.
float acrossBorder(int border, float own) { return border == WIND_BORDER_OPEN ? -own : own; }

float coarseAt(int i, int k) { return coarse[k * level.coarseWidth + i]; }

// Offset of fine cell `c` from the centre of its coarse cell, in coarse cells.
float offsetIn(int c, int factor) { return (float(c % factor) + 0.5) / float(factor) - 0.5; }

float correctionAt(ivec2 place) {
  ivec2 c = place / ivec2(FACTOR_X, FACTOR_Z);
  float own = coarseAt(c.x, c.y);
  float sum = own;
  int nodes = level.coarseWidth + 1;
#if FACTOR_X > 1
  float x = offsetIn(place.x, FACTOR_X);
  int ni = x > 0.0 ? c.x + 1 : c.x - 1;
  float shareX = coarseFaces[c.y * nodes + (x > 0.0 ? c.x + 1 : c.x)].z;
  float beside = ni >= 0 && ni < level.coarseWidth ? coarseAt(ni, c.y)
                 : level.xMin == WIND_BORDER_PERIODIC ? coarseAt(ni < 0 ? level.coarseWidth - 1 : 0, c.y)
                                                      : acrossBorder(ni < 0 ? level.xMin : level.xMax, own);
  sum += abs(x) * shareX * (beside - own);
#endif
#if FACTOR_Z > 1
  float z = offsetIn(place.y, FACTOR_Z);
  int nk = z > 0.0 ? c.y + 1 : c.y - 1;
  float shareZ = coarseFaces[(z > 0.0 ? c.y + 1 : c.y) * nodes + c.x].w;
  float beyond = nk >= 0 && nk < level.coarseHeight ? coarseAt(c.x, nk)
                 : level.zMin == WIND_BORDER_PERIODIC ? coarseAt(c.x, nk < 0 ? level.coarseHeight - 1 : 0)
                                                      : acrossBorder(nk < 0 ? level.zMin : level.zMax, own);
  sum += abs(z) * shareZ * (beyond - own);
#endif
  return sum;
}

#ifdef LEVEL0
// The products r . A z, A z . A z, A z . A p and r . r of the inner cells; stores A z.
void measure(inout float sums[SUM_COUNT]) {
  float az[WIND_STRIP];
  gather(az);
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (!isInner(n)) continue;
    int cell = levelCell(placeOf(n));
    float value = cells[n].inverse > 0.0 ? az[n] - cells[n].d / cells[n].inverse : 0.0;
    applied[cell] = value;
    sums[0] += cells[n].b * value;
    sums[1] += value * value;
    sums[3] += cells[n].b * cells[n].b;
    if (control.cycles > 0u) sums[2] += value * lastApplied[halfOf(control.cycles) + cell];
  }
}

void endCycle(float sums[SUM_COUNT]) {
  float beta = control.cycles > 0u ? sums[2] / control.size : 0.0;
  float size = sums[1] - (control.cycles > 0u ? beta * beta * control.size : 0.0);
  bool useful = size > 0.0;
  float alpha = useful ? sums[0] / size : 0.0;
  control.beta = beta;
  control.size = size;
  control.alpha = alpha;
  // From r . r of this cycle: subtracted cycle by cycle, the first one's rounding would hide the last one's residual.
  control.flux = max(sums[3] - alpha * sums[0], 0.0) * wind.perAir;
  control.cycles += 1u;
  if (useful && control.flux > control.wanted) return;
  control.converged = 1u;
  setDispatches(false, false);
}
#endif

void main() {
  for (int n = 0; n < WIND_STRIP; ++n) {
    ivec2 place = wrappedPlace(n);
    loadStencil(n, place);
    bool there = place.x >= 0;
#ifdef LEVEL0
    cells[n].b = there ? residualOf(control.cycles, levelCell(place)) : 0.0;
#else
    cells[n].b = there ? flux[levelCell(place)] : 0.0;
#endif
    cells[n].d = cells[n].inverse > 0.0 ? dIn[levelCell(place)] + correctionAt(place) : 0.0;
  }
  findIrregular();
  publish();
  for (int m = WIND_GPU_SWEEPS - 1; m >= 0; --m) sweep(smoothingWeight(m));
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (isInner(n)) dOut[levelCell(placeOf(n))] = cells[n].d;
  }
#ifdef LEVEL0
  float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0, 0.0);
  measure(sums);
  if (joinAll(sums) && gl_LocalInvocationIndex == 0u) endCycle(sums);
#endif
}
