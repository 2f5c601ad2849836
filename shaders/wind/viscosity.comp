#version 450 core
// One Chebyshev sweep of the implicit viscosity (Varga 1962). docs/solver.md section 5.
// START: y = q with blocked faces 0, into both y arrays.  SETTLE: the last sweep, followed by what every face goes
// through.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_GROUP_X, local_size_y = WIND_GROUP_Z) in;
layout(std430, binding = WIND_SSBO_CARRIED) readonly buffer Carried { float rhs[]; };
layout(std430, binding = WIND_SSBO_FIRST) readonly buffer First { float current[]; };
layout(std430, binding = WIND_SSBO_RESULT) buffer Result { float next[]; };
#ifdef SETTLE
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#include "shaders/wind/settle.glsl"
#endif

#define WIND_COPY_OPEN
#define GHOST_TARGET next
#include "shaders/wind/ghosts.glsl"

uniform float relaxation;  // c of the sweep

float swept(int at) {
  float jacobi = (rhs[at] + wind.viscosityX * (current[at - 1] + current[at + 1]) +
                  wind.viscosityZ * (current[at - wind.stride] + current[at + wind.stride])) * wind.viscosityInverse;
  return next[at] + relaxation * (jacobi - next[at]);
}

void main() {
  int i = int(gl_GlobalInvocationID.x), k = int(gl_GlobalInvocationID.y);
  uint bad = 0u;
  if (i <= wind.width && k < wind.height) {
    int at = uAt(i, k);
    bool open = openX(i, k);
    bool moves = open && (periodicX() || (i > 0 && i < wind.width));
#ifdef START
    float y = rhs[at];
#else
    float y = moves ? swept(at) : next[at];
#endif
#ifdef SETTLE
    y = settled(y, wind.ambient.x, open, bad);
#endif
    storeU(i, k, open ? y : 0.0);
  }
  if (i < wind.width && k <= wind.height) {
    int at = wAt(i, k);
    bool open = openZ(i, k);
    bool moves = open && (periodicZ() || (k > 0 && k < wind.height));
#ifdef START
    float y = rhs[at];
#else
    float y = moves ? swept(at) : next[at];
#endif
#ifdef SETTLE
    y = settled(y, wind.ambient.y, open, bad);
#endif
    storeW(i, k, open ? y : 0.0);
  }
#ifdef SETTLE
  reportUnhealthy(i, k, bad);
#endif
}
