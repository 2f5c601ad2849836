// The outline of a Bezier blade, the same in C++ (tests) and GLSL. Jahrmann & Wimmer, 2017, eq. 21-24.
#ifndef WINDLOOM_SHARED_BEZIER_SHAPE_H
#define WINDLOOM_SHARED_BEZIER_SHAPE_H
#include "shaders/shared/bezier_blade.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::clamp;
using glm::mix;
using std::abs;
using std::cos;
using std::max;
using std::min;
using std::sqrt;
#endif

// Where along a dandelion its head begins, and the width of its stalk over that of a blade.
#define BEZIER_HEAD 0.9f
#define BEZIER_STALK 0.3f

/// t of eq. 22: where between the edges c0 (0) and c1 (1) the place (u, v) lies. `tau` is the begin of a pointed tip.
WL_FUNCTION float bezierOutline(uint form, float u, float v, float tau) {
  if (form == BEZIER_FORM_TRIANGLE) return u + 0.5f * v - u * v;
  if (form == BEZIER_FORM_QUADRATIC) return u - u * v * v;
  if (form == BEZIER_FORM_TRIANGLE_TIP) return 0.5f + (u - 0.5f) * (1.0f - max(v - tau, 0.0f) / (1.0f - tau));
  return u;
}

/// Part of a quad that the outline covers.
WL_FUNCTION float bezierCover(uint form, float tau) {
  if (form == BEZIER_FORM_TRIANGLE) return 0.5f;
  if (form == BEZIER_FORM_QUADRATIC) return 2.0f / 3.0f;
  if (form == BEZIER_FORM_TRIANGLE_TIP) return 0.5f + 0.5f * tau;
  return 1.0f;
}

/// The same of a dandelion: a stalk with a round head of `spikes` spikes a side. Rows at the multiples of 1 / (2 spikes) of
/// the head meet every point and every notch, so a strip of so many rows loses none. `aspect`: height over width.
WL_FUNCTION float dandelionOutline(float u, float v, float spikes, float aspect) {
  float x = (v - BEZIER_HEAD) / (1.0f - BEZIER_HEAD);
  if (x <= 0.0f) return 0.5f + (u - 0.5f) * BEZIER_STALK;
  float round = sqrt(max(1.0f - (2.0f * x - 1.0f) * (2.0f * x - 1.0f), 0.0f));
  float spike = 0.5f - 0.5f * cos(6.2831853f * spikes * x);
  float part = max(round * mix(0.45f, 1.0f, spike) * (1.0f - BEZIER_HEAD) * aspect, BEZIER_STALK * (1.0f - x));
  return 0.5f + (u - 0.5f) * part;
}

/// Eq. 23: how far a place of the blade is moved along its normal, over the width, for a "v" of full depth. Times how wide
/// the outline is there, so that it fades at a pointed tip.
WL_FUNCTION float foldDepth(float u, float v, float outlineWidth) {
  return (0.5f - abs(u - 0.5f) * (1.0f - v)) * outlineWidth;
}

/// Eq. 24: how far a blade of so many pixels' width becomes a quad, 0..1 (Phi^2). The print adds t (1 - Phi) and u Phi^2,
/// which draws the edges towards c0 in between; here the weights sum up to 1.
WL_FUNCTION float widthCorrection(float pixels, float least, float span) {
  float phi = 1.0f - clamp((pixels - least) / max(span, 1e-3f), 0.0f, 1.0f);
  return phi * phi;
}

WL_SHARED_END
#endif
