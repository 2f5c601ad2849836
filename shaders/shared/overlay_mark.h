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
  vec4 place;   // arrow: from x, z, to x, z, m. Point, probe: x, z, hub radius m, MARK_POINT...; outline: as
                // Solid::place; one side of a polygon: from x, z, to x, z
  vec4 look;    // arrow: radius m, strength, 1 where muted, MARK_NORMAL...
                // point, probe: unused, unused, unused, state; outline: cosine, sine, height m, state
  vec4 more;    // arrow: where its area begins (0 along, 1 at its end), hub radius m at its start and at its end,
                // its travel speed, m/s. Outline: SOLID_*, centre x, z of a polygon
  vec4 signal;  // arrow: place of its start in the table of signal levels, entries from there to its end
};

#define ARROW_RISE 0.3f  // of its ridge over its edges, of half its width

/// Half of the width an arrow is drawn with, m.
WL_FUNCTION float arrowHalfWidth(float radius) {
  float wide = 0.15f * radius;
  return wide < 0.12f ? 0.12f : wide > 0.9f ? 0.9f : wide;
}

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::OverlayMark) == 64, "std430 layout");
#endif
#endif
