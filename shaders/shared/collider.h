// What touches the grass: a sphere or a capsule of a collider at a moment (std430).
#ifndef WINDLOOM_SHARED_COLLIDER_H
#define WINDLOOM_SHARED_COLLIDER_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using glm::dot;
using glm::length;
using std::max;
using std::min;
#endif

/// All within the radius of the straight line from a to b; a sphere where both are equal.
struct ColliderPrimitive {
  vec4 a;  // xyz m in the world; w radius, m
  vec4 b;  // xyz m in the world; w unused, 0
};

/// The place on the line from a to b that is nearest to `point`.
WL_FUNCTION vec3 colliderAxis(ColliderPrimitive primitive, vec3 point) {
  vec3 a = vec3(primitive.a);
  vec3 way = vec3(primitive.b) - a;
  float along = dot(vec3(point - a), way) / max(dot(way, way), 1e-12f);
  return a + way * min(max(along, 0.0f), 1.0f);
}

/// m from `point` to the surface; negative inside.
WL_FUNCTION float colliderDistance(ColliderPrimitive primitive, vec3 point) {
  return length(vec3(point - colliderAxis(primitive, point))) - primitive.a.w;
}

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::ColliderPrimitive) == 32, "std430 layout");
#endif
#endif
