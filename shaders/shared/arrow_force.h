// One arrow of the wind graph as the solver sees it at a moment (std430, 48 bytes).
#ifndef WINDLOOM_SHARED_ARROW_FORCE_H
#define WINDLOOM_SHARED_ARROW_FORCE_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

#define ARROW_DRIVE_SPEED 0u
#define ARROW_DRIVE_FORCE 1u

struct ArrowForce {
  vec2 from;       // m; start of the capsule. Equals `to` for a disc around the end point
  vec2 to;         // m
  vec2 direction;  // unit vector along the arrow
  float radius;    // m; influence is exp(-2 d^2 / radius^2) for distance d < radius, 0 beyond
  float strength;  // m/s (speed) or m/s^2 (force), the signal's factor applied
  float response;  // s (speed): the rate of approach is 1 / response
  float swirl;     // m/s around `to`, the signal's factor applied
  uint drive;      // ARROW_DRIVE_*
  float factor;    // the signal's factor alone
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::ArrowForce) == 48, "std430 layout");
#endif
#endif
