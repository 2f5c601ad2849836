#version 450 core
// The way up of the pressure solve on one level: the sweep of the way down again and the coarser level's correction,
// then smooth. docs/solver.md section 6.
// LEVEL0: also finds A z, and what end_cycle.glsl must know of it.
#include "shaders/wind/region.glsl"

layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_COARSE) readonly buffer Coarse { float coarse[]; };
layout(std430, binding = WIND_SSBO_COARSE_FACES) readonly buffer CoarseFaces { uint coarseFaces[]; };
#ifdef LEVEL0
layout(std430, binding = WIND_SSBO_APPLIED) buffer Applied { float applied[]; };
layout(std430, binding = WIND_SSBO_LAST_APPLIED) readonly buffer LastApplied { float lastApplied[]; };
#define SUM_COUNT 4
#define SUM_ADDED 4
#include "shaders/wind/sums.glsl"
#include "shaders/wind/halves.glsl"
uniform int cycle;  // which one of the solve, from 0
#endif

float coarseAt(int i, int k) { return coarse[k * level.coarseWidth + i]; }

// How far d rises from a coarse cell to its neighbour, as seen across a border: behind an open one lies d = 0 on the
// border itself, behind a wall the same again.
float riseAcross(int border, float own) { return border == WIND_BORDER_OPEN ? -2.0 * own : 0.0; }

// The quarter of the way from a coarse cell's centre to its neighbour's on which a fine cell's centre lies, as far as
// the face between them is open.
float riseAlongX(ivec2 c, bool high, float own) {
  int n = high ? c.x + 1 : c.x - 1;
  float share = min(facesOf(coarseFaces[c.y * (level.coarseWidth + 1) + (high ? n : c.x)]).x, 1.0);
  if (n >= 0 && n < level.coarseWidth) return 0.25 * share * (coarseAt(n, c.y) - own);
  if (level.xMin != WIND_BORDER_PERIODIC) return 0.25 * riseAcross(high ? level.xMax : level.xMin, own);
  return 0.25 * share * (coarseAt(high ? 0 : level.coarseWidth - 1, c.y) - own);
}
float riseAlongZ(ivec2 c, bool high, float own) {
  int n = high ? c.y + 1 : c.y - 1;
  float share = min(facesOf(coarseFaces[(high ? n : c.y) * (level.coarseWidth + 1) + c.x]).y, 1.0);
  if (n >= 0 && n < level.coarseHeight) return 0.25 * share * (coarseAt(c.x, n) - own);
  if (level.zMin != WIND_BORDER_PERIODIC) return 0.25 * riseAcross(high ? level.zMax : level.zMin, own);
  return 0.25 * share * (coarseAt(c.x, high ? 0 : level.coarseHeight - 1) - own);
}

float correctionAt(ivec2 place) {
  ivec2 c = ivec2(level.factorX > 1 ? place.x >> 1 : place.x, level.factorZ > 1 ? place.y >> 1 : place.y);
  float own = coarseAt(c.x, c.y);
  float sum = own;
  if (level.factorX > 1) sum += riseAlongX(c, (place.x & 1) != 0, own);
  if (level.factorZ > 1) sum += riseAlongZ(c, (place.y & 1) != 0, own);
  return sum;
}

// Whether coarsening goes by two along both axes, and no cell of the next level is cut short by a periodic border.
bool coarsensEvenly() {
  bool wholeX = level.xMin != WIND_BORDER_PERIODIC || level.width == 2 * level.coarseWidth;
  bool wholeZ = level.zMin != WIND_BORDER_PERIODIC || level.height == 2 * level.coarseHeight;
  return level.factorX == 2 && level.factorZ == 2 && wholeX && wholeZ;
}

// The correction of a strip in a plain region: each coarse row of its column and of the column beside it is read once.
void correctStrip(out float corrections[WIND_STRIP]) {
  const int kRows = WIND_STRIP / 2;
  ivec2 place = placeOf(0);
  int at = (place.y >> 1) * level.coarseWidth + (place.x >> 1);
  int side = (place.x & 1) != 0 ? 1 : -1;
  float own[kRows + 2], beside[kRows];
  for (int r = 0; r < kRows + 2; ++r) own[r] = coarse[at + (r - 1) * level.coarseWidth];
  for (int r = 0; r < kRows; ++r) beside[r] = coarse[at + r * level.coarseWidth + side];
  for (int r = 0; r < kRows; ++r) {
    float here = own[r + 1], base = here + 0.25 * (beside[r] - here);
    corrections[2 * r] = base + 0.25 * (own[r] - here);
    corrections[2 * r + 1] = base + 0.25 * (own[r + 2] - here);
  }
}

#ifdef LEVEL0
// The products r . A z, A z . A z, A z . A p and r . r of the inner cells; stores A z.
void measure(const bool plain, inout float sums[SUM_COUNT]) {
  float az[WIND_STRIP];
  gather(plain, az);
  float diagonal = 2.0 * (level.scaleX + level.scaleZ);
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (!isInner(plain, n)) continue;
    float own = plain ? cells[n].d * diagonal : cells[n].inverse > 0.0 ? cells[n].d / cells[n].inverse : 0.0;
    float value = plain || cells[n].inverse > 0.0 ? az[n] - own : 0.0;
    applied[found[n]] = value;
    sums[0] += cells[n].b * value;
    sums[1] += value * value;
    sums[3] += cells[n].b * cells[n].b;
    if (cycle > 0) sums[2] += value * lastApplied[halfOf(uint(cycle)) + found[n]];
  }
}

#endif

#ifdef LEVEL0
float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0, 0.0);
#endif

void run(const bool plain) {
  locate(plain);
  for (int n = 0; n < WIND_STRIP; ++n) {
#ifdef LEVEL0
    cells[n].b = isThere(plain, n) ? residualOf(uint(cycle), found[n]) : 0.0;
#else
    cells[n].b = isThere(plain, n) ? flux[found[n]] : 0.0;
#endif
  }
  if (plain) {
    float corrections[WIND_STRIP];
    correctStrip(corrections);
    for (int n = 0; n < WIND_STRIP; ++n) cells[n].d = afterFirstSweep(n, WIND_SMOOTH_DOWN) + corrections[n];
  } else {
    for (int n = 0; n < WIND_STRIP; ++n) {
      // Read for every cell, so that nothing waits for what is known of the cell before.
      float correction = correctionAt(max(wrappedPlace(n), ivec2(0)));
      cells[n].d = cells[n].inverse > 0.0 ? afterFirstSweep(n, WIND_SMOOTH_DOWN) + correction : 0.0;
    }
  }
  publish();
  for (int m = WIND_SWEEPS_UP - 1; m >= 0; --m) sweep(plain, smoothingWeight(m));
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (isInner(plain, n)) dOut[found[n]] = cells[n].d;
  }
#ifdef LEVEL0
  measure(plain, sums);
#endif
}

void main() {
  if (isPlainRegion()) {
    run(true);
  } else {
    run(false);
  }
#ifdef LEVEL0
  deliver(sums);
#endif
}
