// What moves Bezier blades, the same in C++ (tests) and GLSL. Jahrmann & Wimmer, "Responsive real-time grass rendering",
// 2017, eq. 1 to 8 and 14 to 16.
//
// How eq. 1 is integrated. Of whatever moves a tip, the part along the blade only stretches it, and eq. 10 to 13 take that
// away again: done over and over they lead every tip to one distance from the root, which depends on its direction alone
// (bezierReach). So a blade is a direction u, and what is left of eq. 1 for short steps is
//   du/dt = (G - u (u . G)) / bezierReach(u),   G = s max(1 - eta, 0.1) up + g + w theta(u), for a blade 1 m high.
// For a constant G that has an exact solution (bezierTurned), which is used for each part of a step with the G that the
// blade has halfway (second order). It is stable for any length of a step and any stiffness, and the pose at a time depends
// on the frame rate by little. Tips that are stored are as eq. 10 to 13 leave them: validating them again changes nothing.
//
// Eq. 12 gives the curves that occur their length to 0.99%, 0.45% in the mean over directions (a test measures it).
#ifndef WINDLOOM_SHARED_BEZIER_PHYSICS_H
#define WINDLOOM_SHARED_BEZIER_PHYSICS_H
#include "shaders/shared/bezier_pose.h"
#include "shaders/shared/collider.h"
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using std::ceil;
using std::exp;
using std::sqrt;
#endif

#define BEZIER_STEP_S (1.0f / 60.0f)
// Where something moves through: with parts of 1/60 s a blade in the middle of a ball's way ends up to a tenth of its height away
// from where parts of 1/240 s leave it.
#define BEZIER_TOUCH_STEP_S (1.0f / 240.0f)
#define BEZIER_PARTS_MOST 32.0f
// Parts of the time that a patch slept through.
#define BEZIER_WAKE_PARTS 16.0f
// A blade never lies flatter: the sine of its tip's angle over the ground. Flatter ones would lie in the ground's own
// triangles, and eq. 12 is off by more than 1% there.
#define BEZIER_LOWEST 0.1f
// eta at most, so that whatever hit a blade it begins to rise after 1.1 / collisionFade s.
#define BEZIER_STRENGTH_MOST 2.0f
// Eq. 16 with a measure of time, since the square of what a step moves depends on its length: so much is gained as the
// collision strength says when a blade is moved by its height within this time.
#define BEZIER_CONTACT_S 0.25f
#define BEZIER_WAVES 4
// Primitives that a dispatch knows, and how many of them share a box.
#define BEZIER_RUN 64u
#define BEZIER_RUNS 64u

struct BezierPhysicsBlock {
  vec4 gravity;              // xyz D_xyz/|D_xyz| D_w (1 - t) of eq. 4, m/s; w part of it that pulls to the front
  vec4 centre;               // xyz C_xyz, m; w C_w t, m/s
  vec4 motion;               // x s for stiffness 1, 1/s; y m/s of the tip for each m/s of wind; z collision strength; w a, 1/s
  vec4 wind;                 // x 1: the simulated wind blows; y 1: the waves do; z flutter; w unused
  vec4 waves[BEZIER_WAVES];  // xy turns per m along x, z; z turns at the frame's time; w m/s at the crest
};

/// A patch that is stepped.
struct BezierWork {
  uint patchIndex;
  uint known;       // the first blades have a state; the others begin at rest
  float asleep;     // s that it slept through before this step
  uint moving;      // 1: something that moves may touch it
};

/// When a patch was stepped last.
struct BezierClock {
  float pending;  // s of simulated time since
  uint known;     // blades that have a state
};

/// A primitive at the begin and at the end of a step.
struct BezierMover {
  vec4 a;       // as ColliderPrimitive
  vec4 b;       // w 1: it moves
  vec4 laterA;
  vec4 laterB;
};

/// The box around BEZIER_RUN movers in a row.
struct BezierRun {
  vec4 low;   // xyz m
  vec4 high;
};

/// Forces on a blade as on one 1 m high.
struct BezierForces {
  vec3 up;
  vec3 front;      // f: at right angles to up and to the width
  vec3 gravity;    // eq. 6, m/s
  vec3 wind;       // m/s of the tip where theta is 1
  float recovery;  // s of eq. 3, 1/s
};

