// The colour map of signed values, in sRGB: blue below zero, orange above, near black at zero. Both arms grow lighter
// evenly (in Oklab, Ottosson 2020), and blue and orange stay apart for every common colour blindness.
#ifndef WINDLOOM_SHARED_DIVERGING_COLOUR_H
#define WINDLOOM_SHARED_DIVERGING_COLOUR_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

/// The stops of an arm: 0 at zero to 4 at the range's end.
WL_FUNCTION vec3 divergingStop(int i, bool above) {
  if (i <= 0) return vec3(0.085f, 0.090f, 0.105f);
  if (i == 1) return above ? vec3(0.345f, 0.180f, 0.050f) : vec3(0.055f, 0.215f, 0.400f);
  if (i == 2) return above ? vec3(0.625f, 0.310f, 0.045f) : vec3(0.110f, 0.385f, 0.690f);
  if (i == 3) return above ? vec3(0.900f, 0.490f, 0.130f) : vec3(0.300f, 0.585f, 0.915f);
  return above ? vec3(1.000f, 0.760f, 0.450f) : vec3(0.610f, 0.815f, 1.000f);
}

/// sRGB colour at t, clamped to -1..1.
WL_FUNCTION vec3 divergingColourAt(float t) {
  bool above = t > 0.0f;
  float size = above ? t : -t;
  float at = (size > 1.0f ? 1.0f : size) * 4.0f;
  int stop = int(at) < 3 ? int(at) : 3;
  float part = at - float(stop);
  return divergingStop(stop, above) * (1.0f - part) + divergingStop(stop + 1, above) * part;
}

WL_SHARED_END
#endif
