// One mark of the overlay: an arrow, a point, a probe or an outline (std430).
#ifndef WINDLOOM_SHARED_OVERLAY_MARK_H
#define WINDLOOM_SHARED_OVERLAY_MARK_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

#define MARK_NORMAL 0.0f
#define MARK_HOVERED 1.0f
#define MARK_SELECTED 2.0f

#define MARK_POINT 0.0f
#define MARK_ROOT 1.0f
#define MARK_PROBE 2.0f

struct OverlayMark {
  vec4 place;  // arrow: from x, z, to x, z, m. Point, probe: x, z, unused, MARK_POINT...; outline: as
               // Solid::place; one side of a polygon: from x, z, to x, z
  vec4 look;   // arrow: radius m, place in the speed map 0..1, factor of its signal, MARK_NORMAL...
               // point, probe: unused, unused, unused, state; outline: cosine, sine, height, state
  vec4 more;   // arrow: where its area begins (0 along, 1 at its end), 1 where muted, s its signal took so far, unused.
               // outline: SOLID_*
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::OverlayMark) == 48, "std430 layout");
#endif
#endif