/// Eq. 2.
WL_FUNCTION float bezierFaded(float strength, float fade, float seconds) { return max(strength - fade * seconds, 0.0f); }

/// Eq. 4 to 6 for m = 1, m/s.
WL_FUNCTION vec3 bezierGravity(vec4 gravity, vec4 centre, vec3 root, vec3 front) {
  vec3 way = vec3(centre) - root;
  vec3 pull = vec3(gravity) + way * (centre.w / max(length(way), 1e-6f));
  return pull + front * (gravity.w * length(pull));
}

/// theta of eq. 7; 0 without wind. `tip`: v2 - v0 over the height.
WL_FUNCTION float bezierWindPart(vec3 wind, vec3 tip, vec3 up) {
  float both = length(wind) * length(tip);
  if (both < 1e-9f) return 0.0f;
  return (1.0f - min(abs(dot(wind, tip)) / both, 1.0f)) * dot(tip, up);
}

/// The distance of a tip from its root over the height, 0.95..1, where eq. 10 to 13 leave it as it is: they are a quadratic
/// equation for it. `direction`: a unit vector, not below the ground.
WL_FUNCTION float bezierReach(vec3 direction, vec3 up) {
  float c = max(dot(direction, up), 0.0f);
  float s = length(vec3(direction - up * c));
  float reach = 6.0f / (8.0f - 2.0f * c - 6.0f * s + s * sqrt(32.0f + (32.0f - 48.0f * s) / (1.0f + c)));
  if (1.0f - reach * s >= 0.05f) return reach;
  // v1 at its lowest; the root of that equation, (b - sqrt(b b - 104.4)) / 6 with b = 11.8 - 0.1 c, to 1e-5.
  return 0.98291f + 0.01676f * c;
}

/// What turns a blade that points in `direction`: G above; `strength` eta.
WL_FUNCTION vec3 bezierPull(BezierForces forces, vec3 direction, float strength) {
  float theta = bezierWindPart(forces.wind, direction * bezierReach(direction, forces.up), forces.up);
  return forces.up * (forces.recovery * max(1.0f - strength, 0.1f)) + forces.gravity + forces.wind * theta;
}

/// Where du/dt = G - u (u . G) leads from u after a while.
WL_FUNCTION vec3 bezierTurned(vec3 direction, vec3 pull, float seconds) {
  float strength = length(pull);
  vec3 along = pull / max(strength, 1e-9f);
  float e = exp(-min(strength * seconds, 15.0f));
  float c = dot(direction, along);
  return normalize(vec3(direction * (2.0f * e) + along * (1.0f - e * e + (1.0f - e) * (1.0f - e) * c)));
}

/// Eq. 9 for a direction, which stays BEZIER_LOWEST over the ground; one that points straight down tips over to the front.
WL_FUNCTION vec3 bezierRaised(vec3 direction, vec3 up, vec3 front) {
  float height = dot(direction, up);
  if (height >= BEZIER_LOWEST) return direction;
  vec3 aside = direction - up * height;
  float size = length(aside);
  aside = size > 1e-4f ? aside / size : front;
  return up * BEZIER_LOWEST + aside * sqrt(1.0f - BEZIER_LOWEST * BEZIER_LOWEST);
}

/// A part of a step without collisions.
WL_FUNCTION vec3 bezierSwung(BezierForces forces, vec3 direction, float strength, float seconds) {
  vec3 halfway = bezierTurned(direction, bezierPull(forces, direction, strength),
                              0.5f * seconds / bezierReach(direction, forces.up));
  halfway = bezierRaised(halfway, forces.up, forces.front);
  vec3 after = bezierTurned(direction, bezierPull(forces, halfway, strength), seconds / bezierReach(halfway, forces.up));
  return bezierRaised(after, forces.up, forces.front);
}

/// What of a blade changes.
struct BezierMotion {
  vec3 direction;  // unit vector to its tip
  float strength;  // eta
};

