// Solids as shapes in the plane. Needs frame.glsl.
#include "shaders/shared/solid.h"
layout(std430, binding = RENDER_SSBO_SOLIDS) readonly buffer Solids { Solid solids[]; };

vec2 toSolid(Solid solid, vec2 v) {
  return vec2(solid.shape.x * v.x + solid.shape.y * v.y, -solid.shape.y * v.x + solid.shape.x * v.y);
}
vec2 fromSolid(Solid solid, vec2 v) {
  return vec2(solid.shape.x * v.x - solid.shape.y * v.y, solid.shape.y * v.x + solid.shape.x * v.y);
}

// m from the outline, negative inside.
float distanceToSolid(Solid solid, vec2 world) {
  vec2 local = toSolid(solid, world - solid.place.xy);
  if (solid.shape.w == SOLID_CIRCLE) return length(local) - solid.place.z;
  vec2 q = abs(local) - solid.place.zw;
  return length(max(q, vec2(0.0))) + min(max(q.x, q.y), 0.0);
}

// m along `direction` (unit) until the outline is met; negative: never.
float rayToSolid(Solid solid, vec2 world, vec2 direction) {
  if (distanceToSolid(solid, world) <= 0.0) return 0.0;
  vec2 p = toSolid(solid, world - solid.place.xy);
  vec2 d = toSolid(solid, direction);
  if (solid.shape.w == SOLID_CIRCLE) {
    float along = dot(p, d);
    float inside = along * along - dot(p, p) + solid.place.z * solid.place.z;
    return inside < 0.0 ? -1.0 : -along - sqrt(inside);
  }
  vec2 safe = mix(vec2(1e-6), d, greaterThan(abs(d), vec2(1e-6)));
  vec2 a = (-solid.place.zw - p) / safe;
  vec2 b = (solid.place.zw - p) / safe;
  float enter = max(min(a.x, b.x), min(a.y, b.y));
  float leave = min(max(a.x, b.x), max(a.y, b.y));
  return enter > leave ? -1.0 : enter;
}
