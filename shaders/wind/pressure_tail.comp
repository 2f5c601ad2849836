#version 450 core
// All small levels of the pressure solve in one work-group: the rest of a V-cycle, down and up. docs/solver.md section
// 6. Everything that is read more than once is fetched at the start, since a look into the GPU's memory takes longer
// than a sweep.
// START: also ends the flux pass.
// TAIL_CELLS, TAIL_FIRST, TAIL_NODES: cells of all levels, cells of the first one, nodes of all but the first one.
// TAIL_STRIDES: cells of the first level per invocation. TAIL_LAST: cells of the last level, which is solved exactly.
#include "shaders/wind/block.glsl"
#include "shaders/wind/level_faces.glsl"

layout(local_size_x = WIND_TAIL_GROUP) in;
layout(std430, binding = WIND_SSBO_FACES) readonly buffer Faces { uint faces[]; };
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };

layout(std430, binding = WIND_SSBO_DENSE) readonly buffer Dense { float lastInverse[]; };

shared float dense[max(TAIL_LAST * TAIL_LAST, 4 * WIND_TAIL_GROUP)], lastRhs[TAIL_LAST];

#ifdef START
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#define GROUP_SIZE WIND_TAIL_GROUP
#define scratch dense  // no longer needed then
#include "shaders/wind/start_solve.glsl"
#define levels allLevels
#else
layout(std140, binding = WIND_UBO_LEVELS) uniform LevelsBlock { WindLevel levels[WIND_MAX_LEVELS]; };
#endif

shared uint nodes[TAIL_NODES];
shared float d[TAIL_CELLS + 1];                 // the last one is the 0 of what lies outside
shared float rhs[TAIL_CELLS - TAIL_FIRST + 1];  // of all levels but the first
float firstRhs[TAIL_STRIDES];
uvec3 firstNodes[TAIL_STRIDES];  // a cell's own, the next along x, the next along z

// This invocation's cells of the level at hand.
struct Stencil {
  float xLow, xHigh, zLow, zHigh, inverse, b;
  int left, right, below, above;  // where the neighbours' d stand
};
Stencil stencils[TAIL_STRIDES];

int cellOf(int n) { return int(gl_LocalInvocationIndex) + n * WIND_TAIL_GROUP; }
int countOf(WindLevel l) { return l.width * l.height; }

int neighbourAt(int at, int c, int count, int step, bool high, bool periodic) {
  int next = high ? c + 1 : c - 1;
  if (next >= 0 && next < count) return high ? at + step : at - step;
  if (!periodic) return TAIL_CELLS;
  return high ? at - (count - 1) * step : at + (count - 1) * step;
}

void takeLevel(WindLevel l) {
  bool first = l.cells == 0;
  bool wrapX = l.xMin == WIND_BORDER_PERIODIC, wrapZ = l.zMin == WIND_BORDER_PERIODIC;
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    int cell = cellOf(n);
    if (cell >= countOf(l)) break;
    int k = cell / l.width, i = cell - k * l.width;
    int node = l.faces + k * (l.width + 1) + i;
    int at = l.cells + cell;
    uvec3 links = first ? firstNodes[n] : uvec3(nodes[node], nodes[node + 1], nodes[node + l.width + 1]);
    vec2 low = facesOf(links.x) * vec2(l.scaleX, l.scaleZ);
    float xHigh = facesOf(links.y).x * l.scaleX, zHigh = facesOf(links.z).y * l.scaleZ;
    float b = first ? firstRhs[n] : rhs[at - TAIL_FIRST];
    stencils[n] = Stencil(low.x, xHigh, low.y, zHigh, inverseOf((low.x + xHigh) + (low.y + zHigh)), b,
                          neighbourAt(at, i, l.width, 1, false, wrapX), neighbourAt(at, i, l.width, 1, true, wrapX),
                          neighbourAt(at, k, l.height, l.width, false, wrapZ),
                          neighbourAt(at, k, l.height, l.width, true, wrapZ));
  }
}

float neighbours(int n) {
  Stencil s = stencils[n];
  return (s.xLow * d[s.left] + s.xHigh * d[s.right]) + (s.zLow * d[s.below] + s.zHigh * d[s.above]);
}

float afterFirstSweep(int n) { return -WIND_SMOOTH_DOWN * stencils[n].b * stencils[n].inverse; }