/// The same with the strength of collisions fading at `fade`.
WL_FUNCTION BezierMotion bezierSwing(BezierForces forces, BezierMotion motion, float fade, float seconds) {
  BezierMotion after;
  after.direction = bezierSwung(forces, motion.direction, bezierFaded(motion.strength, fade, 0.5f * seconds), seconds);
  after.strength = bezierFaded(motion.strength, fade, seconds);
  return after;
}

/// In how many parts a step is done, 1..BEZIER_PARTS_MOST; strong wind asks for shorter ones.
WL_FUNCTION float bezierParts(float seconds, vec3 wind) {
  float parts = max(ceil(seconds / BEZIER_STEP_S - 0.01f), ceil(1.25f * seconds * length(wind)));
  return min(max(parts, 1.0f), BEZIER_PARTS_MOST);
}

/// The length of the parts of `asleep` s, of which there are BEZIER_WAKE_PARTS. Where that doesn't reach, it is enough of the end
/// of it to forget what was before.
WL_FUNCTION float bezierWakePart(float asleep, vec3 wind) {
  return min(asleep / BEZIER_WAKE_PARTS, 0.8f / max(length(wind), 1e-6f));
}

WL_FUNCTION ColliderPrimitive bezierMoverAt(BezierMover mover, float part) {
  ColliderPrimitive primitive;
  primitive.a = mover.a + (mover.laterA - mover.a) * part;
  primitive.b = mover.b + (mover.laterB - mover.b) * part;
  return primitive;
}

/// Eq. 15: how `point` gets out of a primitive.
WL_FUNCTION vec3 bezierPush(ColliderPrimitive primitive, vec3 point) {
  vec3 away = point - colliderAxis(primitive, point);
  float distance = length(away);
  if (distance >= primitive.a.w) return vec3(0.0f);
  if (distance < 1e-6f) return vec3(0.0f, primitive.a.w, 0.0f);
  return away * (primitive.a.w / distance - 1.0f);
}

/// d of eq. 1 for a curve: the tip and the middle (eq. 14) are tested, and the middle's way moves the tip by four times it.
WL_FUNCTION vec3 bezierHit(ColliderPrimitive primitive, vec3 root, BezierCurve curve) {
  vec3 middle = curve.middle * 0.5f + curve.tip * 0.25f;
  return bezierPush(primitive, root + curve.tip) + bezierPush(primitive, root + middle) * 4.0f;
}

/// Eq. 16: what a hit that moves the tip by `moved` m within a part of `seconds` adds to eta.
WL_FUNCTION float bezierGain(vec3 moved, float height, float collisionStrength, float seconds) {
  return collisionStrength * dot(moved, moved) / (height * height) * (BEZIER_CONTACT_S / max(seconds, 1e-4f));
}

/// The curve of a blade that points in `direction`; bezierValid leaves it as it is.
WL_FUNCTION BezierCurve bezierCurveOf(vec3 direction, vec3 up, float height) {
  BezierCurve curve;
  curve.tip = direction * (height * bezierReach(direction, up));
  curve.middle = bezierMiddle(curve.tip, up, height);
  return curve;
}

/// Where a tip points; one at its root points along `up`.
WL_FUNCTION vec3 bezierDirection(vec3 tip, vec3 up, vec3 front) {
  float size = length(tip);
  return size > 1e-6f ? bezierRaised(vec3(tip / size), up, front) : up;
}

/// Waves of eq. 8 at a place, m/s along x and z: bands of wind that run with the ambient wind, in step here and there.
WL_FUNCTION vec2 bezierWave(vec4 wave, vec2 place) {
  vec2 along = vec2(wave.x, wave.y);
  float size = max(length(along), 1e-9f);
  float turn = dot(along, place) - wave.z;
  return along * (wave.w / size * (0.5f + 0.5f * cos(6.2831853f * turn)));
}

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::BezierPhysicsBlock) == 16 * (4 + BEZIER_WAVES), "std140 layout");
static_assert(sizeof(windloom::shared::BezierWork) == 16, "std430 layout");
static_assert(sizeof(windloom::shared::BezierClock) == 8, "std430 layout");
static_assert(sizeof(windloom::shared::BezierMover) == 64, "std430 layout");
static_assert(sizeof(windloom::shared::BezierRun) == 32, "std430 layout");
#endif
#endif
