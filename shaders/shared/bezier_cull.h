// Which Bezier blades are left out, the same in C++ (tests) and GLSL. Jahrmann & Wimmer, 2017, eq. 17-20.
//
// Beyond the paper: a test doesn't switch a blade off but makes it narrower until it is gone, and blades too narrow to be
// seen for themselves are thinned; those that stay widen, so that the meadow covers as much from afar.
#ifndef WINDLOOM_SHARED_BEZIER_CULL_H
#define WINDLOOM_SHARED_BEZIER_CULL_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::clamp;
using glm::dot;
using glm::length;
using glm::smoothstep;
using std::abs;
using std::max;
using std::min;
#endif

// Over this part of the cosine below the limit a blade fades.
#define BEZIER_ORIENTATION_FADE 0.12f
// Blades under so many pixels' width are thinned: less would show at the picture's reference views (bench bezier).
#define BEZIER_THIN_PIXELS 0.9f
// Patches with blades higher than this, pixels, are drawn first and hide others; of the other patches this part of the
// blades, the highest ones, is.
#define BEZIER_FIRST_PIXELS 30.0f
#define BEZIER_FIRST_PART 0.35f
// Most widening of blades that stand for others.
#define BEZIER_MOST_WIDENING 5.0f

/// Eq. 17: part of its width that a blade keeps. `across` its unit width direction, `sight` the unit vector from the eye.
/// The blade is seen edge-on where both are one line. 0 from `limit` on; all with a limit of 1.
WL_FUNCTION float seenFromSide(vec3 across, vec3 sight, float limit) {
  if (limit >= 1.0f) return 1.0f;
  return 1.0f - smoothstep(limit - BEZIER_ORIENTATION_FADE, limit, abs(dot(across, sight)));
}

/// Eq. 18: whether a point lies in the clip volume widened by `tolerance`, in clip coordinates along x and y.
WL_FUNCTION bool insideClip(vec4 clip, vec2 tolerance) {
  return abs(clip.x) <= clip.w + tolerance.x && abs(clip.y) <= clip.w + tolerance.y && clip.z >= -clip.w - tolerance.y &&
         clip.z <= clip.w;
}

/// Eq. 19: the distance over the blade's ground, m.
WL_FUNCTION float distanceOverGround(vec3 root, vec3 up, vec3 eye) {
  vec3 to = root - eye;
  return length(vec3(to - up * dot(to, up)));
}

/// Part of the blades that is kept at a distance, before levels: eq. 20 without its steps, and fewer where a blade's width
/// covers less than `thin` pixels.
WL_FUNCTION float keptAtDistance(float distance, float reach, float pixels, float thin) {
  float kept = clamp(1.0f - distance / reach, 0.0f, 1.0f);
  return thin > 0.0f ? kept * clamp(pixels / thin, 0.0f, 1.0f) : kept;
}

/// Part of its width that the blade of `rank` (0..1 among its neighbours) has where a part `kept` is kept: blades of the
/// next of n levels are on their way in.
WL_FUNCTION float grownAtRank(float rank, float kept, float levels) {
  return clamp((kept * (1.0f + 1.0f / levels) - rank) * levels, 0.0f, 1.0f);
}

/// How much wider the kept blades are, so that all of them cover what all blades would.
WL_FUNCTION float keptWidening(float kept, float levels) {
  float reached = kept * (1.0f + 1.0f / levels);
  float band = 1.0f / levels;
  float mean = reached <= band ? 0.5f * reached * reached * levels : reached - 0.5f * band;
  if (reached > 1.0f) mean = mean - 0.5f * (reached - 1.0f) * (reached - 1.0f) * levels;
  return min(1.0f / max(mean, 1e-4f), BEZIER_MOST_WIDENING);
}

WL_SHARED_END
#endif
