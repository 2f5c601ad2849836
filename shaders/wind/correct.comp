#version 450 core
// MacCormack's correction with the limiter (Selle, Fedkiw, Kim, Liu & Rossignac 2008). docs/solver.md section 4.
// SETTLE: this is the last pass before the projection.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_GROUP_X, local_size_y = WIND_GROUP_Z) in;
layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Velocity { float velocity[]; };
layout(std430, binding = WIND_SSBO_CARRIED) readonly buffer Carried { float carried[]; };
layout(std430, binding = WIND_SSBO_FIRST) readonly buffer First { float first[]; };
layout(std430, binding = WIND_SSBO_RESULT) writeonly buffer Result { float result[]; };
#ifdef SETTLE
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#include "shaders/wind/settle.glsl"
#endif

#include "shaders/wind/trace.glsl"

// q: the carried value at the face; from: its four corners where the air came from.
float corrected(float firstValue, float q, float returned, vec4 from, bool left) {
  float lowest = min(min(from.x, from.y), min(from.z, from.w));
  float highest = max(max(from.x, from.y), max(from.z, from.w));
  return left ? firstValue : clamp(firstValue + 0.5 * (q - returned), lowest, highest);
}

void main() {
  int i = int(gl_GlobalInvocationID.x), k = int(gl_GlobalInvocationID.y);
  bool hasU = i <= wind.width && k < wind.height, hasW = i < wind.width && k <= wind.height;
  uint bad = 0u;
  vec2 t;
  if (hasU) {
    int si = periodicX() && i == wind.width ? 0 : i;  // the last face of a periodic pair is the first one, to the bit
    vec2 place = vec2(si, float(k) + 0.5), own = velocityOnX(si, k);
    vec2 back = trace(place, own, -1.0), forth = trace(place, own, 1.0);
    int at = carriedU(back, t);
    vec4 from = CORNERS(carried, at);
    at = carriedU(forth, t);
    float returned = blend(CORNERS(first, at), t);
    float q = corrected(first[uAt(si, k)], carried[uAt(si, k)], returned, from, leftField(back) || leftField(forth));
#ifdef SETTLE
    q = settled(q, wind.ambient.x, openX(i, k), bad);
#endif
    result[uAt(i, k)] = q;
  }
  if (hasW) {
    int sk = periodicZ() && k == wind.height ? 0 : k;
    vec2 place = vec2(float(i) + 0.5, sk), own = velocityOnZ(i, sk);
    vec2 back = trace(place, own, -1.0), forth = trace(place, own, 1.0);
    int at = carriedW(back, t);
    vec4 from = CORNERS(carried, at);
    at = carriedW(forth, t);
    float returned = blend(CORNERS(first, at), t);
    float q = corrected(first[wAt(i, sk)], carried[wAt(i, sk)], returned, from, leftField(back) || leftField(forth));
#ifdef SETTLE
    q = settled(q, wind.ambient.y, openZ(i, k), bad);
#endif
    result[wAt(i, k)] = q;
  }
#ifdef SETTLE
  reportUnhealthy(i, k, bad);
#endif
}
