// One copy of the cyclic gust table as the solver adds it up at a moment (std140 and std430, 32 bytes).
// Position p (m) maps to texel coordinates (dot(p, axis), dot(p, perp)) * texelsPerMetre + offset with
// perp = (-axis.y, axis.x); texel (i, k) holds the value at coordinates exactly (i, k), the table wraps. The sample
// (a, b), bilinear, adds weight * (a * axis + b * perp).
#ifndef WINDLOOM_SHARED_WIND_GUST_H
#define WINDLOOM_SHARED_WIND_GUST_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

struct WindGustLayer {
  vec2 axis;
  vec2 offset;
  float texelsPerMetre;
  float weight;
  vec2 padding;
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::WindGustLayer) == 32, "std430 layout");
#endif
#endif
