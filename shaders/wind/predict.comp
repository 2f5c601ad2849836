#version 450 core
// Semi-Lagrangian advection (Stam 1999): the field itself, or the first step of MacCormack's. docs/solver.md section 4.
// SETTLE: this is the last pass before the projection.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_GROUP_X, local_size_y = WIND_GROUP_Z) in;
layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Velocity { float velocity[]; };
layout(std430, binding = WIND_SSBO_CARRIED) readonly buffer Carried { float carried[]; };
layout(std430, binding = WIND_SSBO_FIRST) writeonly buffer First { float first[]; };
#ifdef SETTLE
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#include "shaders/wind/settle.glsl"
#endif

#define WIND_GHOSTS_OF_VELOCITY
#define GHOST_TARGET first
#include "shaders/wind/ghosts.glsl"
#include "shaders/wind/trace.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x), k = int(gl_GlobalInvocationID.y);
  bool hasU = i <= wind.width && k < wind.height, hasW = i < wind.width && k <= wind.height;
  uint bad = 0u;
  vec2 t;
  if (hasU) {
    int si = periodicX() && i == wind.width ? 0 : i;  // the last face of a periodic pair is the first one, to the bit
    int at = carriedU(trace(vec2(si, float(k) + 0.5), velocityOnX(si, k), -1.0), t);
    float q = blend(CORNERS(carried, at), t);
#ifdef SETTLE
    q = settled(q, wind.ambient.x, openX(i, k), bad);
#endif
    storeU(i, k, q);
  }
  if (hasW) {
    int sk = periodicZ() && k == wind.height ? 0 : k;
    int at = carriedW(trace(vec2(float(i) + 0.5, sk), velocityOnZ(i, sk), -1.0), t);
    float q = blend(CORNERS(carried, at), t);
#ifdef SETTLE
    q = settled(q, wind.ambient.y, openZ(i, k), bad);
#endif
    storeW(i, k, q);
  }
#ifdef SETTLE
  reportUnhealthy(i, k, bad);
#endif
}
