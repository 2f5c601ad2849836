// Bezier grass as its passes see it: blades, their states, patches (std430). Jahrmann & Wimmer, "Responsive real-time grass
// rendering", 2017; a blade is a quadratic Bezier curve of v0 (root), v1 and v2 (tip). What forces
// moved is the tip; eq. 9 to 13 (bezierValid in bezier_pose.h) make a curve of it wherever it is read, so a state is the tip
// alone: 32 bytes of shape and 16 of state a blade, where the paper has 64.
#ifndef WINDLOOM_SHARED_BEZIER_BLADE_H
#define WINDLOOM_SHARED_BEZIER_BLADE_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

// Blades of a patch, which a work-group looks after. A patch is compact in space; any first part of its blades covers it
// evenly, so that few are drawn from afar by drawing the first ones. Patches stand in Morton order.
#define BEZIER_PATCH 256u
#define BEZIER_FORM_QUAD 0u
#define BEZIER_FORM_TRIANGLE 1u
#define BEZIER_FORM_QUADRATIC 2u
#define BEZIER_FORM_TRIANGLE_TIP 3u
#define BEZIER_FORM_DANDELION 4u

/// What of a blade never changes.
struct BezierBlade {
  float x;      // v0, m in the world
  float y;
  float z;
  uint up;      // snorm2x16: octahedral unit vector (bezier_pose.h)
  uint sizes;   // half2: height m (0: no blade, fills up a patch), width m
  uint growth;  // low half: stiffness over the mean one; high unorm16: direction, of a turn (bezier_pose.h)
  uint look;    // unorm8: dryness, half the brightness, hue from -1..1; high 8 bits: BEZIER_FORM_*
  uint seed;    // random, fills up to 32 bytes
};

/// What of a blade changes.
struct BezierState {
  vec4 tip;  // xyz v2 - v0 before eq. 9 to 13, m; w collision strength eta
};

/// 256 blades, the last ones of height 0 where there are not enough; patch i has blades from 256 i on.
struct BezierPatch {
  vec4 centre;  // xyz m: middle of the box that its blades stay in however they move; w blades
  vec4 reach;   // xyz m: half its size; w index of its surface, -1: the ground
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::BezierBlade) == 32, "std430 layout");
static_assert(sizeof(windloom::shared::BezierState) == 16, "std430 layout");
static_assert(sizeof(windloom::shared::BezierPatch) == 32, "std430 layout");
#endif
#endif
