// Solids as shapes in the plane. Needs frame.glsl.
#include "shaders/shared/solid.h"
layout(std430, binding = RENDER_SSBO_SOLIDS) readonly buffer Solids { Solid solids[]; };
// Corners of polygons, m from their centres along their own axes.
layout(std430, binding = RENDER_SSBO_CORNERS) readonly buffer Corners { vec2 corners[]; };

vec2 toSolid(Solid solid, vec2 v) {
  return vec2(solid.shape.x * v.x + solid.shape.y * v.y, -solid.shape.y * v.x + solid.shape.x * v.y);
}
vec2 fromSolid(Solid solid, vec2 v) {
  return vec2(solid.shape.x * v.x - solid.shape.y * v.y, solid.shape.y * v.x + solid.shape.x * v.y);
}

vec2 cornerOf(Solid solid, int index) {
  int count = int(solid.level.w);
  return corners[int(solid.level.z) + (index < count ? index : 0)];
}

// To the nearest side; inside by the even-odd rule.
float distanceToPolygon(Solid solid, vec2 p) {
  float nearest = 1e30;
  bool inside = false;
  for (int i = 0; i < int(solid.level.w); ++i) {
    vec2 a = cornerOf(solid, i);
    vec2 side = cornerOf(solid, i + 1) - a;
    vec2 from = p - a - side * clamp(dot(p - a, side) / dot(side, side), 0.0, 1.0);
    nearest = min(nearest, dot(from, from));
    if ((a.y > p.y) != (a.y + side.y > p.y) && p.x < a.x + (p.y - a.y) / side.y * side.x) inside = !inside;
  }
  return inside ? -sqrt(nearest) : sqrt(nearest);
}

float rayToPolygon(Solid solid, vec2 p, vec2 d) {
  float nearest = 1e30;
  for (int i = 0; i < int(solid.level.w); ++i) {
    vec2 a = cornerOf(solid, i);
    vec2 side = cornerOf(solid, i + 1) - a;
    float across = d.x * side.y - d.y * side.x;
    if (abs(across) < 1e-9) continue;
    vec2 to = a - p;
    float along = (to.x * side.y - to.y * side.x) / across;
    float part = (to.x * d.y - to.y * d.x) / across;
    if (along >= 0.0 && part >= 0.0 && part <= 1.0) nearest = min(nearest, along);
  }
  return nearest < 1e29 ? nearest : -1.0;
}

// m from the outline, negative inside.
float distanceToSolid(Solid solid, vec2 world) {
  vec2 local = toSolid(solid, world - solid.place.xy);
  if (solid.shape.w == SOLID_CIRCLE) return length(local) - solid.place.z;
  if (solid.shape.w == SOLID_POLYGON) return distanceToPolygon(solid, local);
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
  if (solid.shape.w == SOLID_POLYGON) return rayToPolygon(solid, p, d);
  vec2 safe = mix(vec2(1e-6), d, greaterThan(abs(d), vec2(1e-6)));
  vec2 a = (-solid.place.zw - p) / safe;
  vec2 b = (solid.place.zw - p) / safe;
  float enter = max(min(a.x, b.x), min(a.y, b.y));
  float leave = min(max(a.x, b.x), max(a.y, b.y));
  return enter > leave ? -1.0 : enter;
}
