// A blade as a chain of rigid segments joined by spherical springs, the same in C++ (tests) and GLSL: the inertial and
// the virtually-inertial model of Belyaev, Laevsky & Chukanov, "Real-time animation, collision and rendering of
// grassland", 2011. One pass from the root up; what upper segments do to lower ones is left out, as in the paper.
//
// Everything is divided by a segment's inertia J or by its spring's k, so that only rates and angles are left. Deviations:
// * The springs and the damping are integrated by the midpoint rule, which neither adds nor takes energy for any time step.
// * Without the reaction on lower segments, whatever being carried does to a segment would make energy from nothing: the
//   joint's acceleration, the drag of the carried motion, and weight as far as the segments below lean otherwise than in
//   the present wind at rest. These count as far as they do work on the segment, and at most as much as half its own
//   damping: a carried segment lags behind, then whips.
// * The wind coefficient kw falls in a strong wind, as real blades fold into the stream: in a steady wind the blade then
//   rests where `arc` puts it (blade_deformation.h) and never lies down.
//
// A lean is a vec2 in the world's xz plane, direction times angle (rad): the rotation about (up x direction). A joint's
// turn psi is a rotation vector in the frame of the segment below it.
#ifndef WINDLOOM_SHARED_SEGMENT_CHAIN_H
#define WINDLOOM_SHARED_SEGMENT_CHAIN_H
#include "shaders/shared/blade_deformation.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using glm::mat3;
using std::abs;
using std::pow;
WL_FUNCTION float chainAngle(float sine, float cosine) { return std::atan2(sine, cosine); }
#else
float chainAngle(float sine, float cosine) { return atan(sine, cosine); }
#endif

#define CHAIN_SEGMENTS 4
// Weight of a segment, m g l over k: how much a level segment sags at its joint (rad). Small enough for every spring to
// hold its segment up.
#define CHAIN_WEIGHT 0.08f
// Wind at which x (below) is the same for every exponent beta, as a part of the wind that bends a blade of linear answer
// to ARC_ANGLE_LIMIT. With 0.64 the steady bend differs least from arc's over all winds: 0.08 rad at beta = 4/3, none at 1.
#define CHAIN_MATCH 0.64f
// rad: no joint bends further. Only wild gusts on nearly undamped grass come there.
#define CHAIN_MOST_BEND 1.2f
// s: a step is cut into parts no longer than this, and no longer than CHAIN_MOST_TURN of the swing (rad).
#define CHAIN_LONGEST_PART 0.008334f
#define CHAIN_MOST_TURN 0.2f

/// One meadow's chain, as its passes see it (std140).
struct ChainBlock {
  vec4 spring;  // x k/J, 1/s^2; y damping/J, 1/s; z weight (CHAIN_WEIGHT); w half-length l of a segment, m
  vec4 wind;    // x drive: the bend is x |W|^y in a weak wind; y beta; z part of the wind's ripples felt; w F / stiffness, s/m
  vec4 grid;    // x, y virtual blades along x and z; z, w unused
};

/// What a blade remembers.
struct ChainState {
  vec3 psi[CHAIN_SEGMENTS];    // rad
  vec3 omega[CHAIN_SEGMENTS];  // angular velocity over the segment below, in its frame, rad/s
};

/// Leans of the segments against their pose at rest, or moments (over k) that hold them so.
struct ChainLeans {
  vec2 e[CHAIN_SEGMENTS];
};

// ---- Rotation vectors ----

/// M: the matrix of the rotation about `psi` by |psi|.
WL_FUNCTION mat3 chainMatrix(vec3 psi) {
  float angle2 = dot(psi, psi);
  float angle = sqrt(angle2);
  // sin(a) / a and (1 - cos(a)) / a^2, by their series where a is small.
  float s = angle < 0.02f ? 1.0f - angle2 / 6.0f : sin(angle) / angle;
  float c = angle < 0.02f ? 0.5f - angle2 / 24.0f : (1.0f - cos(angle)) / angle2;
  vec3 x = vec3(1.0f - c * (psi.y * psi.y + psi.z * psi.z), c * psi.x * psi.y + s * psi.z, c * psi.x * psi.z - s * psi.y);
  vec3 y = vec3(c * psi.x * psi.y - s * psi.z, 1.0f - c * (psi.x * psi.x + psi.z * psi.z), c * psi.y * psi.z + s * psi.x);
  vec3 z = vec3(c * psi.x * psi.z + s * psi.y, c * psi.y * psi.z - s * psi.x, 1.0f - c * (psi.x * psi.x + psi.y * psi.y));
  return mat3(x, y, z);
}

