// The curve of a Bezier blade from its record and its tip, the same in C++ (tests) and GLSL. Jahrmann & Wimmer, 2017, eq. 9-14.
#ifndef WINDLOOM_SHARED_BEZIER_POSE_H
#define WINDLOOM_SHARED_BEZIER_POSE_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using glm::abs;
using glm::cross;
using glm::dot;
using glm::length;
using glm::normalize;
using std::abs;
using std::cos;
using std::max;
using std::min;
using std::sin;
#endif

/// Unit vector from a place on the octahedron's square, both in -1..1 (Cigolle and others, "Survey of efficient
/// representations for independent unit vectors", 2014).
WL_FUNCTION vec3 octahedralVector(vec2 e) {
  vec3 v = vec3(e.x, 1.0f - abs(e.x) - abs(e.y), e.y);
  if (v.y < 0.0f) {
    v.x = (1.0f - abs(e.y)) * (e.x >= 0.0f ? 1.0f : -1.0f);
    v.z = (1.0f - abs(e.x)) * (e.y >= 0.0f ? 1.0f : -1.0f);
  }
  return normalize(v);
}

WL_FUNCTION vec2 octahedralPlace(vec3 v) {
  float sum = abs(v.x) + abs(v.y) + abs(v.z);
  vec2 e = vec2(v.x, v.z) / sum;
  if (v.y >= 0.0f) return e;
  return vec2((1.0f - abs(e.y)) * (e.x >= 0.0f ? 1.0f : -1.0f), (1.0f - abs(e.x)) * (e.y >= 0.0f ? 1.0f : -1.0f));
}

/// t1: along the blade's width, at right angles to `up`. `turn`: the blade's direction, 0..1 of a turn about `up`.
WL_FUNCTION vec3 bezierAcross(vec3 up, float turn) {
  // Frame of Duff and others, "Building an orthonormal basis, revisited", 2017, about y.
  float s = up.y >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + up.y);
  float b = up.z * up.x * a;
  vec3 first = vec3(s * b, -s * up.z, 1.0f + s * up.z * up.z * a);
  vec3 second = vec3(s + up.x * up.x * a, -up.x, b);
  float angle = 6.2831853f * turn;
  return first * cos(angle) + second * sin(angle);
}

/// f: the front of the blade, at right angles to its width and to `up`.
WL_FUNCTION vec3 bezierFront(vec3 up, vec3 across) { return cross(across, up); }

/// v1 - v0 from v2 - v0: eq. 10 and 11. `height` > 0.
WL_FUNCTION vec3 bezierMiddle(vec3 tip, vec3 up, float height) {
  float aside = length(vec3(tip - up * dot(tip, up))) / height;
  return up * (height * max(1.0f - aside, 0.05f * max(aside, 1.0f)));
}

/// Approximate length of the curve of 0, `middle` and `tip`, relative to v0 (eq. 12; Gravesen 1997).
WL_FUNCTION float bezierLength(vec3 middle, vec3 tip) {
  return (2.0f * length(tip) + length(middle) + length(vec3(tip - middle))) / 3.0f;
}

struct BezierCurve {
  vec3 middle;  // v1 - v0, m
  vec3 tip;     // v2 - v0, m
};

/// Eq. 9 to 13: lifts the tip over the plane of the ground, finds v1, and gives the curve its length. `height` > 0.
WL_FUNCTION BezierCurve bezierValid(vec3 tip, vec3 up, float height) {
  BezierCurve curve;
  tip = tip - up * min(dot(up, tip), 0.0f);
  vec3 middle = bezierMiddle(tip, up, height);
  float q = height / bezierLength(middle, tip);
  curve.middle = middle * q;
  curve.tip = curve.middle + (tip - middle) * q;
  return curve;
}

/// A point of the curve, relative to v0, at `v` 0..1.
WL_FUNCTION vec3 bezierPoint(BezierCurve curve, float v) {
  return curve.middle * (2.0f * v * (1.0f - v)) + curve.tip * (v * v);
}

WL_SHARED_END
#endif
