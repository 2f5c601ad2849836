// How wind bends a blade, the same in C++ (tests) and GLSL (drawing).
//
// `quadratic` is eq. 11-13 of Choi & Sung, "CWD-Sim: Real-Time Simulation on Grass Swaying with
// Controllable Wind Dynamics", 2024, with +V_z in eq. 12 (the paper's texture axis runs against z).
// `arc` takes the same inputs but bends the blade as an arc of constant length: the tangent turns
// from upright at the root evenly up to kArcBend of the length, and stays straight from there. It
// agrees with eq. 12 on how far the tip moves in a weak wind.
#ifndef WINDLOOM_SHARED_BLADE_DEFORMATION_H
#define WINDLOOM_SHARED_BLADE_DEFORMATION_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using std::cos;
using std::max;
using std::min;
using std::sin;
using std::sqrt;
inline float lengthOf(vec2 v) { return std::sqrt(v.x * v.x + v.y * v.y); }
#else
float lengthOf(vec2 v) { return length(v); }
#endif

// Part of the blade, from the root, that bends.
#define ARC_BEND_PART 0.75f
// rad the steady part of the bend approaches in a gale; with the flutter on top it stays below 90 degrees.
#define ARC_ANGLE_LIMIT 1.27f
// rad the tip flutters at most by, at flutter 1.
#define ARC_FLUTTER_LIMIT 0.26f

/// A point on the bent blade and its tangent, in units of the blade's length: x along the bend, y up.
struct ArcPoint {
  vec2 position;
  vec2 tangent;
};

/// The blade at `s` in 0..1 of its length, bent so that its tip leans by `angle` (rad, >= 0, < pi / 2).
WL_FUNCTION ArcPoint arcAt(float angle, float s) {
  float bent = min(s, ARC_BEND_PART);
  float straight = s - bent;
  float turn = angle * bent / ARC_BEND_PART;
  // sin(t)/t and (1 - cos(t))/t, by their series where t is small.
  float t2 = turn * turn;
  float along = turn < 0.02f ? 1.0f - t2 / 6.0f : sin(turn) / turn;
  float across = turn < 0.02f ? turn * (0.5f - t2 / 24.0f) : (1.0f - cos(turn)) / turn;
  ArcPoint point;
  point.tangent = vec2(sin(turn), cos(turn));
  point.position = vec2(across, along) * bent + point.tangent * straight;
  return point;
}

/// How far bend `x` (rad) really turns the blade: x for a small one, `limit` in a gale, always growing.
WL_FUNCTION float saturateBend(float x, float limit) { return x / sqrt(1.0f + (x / limit) * (x / limit)); }

/// The steady bend of a blade as a vector (direction in the world, length = angle of its tip in rad).
/// `rest` is the same of the blade in still air, `wind` in m/s, `factor` F of eq. 12 over the blade's
/// own stiffness in s/m.
WL_FUNCTION vec2 arcSteadyBend(vec2 rest, vec2 wind, float factor) {
  // A weak bend of angle a moves the tip by a (1 - ARC_BEND_PART / 2) of the length; eq. 12 by F |V|.
  vec2 bend = rest + wind * (factor / (1.0f - 0.5f * ARC_BEND_PART));
  float size = lengthOf(bend);
  return size > 1e-6f ? bend * (saturateBend(size, ARC_ANGLE_LIMIT) / size) : bend;
}

/// The flutter around the steady bend at a moment (same form). Frequencies belong to the blade and only
/// amplitudes to the wind, so that the motion stays smooth when the wind changes; it grows with the wind
/// and doesn't fade in a gale. `phase` in 0..1 and `pace` (about 1) are the blade's own.
WL_FUNCTION vec2 arcFlutter(vec2 wind, float time, float phase, float pace, float flutter) {
  float speed = lengthOf(wind);
  if (speed < 1e-4f) return vec2(0.0f, 0.0f);
  vec2 along = wind / speed;
  vec2 aside = vec2(-along.y, along.x);
  float gale = speed / (speed + 6.0f);
  float turn = 6.2831853f * phase;
  float slow = sin(6.9f * pace * time + turn);
  float fast = sin(17.3f * pace * time + 2.3f * turn);
  float sway = 0.75f * slow * (1.0f - 0.5f * gale) + 0.5f * gale * fast;
  float side = sin(11.7f * pace * time + 1.7f * turn);
  float reach = flutter * ARC_FLUTTER_LIMIT * min(1.0f, 0.25f + 0.75f * gale) * min(1.0f, speed);
  return along * (reach * 0.8f * sway) + aside * (reach * 0.7f * side);
}

/// Eq. 11-13 in blade-local axes (x across the blade, y up, z to its front), in units of its height.
/// `windTerm` is F V in the same axes. Misses M of eq. 13, the scale and the move to the root.
WL_FUNCTION vec3 quadraticAt(vec3 p, vec2 windTerm, float k1, float k2, float lambda) {
  float y2 = p.y * p.y;
  vec3 drooped = vec3(p.x, p.y - k1 * y2, p.z + k2 * y2);
  float d2 = drooped.y * drooped.y;
  vec3 turned = vec3(windTerm.x * d2, -lengthOf(windTerm) * d2, windTerm.y * d2);
  return (1.0f - lambda) * turned + lambda * drooped;
}

WL_SHARED_END
#endif
