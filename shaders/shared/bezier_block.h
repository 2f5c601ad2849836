// What the passes that cull and draw Bezier grass share: settings (std140), records and counts (std430).
#ifndef WINDLOOM_SHARED_BEZIER_BLOCK_H
#define WINDLOOM_SHARED_BEZIER_BLOCK_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

// Strips of falling detail, and two for dandelions.
#define BEZIER_LISTS 6u
#define BEZIER_DANDELION_LIST 4u
// Blades that an instance draws.
#define BEZIER_CHUNK 8u
// In a list: a blade for which there was no room.
#define BEZIER_NO_RECORD 0xffffffffu
// Patches that a work-group of the patch culling looks at.
#define BEZIER_CULL_GROUP 64u

// Steps of distance in which patches are ordered, near ones first.
#define BEZIER_BUCKETS 32u

// GrassView of engine/grass/bezier_view.hpp.
#define BEZIER_VIEW_NORMAL 0.0f
#define BEZIER_VIEW_PATCHES 1.0f
#define BEZIER_VIEW_CULLED 2.0f
#define BEZIER_VIEW_STRENGTH 3.0f

// Places in BezierCommands::counts.
#define BEZIER_COUNT_ORIENTATION 0u
#define BEZIER_COUNT_FRUSTUM 1u
#define BEZIER_COUNT_DISTANCE 2u
#define BEZIER_COUNT_OCCLUSION 3u
#define BEZIER_COUNT_DRAWN 4u
#define BEZIER_COUNT_IN_PATCHES 5u
#define BEZIER_COUNT_PATCHES 6u
#define BEZIER_COUNT_BURIED 7u

struct BezierBlock {
  vec4 shape;    // x tau; y fold; z w_min, w w_span of eq. 24, pixels
  vec4 cull;     // x orientation limit; y reach m; z distance levels; w pixels under which blades are thinned, 0: never
  vec4 tests;    // 1 where the test runs: orientation, frustum, distance, occlusion
  vec4 patches;  // x patches; y blades of each that are shown; z widening for those that are not; w 1: only patches in sight
  vec4 levels;   // x, y, z blade heights in pixels from which lists 0, 1, 2 are drawn; w from which a patch is drawn first
  vec4 view;     // x BEZIER_VIEW_*; y records that fit; z part of a patch with small blades that is drawn first; w unused
};

/// A blade ready to be drawn.
struct BezierDrawn {
  float x;      // v0, m in the world
  float y;
  float z;
  uint up;      // as BezierBlade
  uint tip;     // half2: x, y of v2 - v0, m
  uint curve;   // half2: z of v2 - v0; v1 - v0 along up, m
  uint sizes;   // half2: height, width, m
  uint growth;  // as BezierBlade
  uint look;    // as BezierBlade
  uint shade;   // half2: height of the shadow over the root, m; |F| of eq. 14
  uint light;   // unorm4: half the brightness with the slope's light; openness; half the height of the canopy around it over its own;
                // how closed that is
  uint foot;    // unorm4: its colour in the picture from afar at the foot
  uint top;     // unorm4: the same at the tip
};

struct BezierCommands {
  uint groupsNear[4];  // glDispatchComputeIndirect over the patches drawn first
  uint groupsFar[4];   // and over the others
  uint counts[8];      // BEZIER_COUNT_*
  uint records;
  uint unused[3];
  uint starts[8];      // where each list begins in this round
  uint ends[8];        // and ends
  uint draws[40];      // glDrawElementsIndirect: 5 for each list, this round's
  uint buckets[64];    // patches in each step of distance: those of the first round, then those of the other
  uint taken[64];      // of them, listed
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::BezierBlock) == 6 * 16, "std140 layout");
static_assert(sizeof(windloom::shared::BezierDrawn) == 52, "std430 layout");
static_assert(sizeof(windloom::shared::BezierCommands) == 4 * (4 + 4 + 8 + 4 + 8 + 8 + 40 + 64 + 64), "std430 layout");
#endif
#endif
