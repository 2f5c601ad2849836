#version 450 core
// All small levels of the pressure solve in one work-group: the rest of a V-cycle, down and up. docs/solver.md section
// 6.
// TAIL_CELLS, TAIL_RHS, TAIL_RESIDUALS: floats of shared memory for d, for b of all levels but the first, for
// residuals.
// TAIL_STRIDES: cells of the first level per invocation.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_TAIL_GROUP) in;
layout(std140, binding = WIND_UBO_LEVELS) uniform LevelsBlock { WindLevel levels[WIND_MAX_LEVELS]; };
layout(std430, binding = WIND_SSBO_FACES) readonly buffer Faces { vec4 faces[]; };
layout(std430, binding = WIND_SSBO_INVERSE) readonly buffer Inverse { float inverseDiagonal[]; };
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };
layout(std430, binding = WIND_SSBO_D_OUT) writeonly buffer DOut { float dOut[]; };

shared float d[TAIL_CELLS];
shared float rhs[TAIL_RHS];
shared float residual[TAIL_RESIDUALS];

// This invocation's cells of the level at hand.
struct Stencil {
  float xLow, xHigh, zLow, zHigh, inverse, b;
  int left, right, below, above;  // where the neighbours' d stand
};
Stencil stencils[TAIL_STRIDES];

int cellOf(int n) { return int(gl_LocalInvocationIndex) + n * WIND_TAIL_GROUP; }
int countOf(WindLevel l) { return l.width * l.height; }

void loadLevel(WindLevel l) {
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    int cell = cellOf(n);
    if (cell >= countOf(l)) break;
    int k = cell / l.width, i = cell - k * l.width;
    int node = l.faces + k * (l.width + 1) + i;
    int at = l.cells + cell;
    vec4 own = faces[node];
    float xHigh = faces[node + 1].x, zHigh = faces[node + l.width + 1].y;
    float b = l.rhs < 0 ? flux[cell] : rhs[l.rhs + cell];
    int around = l.width * (l.height - 1);  // from the first row to the last
    stencils[n] = Stencil(own.x, xHigh, own.y, zHigh, inverseDiagonal[at], b,
                          i > 0 ? at - 1 : at + l.width - 1, i < l.width - 1 ? at + 1 : at - l.width + 1,
                          k > 0 ? at - l.width : at + around, k < l.height - 1 ? at + l.width : at - around);
  }
}

float neighbours(int n) {
  Stencil s = stencils[n];
  return (s.xLow * d[s.left] + s.xHigh * d[s.right]) + (s.zLow * d[s.below] + s.zHigh * d[s.above]);
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

float smoothingWeight(int m) {
  const float middle = 0.5 * (2.0 + WIND_SMOOTH_FROM), reach = 0.5 * (2.0 - WIND_SMOOTH_FROM);
  return 1.0 / (middle + reach * cos(3.14159265 * float(2 * m + 1) / float(2 * WIND_GPU_SWEEPS)));
}

void smoothFromZero(WindLevel l) {
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) < countOf(l)) d[l.cells + cellOf(n)] = -smoothingWeight(0) * stencils[n].b * stencils[n].inverse;
  }
  barrier();
  for (int m = 1; m < WIND_GPU_SWEEPS; ++m) sweep(l, smoothingWeight(m));
}

void restrictResidual(WindLevel l, WindLevel next) {
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    int cell = cellOf(n);
    if (cell >= countOf(l)) break;
    float inverse = stencils[n].inverse;
    residual[cell] = inverse > 0.0 ? stencils[n].b - (neighbours(n) - d[l.cells + cell] / inverse) : 0.0;
  }
  barrier();
  for (int cell = int(gl_LocalInvocationIndex); cell < countOf(next); cell += WIND_TAIL_GROUP) {
    int k = cell / next.width, i = cell - k * next.width;
    int iEnd = min((i + 1) * l.factorX, l.width), kEnd = min((k + 1) * l.factorZ, l.height);
    float sum = 0.0;
    for (int b = k * l.factorZ; b < kEnd; ++b) {
      for (int a = i * l.factorX; a < iEnd; ++a) sum += residual[b * l.width + a];
    }
    rhs[next.rhs + cell] = sum;
  }
  barrier();
}

// Interpolation along one axis from the coarse cell `own` towards its neighbour on the fine cell's side.
float slope(int c, int factor, int coarse, int count, int low, int high, int step, int face, int faceStep, float own,
            bool alongX) {
  if (factor == 1) return 0.0;
  float offset = (float(c % factor) + 0.5) / float(factor) - 0.5;
  int index = c / factor;
  int other = offset > 0.0 ? index + 1 : index - 1;
  vec4 crossed = faces[face + (offset > 0.0 ? faceStep : 0)];
  float beyond;
  if (other >= 0 && other < count) {
    beyond = d[coarse + (other - index) * step];
  } else if (low == WIND_BORDER_PERIODIC) {
    beyond = d[coarse + (other < 0 ? count - 1 : 1 - count) * step];
  } else {
    beyond = (other < 0 ? low : high) == WIND_BORDER_OPEN ? -own : own;
  }
  return abs(offset) * (alongX ? crossed.z : crossed.w) * (beyond - own);
}

void prolong(WindLevel l, WindLevel next) {
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    int cell = cellOf(n);
    if (cell >= countOf(l)) break;
    if (stencils[n].inverse <= 0.0) continue;
    int k = cell / l.width, i = cell - k * l.width;
    int ci = i / l.factorX, ck = k / l.factorZ;
    int coarse = next.cells + ck * next.width + ci;
    int face = next.faces + ck * (next.width + 1) + ci;
    float own = d[coarse];
    float x = slope(i, l.factorX, coarse, next.width, l.xMin, l.xMax, 1, face, 1, own, true);
    float z = slope(k, l.factorZ, coarse, next.height, l.zMin, l.zMax, next.width, face, next.width + 1, own, false);
    d[l.cells + cell] += own + x + z;
  }
  barrier();
}

void main() {
  int first = wind.ownLevels, last = wind.allLevels - 1;
  for (int l = first; l < last; ++l) {
    loadLevel(levels[l]);
    smoothFromZero(levels[l]);
    restrictResidual(levels[l], levels[l + 1]);
  }
  loadLevel(levels[last]);
  if (gl_LocalInvocationIndex == 0u) d[levels[last].cells] = -stencils[0].b * stencils[0].inverse;
  barrier();
  for (int l = last - 1; l >= first; --l) {
    loadLevel(levels[l]);
    prolong(levels[l], levels[l + 1]);
    for (int m = WIND_GPU_SWEEPS - 1; m >= 0; --m) sweep(levels[l], smoothingWeight(m));
  }
  for (int n = 0; n < TAIL_STRIDES; ++n) {
    if (cellOf(n) < countOf(levels[first])) dOut[cellOf(n)] = d[levels[first].cells + cellOf(n)];
  }
}
