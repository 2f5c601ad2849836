// How many of a meadow's blades are drawn where, the same in C++ (tests) and GLSL.
//
// Belyaev, Laevsky & Chukanov, "Real-time animation, collision and rendering of grassland", 2011: a blade with weight w
// is dropped when w > F(d, n, r) = K g((n, r)) / (a d^2 + b d + c), g(x) = x + (1 - x)^8. Here distance enters as the
// size of a blade in pixels, so that any lens and picture size is served; the denominator is what a blade must be widened
// by to be seen; and K is how many layers of blades a ray may meet before more of them can't be seen. The second term of
// g is smaller, since on flat ground it would keep everything towards the horizon.
#ifndef WINDLOOM_SHARED_GRASS_DENSITY_H
#define WINDLOOM_SHARED_GRASS_DENSITY_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
inline float clampTo(float x, float low, float high) { return x < low ? low : x > high ? high : x; }
#else
float clampTo(float x, float low, float high) { return clamp(x, low, high); }
#endif

/// g: `facing` is the cosine between ground normal and direction to the camera, 0..1; `lift` 1 is the paper's.
WL_FUNCTION float contourGain(float facing, float lift) {
  float x = clampTo(facing, 0.0f, 1.0f);
  float rest2 = (1.0f - x) * (1.0f - x);
  float rest4 = rest2 * rest2;
  return x + lift * rest4 * rest4;
}

/// Part of the blades that a ray towards ground of this gain can tell apart; over 1 where there are too few for that.
/// `coverage`: area of all blades over that of the ground; `layers`: of blades along the ray that count.
WL_FUNCTION float keptByLayers(float gain, float coverage, float layers) {
  return layers * gain / (coverage > 1e-4f ? coverage : 1e-4f);
}

/// F without the height: both parts together. May be over 1: all, with room to spare.
WL_FUNCTION float keptTogether(float byLayers, float byWidth) {
  float low = byLayers < byWidth ? byLayers : byWidth;
  float both = byLayers * byWidth;
  return both < low ? both : low;
}

/// How much wider than itself a blade of `pixels` is drawn, so that it is `least` pixels wide, but `most` times at most.
WL_FUNCTION float widening(float pixels, float least, float most) {
  return clampTo(least / (pixels > 1e-6f ? pixels : 1e-6f), 1.0f, most);
}

/// 1 where blades are well over `fade` pixels high, 0 where the ground's shading has taken over.
WL_FUNCTION float keptByHeight(float pixels, float fade) {
  float t = clampTo((pixels / fade - 0.6f) / (1.6f - 0.6f), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

WL_SHARED_END
#endif