/// V: the rotation vector of a matrix, for turns below 3 rad.
WL_FUNCTION vec3 chainVector(mat3 m) {
  vec3 twiceSine = vec3(m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0]);
  float sine = 0.5f * sqrt(dot(twiceSine, twiceSine));
  float angle = chainAngle(sine, 0.5f * (m[0][0] + m[1][1] + m[2][2] - 1.0f));
  return twiceSine * (sine < 1e-6f ? 0.5f : 0.5f * angle / sine);
}

/// The lean of a segment that points along `axis` (unit vector).
WL_FUNCTION vec2 chainLean(vec3 axis) {
  vec2 level = vec2(axis.x, axis.z);
  float sine = lengthOf(level);
  return level * (sine < 1e-6f ? 1.0f : chainAngle(sine, axis.y) / sine);
}

/// The rotation vector that leans by `lean`.
WL_FUNCTION vec3 chainTurn(vec2 lean) { return vec3(lean.y, 0.0f, -lean.x); }

/// Each segment's lean from a chain's turns.
WL_FUNCTION ChainLeans chainLeans(ChainState state) {
  ChainLeans leans;
  mat3 frame = mat3(1.0f);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    frame = frame * chainMatrix(state.psi[i]);
    leans.e[i] = chainLean(frame[1]);
  }
  return leans;
}

// ---- Steady wind ----

/// The arc's tangent at the middle of segment i leans by this part of its tip's lean.
WL_FUNCTION float chainShare(int i) {
  return min((float(i) + 0.5f) / (float(CHAIN_SEGMENTS) * ARC_BEND_PART), 1.0f);
}

/// How far a steady wind of so many m/s leans the tip of an upright blade, rad: arcSteadyBend with its linear term to
/// the power of beta.
WL_FUNCTION float chainSteadyBend(ChainBlock chain, float speed) {
  return saturateBend(chain.wind.x * pow(max(speed, 1e-3f), chain.wind.y), ARC_ANGLE_LIMIT);
}

/// l f_i / k_i of segment i in a wind of this speed over it: with its weight it holds an upright blade as
/// chainSteadyBend says. kw of the paper is this over l |W|^beta / k_i.
WL_FUNCTION float chainForce(ChainBlock chain, int i, float speed) {
  float bend = chainSteadyBend(chain, speed);
  float share = chainShare(i);
  float below = i == 0 ? 0.0f : chainShare(i - 1);
  return ((share - below) * bend - chain.spring.z * sin(share * bend)) / cos(share * bend);
}

/// The leans of an upright blade at rest in a steady wind.
WL_FUNCTION ChainLeans chainSteadyLeans(ChainBlock chain, vec2 wind) {
  ChainLeans leans;
  float speed = lengthOf(wind);
  vec2 tip = wind * (speed < 1e-4f ? 0.0f : chainSteadyBend(chain, speed) / speed);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) leans.e[i] = tip * chainShare(i);
  return leans;
}

/// The same as a state without motion.
WL_FUNCTION ChainState chainSteadyState(ChainBlock chain, vec2 wind) {
  ChainState state;
  ChainLeans leans = chainSteadyLeans(chain, wind);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec2 below = i == 0 ? vec2(0.0f, 0.0f) : leans.e[i - 1];
    state.psi[i] = chainTurn(leans.e[i] - below);
    state.omega[i] = vec3(0.0f);
  }
  return state;
}

// ---- Motion ----

/// Parts that a step of `dt` is cut into.
WL_FUNCTION int chainParts(float dt, float stiffness) {
  float longest = min(CHAIN_LONGEST_PART, CHAIN_MOST_TURN / sqrt(max(stiffness, 1e-3f)));
  return int(min(dt / longest, 63.0f)) + 1;
}

