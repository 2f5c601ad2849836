// Shadow between blades without a shadow map, the same in C++ (tests) and GLSL: Choi & Sung, "CWD-Sim", 2024, eq. 14.
#ifndef WINDLOOM_SHARED_CANOPY_SHADE_H
#define WINDLOOM_SHARED_CANOPY_SHADE_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

/// c_f over c_t: `height` of the point over its root after bending, in blade lengths; `force` |F|; `shadow` holds m_min,
/// m_max, c1, c2. Low and pushed-down grass darkens, between m_min and m_max.
WL_FUNCTION float canopyShade(float height, float force, vec4 shadow) {
  float shade = height - force * shadow.z + shadow.w;
  shade = shade < shadow.y ? shade : shadow.y;
  return shade > shadow.x ? shade : shadow.x;
}

/// |F| as it darkens where blades keep their length: as the paper's in a weak wind, never over 1, so that a gale doesn't
/// turn the meadow black.
WL_FUNCTION float boundedForce(float force) { return force / (1.0f + force); }

WL_SHARED_END
#endif
