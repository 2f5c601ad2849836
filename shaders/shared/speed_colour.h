// The colour map of speed, in sRGB: lightness rises evenly (in Oklab, Ottosson 2020) from deep violet over
// teal to pale yellow, so that it reads without colour vision and in grey.
#ifndef WINDLOOM_SHARED_SPEED_COLOUR_H
#define WINDLOOM_SHARED_SPEED_COLOUR_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

/// The map's stops, evenly spaced: 0 at t = 0 to 8 at t = 1.
WL_FUNCTION vec3 speedStop(int i) {
  if (i <= 0) return vec3(0.176f, 0.016f, 0.396f);
  if (i == 1) return vec3(0.071f, 0.204f, 0.506f);
  if (i == 2) return vec3(0.042f, 0.345f, 0.498f);
  if (i == 3) return vec3(0.074f, 0.462f, 0.535f);
  if (i == 4) return vec3(0.101f, 0.581f, 0.567f);
  if (i == 5) return vec3(0.121f, 0.708f, 0.555f);
  if (i == 6) return vec3(0.424f, 0.810f, 0.488f);
  if (i == 7) return vec3(0.718f, 0.883f, 0.439f);
  return vec3(0.981f, 0.944f, 0.443f);
}

/// sRGB colour at t, clamped to 0..1.
WL_FUNCTION vec3 speedColourAt(float t) {
  float at = (t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t) * 8.0f;
  int stop = int(at) < 7 ? int(at) : 7;
  float part = at - float(stop);
  return speedStop(stop) * (1.0f - part) + speedStop(stop + 1) * part;
}

WL_SHARED_END
#endif
