#version 450 core
// One invocation moves one blade of Bezier grass, one work-group a patch (Jahrmann & Wimmer, 2017, section 5); shaders/shared/
// bezier_physics.h has the equations and tells how they are integrated.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/bezier_wind.glsl"
#include "shaders/include/bezier_lanes.glsl"

layout(local_size_x = LANES) in;
// A BezierBlade in two reads.
layout(std430, binding = RENDER_SSBO_BEZIER_BLADES) readonly buffer Blades { uvec4 halfBlades[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_STATES) buffer States { BezierState states[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_LIST) readonly buffer List { BezierWork works[]; };

uniform uint kept;
uniform float stepSeconds;

struct Blade {
  vec3 root;
  float height;
  BezierForces forces;
  BezierMotion motion;
};

Blade bladeAt(uint index, bool fromRest) {
  uvec4 first = halfBlades[2u * index];
  uvec4 second = halfBlades[2u * index + 1u];
  Blade blade;
  blade.root = uintBitsToFloat(first.xyz);
  blade.height = unpackHalf2x16(second.x).x;
  vec3 up = octahedralVector(unpackSnorm2x16(first.w));
  blade.forces.up = up;
  blade.forces.front = bezierFront(up, bezierAcross(up, float(second.y >> 16) / 65535.0));
  blade.forces.gravity = bezierGravity(physics.gravity, physics.centre, blade.root, blade.forces.front);
  blade.forces.wind = bezierWind(blade.root, up) * physics.motion.y;
  blade.forces.recovery = physics.motion.x * unpackHalf2x16(second.y).x;
  vec4 state = fromRest ? vec4(up, 0.0) : states[index].tip;
  blade.motion = BezierMotion(bezierDirection(state.xyz, up, blade.forces.front), state.w);
  return blade;
}

#ifdef TOUCHED  // a program of its own, so that other patches cost nothing of it
layout(std430, binding = RENDER_SSBO_BEZIER_PATCHES) readonly buffer Patches { BezierPatch patches[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_PRIMITIVES) readonly buffer Movers {
  BezierRun runs[BEZIER_RUNS];
  BezierMover movers[];
};

uniform uint moverCount;
uniform uint patchCount;
uniform float touchParts;

// The movers that may touch the patch, a bit each, so that all blades meet them in one order.
const uint kWords = BEZIER_RUN * BEZIER_RUNS / 32u;
shared uint nearby[kWords];

void listNearby(BezierPatch at) {
  for (uint word = gl_LocalInvocationIndex; word < kWords; word += LANES) nearby[word] = 0u;
  barrier();
  vec3 low = at.centre.xyz - at.reach.xyz;
  vec3 high = at.centre.xyz + at.reach.xyz;
  for (uint i = gl_LocalInvocationIndex; i < moverCount; i += LANES) {
    BezierMover mover = movers[i];
    vec3 from = min(min(mover.a.xyz, mover.b.xyz), min(mover.laterA.xyz, mover.laterB.xyz)) - mover.a.w;
    vec3 to = max(max(mover.a.xyz, mover.b.xyz), max(mover.laterA.xyz, mover.laterB.xyz)) + mover.a.w;
    if (any(greaterThan(from, high)) || any(lessThan(to, low))) continue;
    atomicOr(nearby[i / 32u], 1u << (i % 32u));
  }
  barrier();
}

// Out of all that is near, one after the other, as it is at this part of the step.
void touch(inout Blade blade, float part, float seconds) {
  float gained = 0.0;
  BezierCurve curve = bezierCurveOf(blade.motion.direction, blade.forces.up, blade.height);
  for (uint word = 0u; word * 32u < moverCount; ++word) {
    for (uint bits = nearby[word]; bits != 0u; bits &= bits - 1u) {
      ColliderPrimitive primitive = bezierMoverAt(movers[word * 32u + uint(findLSB(bits))], part);
      vec3 moved = bezierHit(primitive, blade.root, curve);
      if (moved == vec3(0.0)) continue;
      gained += bezierGain(moved, blade.height, physics.motion.z, seconds);
      blade.motion.direction = bezierDirection(curve.tip + moved, blade.forces.up, blade.forces.front);
      curve = bezierCurveOf(blade.motion.direction, blade.forces.up, blade.height);
    }
  }
  blade.motion.strength = min(blade.motion.strength + gained, BEZIER_STRENGTH_MOST);
}
#endif

void main() {
  const float kToSettle = 1000.0;  // s
#ifdef TOUCHED
  BezierWork work = works[patchCount - 1u - gl_WorkGroupID.x];
  listNearby(patches[work.patchIndex]);
#else
  BezierWork work = works[gl_WorkGroupID.x];
#endif
  uint own = gl_LocalInvocationIndex;
  uint index = work.patchIndex * BEZIER_PATCH + own;
  if (own >= kept) return;
  bool fromRest = own >= work.known;
  Blade blade = bladeAt(index, fromRest);
  if (blade.height <= 0.0) return;

  float asleep = fromRest ? kToSettle : work.asleep;
  float wakeSeconds = bezierWakePart(asleep, blade.forces.wind);
  float wakeParts = asleep > 0.0 ? BEZIER_WAKE_PARTS : 0.0;
  float fade = physics.motion.w;
  blade.motion.strength = bezierFaded(blade.motion.strength, fade, asleep - wakeSeconds * wakeParts);
  float parts = bezierParts(stepSeconds, blade.forces.wind);
#ifdef TOUCHED
  if (work.moving != 0u) parts = max(parts, touchParts);
#endif
  float seconds = stepSeconds / parts;
  // One loop, tested at its end: a software renderer does what is in a branch not taken, and a loop's body once more where
  // the test comes first.
  float i = -wakeParts;
  do {
    float lasts = i < 0.0 ? wakeSeconds : seconds;
    blade.motion = bezierSwing(blade.forces, blade.motion, fade, lasts);
#ifdef TOUCHED
    touch(blade, max(i + 1.0, 0.0) / parts, lasts);
#endif
  } while (++i < parts);
  float reach = blade.height * bezierReach(blade.motion.direction, blade.forces.up);
  states[index].tip = vec4(blade.motion.direction * reach, blade.motion.strength);
}