/// Spring and damping over `dt` under an angular acceleration `push`, by the midpoint rule: the mean angular velocity.
WL_FUNCTION vec3 chainMeanOmega(vec3 psi, vec3 omega, vec3 push, float stiffness, float damping, float dt) {
  return (omega + (push - psi * stiffness) * (0.5f * dt)) / (1.0f + 0.5f * dt * damping + 0.25f * dt * dt * stiffness);
}

/// What a segment is carried by: the one below it, in the world.
struct ChainBelow {
  mat3 frame;
  vec3 turning;       // angular velocity, rad/s
  vec3 faster;        // its rate, rad/s^2
  vec3 velocity;      // of its tip: v*, m/s
  vec3 acceleration;  // m/s^2
};

/// What turns a segment.
struct ChainPush {
  vec3 push;   // angular acceleration, in the frame of the segment below
  float loss;  // of angular velocity, 1/s: its damping, more or less by being carried
};

/// Wind and weight turn segment i; being carried brakes or drives it. `steady` are the leans that this wind ends in.
WL_FUNCTION ChainPush chainPush(ChainBlock chain, int i, mat3 turn, vec3 omega, ChainBelow below, vec3 wind, ChainLeans steady) {
  float halfLength = chain.spring.w;
  float weight = chain.spring.x * chain.spring.z;
  vec3 up = vec3(0.0f, 1.0f, 0.0f);
  vec3 axis = below.frame * turn[1];
  vec3 carried = below.velocity + cross(below.turning, axis * halfLength);
  vec3 over = wind - carried - cross(below.frame * omega, axis * halfLength);
  float speed = max(sqrt(dot(over, over)), 1e-3f);
  float drag = chain.spring.x * chainForce(chain, i, speed) / speed;  // 1/s^2 for each m/s
  vec3 steadyUp = i == 0 ? up : up * chainMatrix(chainTurn(steady.e[i - 1]));
  ChainPush result;
  result.push = cross(axis, wind * drag) * below.frame - cross(turn[1], steadyUp) * weight;
  // 3/4 = m l^2 / J of a rod held at its end.
  vec3 lagging = cross(axis, carried * drag + below.acceleration * (0.75f / halfLength)) * below.frame;
  vec3 byBelow = lagging * -1.0f - cross(turn[1], up * below.frame - steadyUp) * weight;
  float own = chain.spring.y + drag * halfLength;
  float work = dot(byBelow, omega) / max(dot(omega, omega), 1e-8f);
  result.loss = own - max(-0.5f * own, min(0.5f * own, work));
  return result;
}

/// One part of a step of an upright blade in wind `wind` (m/s in the world), from the root up.
WL_FUNCTION ChainState chainPart(ChainBlock chain, ChainState state, vec3 wind, ChainLeans steady, float dt) {
  ChainBelow below;
  below.frame = mat3(1.0f);
  below.turning = below.faster = below.velocity = below.acceleration = vec3(0.0f);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec3 before = state.omega[i];
    mat3 turn = chainMatrix(state.psi[i]);
    ChainPush pushed = chainPush(chain, i, turn, before, below, wind, steady);
    vec3 mean = chainMeanOmega(state.psi[i], before, pushed.push, chain.spring.x, pushed.loss, dt);
    turn = chainMatrix(mean * dt) * turn;
    state.omega[i] = mean * 2.0f - before;
    state.psi[i] = chainVector(turn);
    float bend = sqrt(dot(state.psi[i], state.psi[i]));
    if (bend > CHAIN_MOST_BEND) {
      vec3 outwards = state.psi[i] / bend;
      state.psi[i] = outwards * CHAIN_MOST_BEND;
      state.omega[i] = state.omega[i] - outwards * max(dot(state.omega[i], outwards), 0.0f);
      turn = chainMatrix(state.psi[i]);
    }
    below.turning = below.turning + below.frame * state.omega[i];
    below.faster = below.faster + below.frame * ((state.omega[i] - before) / dt);
    below.frame = below.frame * turn;
    vec3 whole = below.frame[1] * (2.0f * chain.spring.w);
    below.velocity = below.velocity + cross(below.turning, whole);
    below.acceleration = below.acceleration + cross(below.faster, whole);
  }
  return state;
}

/// A step of any length; meant for up to 0.1 s.
WL_FUNCTION ChainState chainStep(ChainBlock chain, ChainState state, vec2 wind, float dt) {
  int parts = chainParts(dt, chain.spring.x);
  ChainLeans steady = chainSteadyLeans(chain, wind);
  for (int part = 0; part < parts; ++part) {
    state = chainPart(chain, state, vec3(wind.x, 0.0f, wind.y), steady, dt / float(parts));
  }
  return state;
}

