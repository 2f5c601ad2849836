// An obstacle as the renderers see it (std430).
#ifndef WINDLOOM_SHARED_SOLID_H
#define WINDLOOM_SHARED_SOLID_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

#define SOLID_CIRCLE 0.0f
#define SOLID_BOX 1.0f
#define SOLID_POLYGON 2.0f

struct Solid {
  vec4 place;  // centre x, z, half size along its own axes (circle: radius twice), m
  vec4 shape;  // cosine and sine of its rotation, height m, SOLID_*
  vec4 level;  // y of its foot and of its top, m; polygon: its first corner in the list of corners, how many
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::Solid) == 48, "std430 layout");
#endif
#endif