// The way down: what the first sweep leaves, summed over the cells of the next level. `d` holds the residuals
// meanwhile.
void goDown(WindLevel l, WindLevel next) {
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) < countOf(l)) d[l.cells + cellOf(n)] = afterFirstSweep(n);
  }
  barrier();
  float left[TAIL_STRIDES];
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) >= countOf(l)) break;
    left[n] = stencils[n].inverse > 0.0 ? (1.0 - WIND_SMOOTH_DOWN) * stencils[n].b - neighbours(n) : 0.0;
  }
  barrier();
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) < countOf(l)) d[l.cells + cellOf(n)] = left[n];
  }
  barrier();
  for (int cell = int(gl_LocalInvocationIndex); cell < countOf(next); cell += WIND_TAIL_GROUP) {
    int k = cell / next.width, i = cell - k * next.width;
    int iEnd = min((i + 1) * l.factorX, l.width), kEnd = min((k + 1) * l.factorZ, l.height);
    float sum = 0.0;
    for (int b = k * l.factorZ; b < kEnd; ++b) {
      for (int a = i * l.factorX; a < iEnd; ++a) sum += d[l.cells + b * l.width + a];
    }
    rhs[next.cells - TAIL_FIRST + cell] = sum;
  }
  barrier();
}

void sweep(WindLevel l, float weight) {
  float next[TAIL_STRIDES];
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) >= countOf(l)) break;
    float own = d[l.cells + cellOf(n)];
    next[n] = own + weight * ((neighbours(n) - stencils[n].b) * stencils[n].inverse - own);
  }
  barrier();
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) < countOf(l)) d[l.cells + cellOf(n)] = next[n];
  }
  barrier();
}

// How far d rises from the coarse cell `own` towards its neighbour on the fine cell's side. `at`, `node`: of the coarse
// cell; the face crossed is the node's, or that of the next node along the axis.
float riseAlong(int c, bool high, int count, int at, int step, float share, int lowBorder, int highBorder, float own) {
  int next = high ? c + 1 : c - 1;
  bool inside = next >= 0 && next < count;
  if (!inside && lowBorder != WIND_BORDER_PERIODIC) {
    return (high ? highBorder : lowBorder) == WIND_BORDER_OPEN ? -0.5 * own : 0.0;
  }
  return 0.25 * min(share, 1.0) * (d[neighbourAt(at, c, count, step, high, true)] - own);
}

void goUp(WindLevel l, WindLevel next) {
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    int cell = cellOf(n);
    if (cell >= countOf(l)) break;
    if (stencils[n].inverse <= 0.0) {
      d[l.cells + cell] = 0.0;
      continue;
    }
    int k = cell / l.width, i = cell - k * l.width;
    int ci = i / l.factorX, ck = k / l.factorZ;
    int at = next.cells + ck * next.width + ci, node = next.faces + ck * (next.width + 1) + ci;
    bool highX = (i & 1) != 0, highZ = (k & 1) != 0;
    float own = d[at], sum = own;
    float shareX = facesOf(nodes[highX ? node + 1 : node]).x;
    float shareZ = facesOf(nodes[highZ ? node + next.width + 1 : node]).y;
    if (l.factorX > 1) sum += riseAlong(ci, highX, next.width, at, 1, shareX, l.xMin, l.xMax, own);
    if (l.factorZ > 1) sum += riseAlong(ck, highZ, next.height, at, next.width, shareZ, l.zMin, l.zMax, own);
    d[l.cells + cell] = afterFirstSweep(n) + sum;
  }
  barrier();
  for (int m = WIND_SWEEPS_UP - 1; m >= 0; --m) sweep(l, smoothingWeight(m));
}

void solveLast(int firstCell) {
  int row = int(gl_LocalInvocationIndex);
  if (row < TAIL_LAST) lastRhs[row] = stencils[0].b;
  barrier();
  if (row < TAIL_LAST) {
    float sum = 0.0;
    for (int n = 0; n < TAIL_LAST; ++n) sum += dense[n * TAIL_LAST + row] * lastRhs[n];
    d[firstCell + row] = sum;
  }
  barrier();
}

void main() {
  int first = wind.ownLevels, last = wind.allLevels - 1;
  int width = levels[first].width, firstCount = (width + 1) * (levels[first].height + 1);
  for (int n = int(gl_LocalInvocationIndex); n < TAIL_NODES; n += WIND_TAIL_GROUP) nodes[n] = faces[firstCount + n];
  for (int n = int(gl_LocalInvocationIndex); n < TAIL_LAST * TAIL_LAST; n += WIND_TAIL_GROUP) dense[n] = lastInverse[n];
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) >= TAIL_FIRST) break;
    int node = cellOf(n) + cellOf(n) / width;  // a row has one node more than cells
    firstNodes[n] = uvec3(faces[node], faces[node + 1], faces[node + width + 1]);
    firstRhs[n] = flux[cellOf(n)];
  }
  if (gl_LocalInvocationIndex == 0u) d[TAIL_CELLS] = 0.0;
  barrier();
  for (int l = first; l < last; ++l) {
    takeLevel(levels[l]);
    goDown(levels[l], levels[l + 1]);
  }
  takeLevel(levels[last]);
  solveLast(levels[last].cells);
  for (int l = last - 1; l >= first; --l) {
    takeLevel(levels[l]);
    goUp(levels[l], levels[l + 1]);
  }
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) < countOf(levels[first])) dOut[cellOf(n)] = d[levels[first].cells + cellOf(n)];
  }
#ifdef START
  startSolve();
#endif
}