// ---- Static equilibrium ----

/// What weight does to a segment with this lean, over k.
WL_FUNCTION vec2 chainSag(float weight, vec2 lean) {
  float angle = lengthOf(lean);
  return lean * (weight * (angle < 0.02f ? 1.0f : sin(angle) / angle));
}

/// G over k: the moments that would hold an upright blade with these leans in static equilibrium.
WL_FUNCTION ChainLeans chainMoments(ChainBlock chain, ChainLeans leans) {
  ChainLeans moments;
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec2 below = i == 0 ? vec2(0.0f, 0.0f) : leans.e[i - 1];
    moments.e[i] = leans.e[i] - below - chainSag(chain.spring.z, leans.e[i]);
  }
  return moments;
}

/// The lean of its tip that moments give to the meadow's mean blade, rad: within 0.02 of the exact one up to 1.5 rad.
WL_FUNCTION vec2 chainTipLean(ChainBlock chain, ChainLeans moments) {
  vec2 sum = vec2(0.0f, 0.0f);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) sum = sum + moments.e[i];
  float weight = chain.spring.z;
  float size = lengthOf(sum);
  // The sum of sin(share a) over the segments is about 2.5 a - 0.285 a^3.
  float first = size / (1.0f - 2.5f * weight);
  float tip = size + weight * (2.5f * first - 0.285f * first * first * first);
  return sum * (size < 1e-6f ? 1.0f / (1.0f - 2.5f * weight) : tip / size);
}

/// saturateBend backwards, as far as it goes: overshooting blades lean further than any steady wind leans them.
WL_FUNCTION vec2 chainDrive(vec2 lean) {
  float part = min(lengthOf(lean) / ARC_ANGLE_LIMIT, 0.97f);
  return lean / sqrt(1.0f - part * part);
}

/// How moments act on a blade that leans by `rest` in still air and whose F / stiffness is `relative` of the mean one's,
/// as a factor of complex numbers: its size is k of the mean blade over its own, its angle turns them as the blade's own
/// lean turns it in the wind. The blade is then bent as arcSteadyBend would bend it, so that none lies down.
WL_FUNCTION vec2 chainSoftness(ChainBlock chain, ChainLeans moments, vec2 rest, float relative) {
  vec2 tip = chainTipLean(chain, moments);
  float size = lengthOf(tip);
  if (size < 1e-4f) return vec2(relative, 0.0f);
  vec2 along = tip / size;
  float bend = min(size, 0.97f * ARC_ANGLE_LIMIT);
  vec2 own = chainDrive(rest) + chainDrive(along * bend) * relative;
  float reach = lengthOf(own);
  if (reach > 1e-6f) own = own * (saturateBend(reach, ARC_ANGLE_LIMIT) / reach);
  vec2 bent = own - rest;
  return vec2(dot(bent, along), along.x * bent.y - along.y * bent.x) / bend;
}

/// A moment under such a factor.
WL_FUNCTION vec2 chainSoftened(vec2 moment, vec2 softness) {
  return vec2(moment.x * softness.x - moment.y * softness.y, moment.x * softness.y + moment.y * softness.x);
}

/// The leans of a blade under moments and its own weight, by three fixed-point iterations a segment. `rest` is the lean
/// of its tip in still air, where its springs already carry it. A softer blade is lighter in proportion.
WL_FUNCTION ChainLeans chainEquilibrium(ChainBlock chain, ChainLeans moments, vec2 rest, vec2 softness) {
  ChainLeans leans;
  vec2 below = vec2(0.0f, 0.0f);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec2 restLean = rest * chainShare(i);
    vec2 own = chainSoftened(moments.e[i], softness);
    vec2 held = own - chainSag(chain.spring.z, restLean);
    vec2 turn = own;
    for (int iteration = 0; iteration < 3; ++iteration) {
      turn = held + chainSag(chain.spring.z, restLean + below + turn);
    }
    below = below + turn;
    leans.e[i] = below;
  }
  return leans;
}

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::ChainBlock) == 3 * 16, "std140 layout");
#endif
#endif
