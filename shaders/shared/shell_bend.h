// How wind bends shell grass, the same in C++ (tests, tables) and GLSL: Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002.
#ifndef WINDLOOM_SHARED_SHELL_BEND_H
#define WINDLOOM_SHARED_SHELL_BEND_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using std::cos;
using std::floor;
using std::max;
using std::min;
using std::pow;
using std::sin;
#endif

// Segments of a blade where shells are filled in; shells stand at ends of some of them.
#define SHELL_SEGMENTS 64
#define SHELL_HALF_PI 1.57079633f

/// Where a shell is over the ground, in the unit of the segments' length.
struct ShellOffset {
  float along;  // n_i, along the normal
  float aside;  // w_i, along the wind
};

/// rad that segment `j` of `segments` leans by: 0 at the root, pi / 2 times `intensity` at the tip. `stiffness`: exponent in place
/// of the paper's 1; below 1 blades bend low, above 1 high.
WL_FUNCTION float shellLean(int j, int segments, float intensity, float stiffness) {
  return j <= 0 ? 0.0f : pow(float(j) / float(segments), stiffness) * SHELL_HALF_PI * intensity;
}

/// The paper's running total: n_i, w_i from n_(i-1), w_(i-1). `step`: S, the length of a segment. It begins with (0, 0).
WL_FUNCTION ShellOffset shellNext(ShellOffset before, int i, int segments, float step, float intensity, float stiffness) {
  float lean = shellLean(i, segments, intensity, stiffness);
  ShellOffset next;
  next.along = before.along + step * cos(lean);
  next.aside = before.aside + step * sin(lean);
  return next;
}

/// Wind intensity I: `bend` is how far a weak wind moves the tip, in heights of the blade. It grows to `limit`, which it reaches
/// where bend is (pi / 2) limit, and stays there.
WL_FUNCTION float shellIntensity(float bend, float limit) {
  float x = min(bend / (0.5f * SHELL_HALF_PI), 2.0f * limit);
  return x - x * x / (4.0f * limit);
}

/// The paper's analytic source at `away` m from it: I swings with its period in -strength..strength, ring after ring.
WL_FUNCTION float shellSourceIntensity(float away, float time, float strength, float period, float ring, float delay) {
  float stepOf = floor(away / ring);
  return strength * sin(4.0f * SHELL_HALF_PI * (time - stepOf * delay) / period);
}

/// Height over the tallest, 0..1, that a texture's alpha stands for, and the other way round. `curve` p >= 1: finer near 1.
WL_FUNCTION float shellHeightOf(float alpha, float curve) { return 1.0f - pow(1.0f - alpha, curve); }
WL_FUNCTION float shellAlphaOf(float height, float curve) { return 1.0f - pow(1.0f - height, 1.0f / curve); }

WL_SHARED_END
#endif
