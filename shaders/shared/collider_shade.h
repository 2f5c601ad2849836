// Spheres that take light from the grass and ground around colliders and surfaces (std140).
#ifndef WINDLOOM_SHARED_COLLIDER_SHADE_H
#define WINDLOOM_SHARED_COLLIDER_SHADE_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

#define COLLIDER_SHADE_SPHERES 64

struct ColliderShadeBlock {
  vec4 low;   // xyz m: no light is taken outside these bounds; w how many spheres
  vec4 high;  // xyz m; w how many of them are colliders, which come first
  vec4 spheres[COLLIDER_SHADE_SPHERES];  // centre and radius, m
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::ColliderShadeBlock) == 32 + COLLIDER_SHADE_SPHERES * 16, "std140 layout");
#endif
#endif
