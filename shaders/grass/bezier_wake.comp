#version 450 core
// Which patches of Bezier grass are stepped: those that are seen, or that something moves through. The others sleep, and are
// told when they wake for how long they did. What lies still in a patch doesn't wake it: its blades would lean against it all
// the same.
#include "shaders/shared/bezier_blade.h"
#include "shaders/shared/bezier_physics.h"
#include "shaders/shared/render_bindings.h"

layout(local_size_x = 64) in;
layout(std430, binding = RENDER_SSBO_BEZIER_CLOCKS) buffer Clocks { BezierClock clocks[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_PATCHES) readonly buffer Patches { BezierPatch patches[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_SEEN) readonly buffer Seen { uint seen[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_LIST) writeonly buffer List { BezierWork works[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_COMMANDS) buffer Commands {
  uint quiet;  // groups that nothing touches: from the list's begin
  uint quietRows[3];
  uint touched;  // groups that something may touch: from its end
  uint touchedRows[3];
};
layout(std430, binding = RENDER_SSBO_BEZIER_PRIMITIVES) readonly buffer Movers {
  BezierRun runs[BEZIER_RUNS];
  BezierMover movers[];
};

uniform uint patchCount;
uniform uint kept;
uniform uint moverCount;
uniform float stepSeconds;
uniform bool jumped;   // all that is known belongs to another time
uniform bool looksOn;  // the patches that are seen are stepped, too

bool apart(BezierPatch at, vec3 low, vec3 high) {
  return any(greaterThan(low, at.centre.xyz + at.reach.xyz)) || any(lessThan(high, at.centre.xyz - at.reach.xyz));
}

// 0: nothing may touch the patch; 1: something that lies still; 2: something that moves. Those that move come first.
uint mayTouch(BezierPatch at) {
  for (uint run = 0u; run * BEZIER_RUN < moverCount; ++run) {
    if (apart(at, runs[run].low.xyz, runs[run].high.xyz)) continue;
    uint end = min((run + 1u) * BEZIER_RUN, moverCount);
    for (uint i = run * BEZIER_RUN; i < end; ++i) {
      BezierMover mover = movers[i];
      vec3 low = min(min(mover.a.xyz, mover.b.xyz), min(mover.laterA.xyz, mover.laterB.xyz));
      vec3 high = max(max(mover.a.xyz, mover.b.xyz), max(mover.laterA.xyz, mover.laterB.xyz));
      if (apart(at, low - mover.a.w, high + mover.a.w)) continue;
      return mover.b.w > 0.5 ? 2u : 1u;
    }
  }
  return 0u;
}

void main() {
  uint index = gl_GlobalInvocationID.x;
  if (index >= patchCount) return;
  BezierClock clock = clocks[index];
  if (jumped) clock = BezierClock(0.0, 0u);
  uint hit = moverCount > 0u ? mayTouch(patches[index]) : 0u;
  bool due = clock.known < kept || clock.pending + stepSeconds > 0.0;
  if (due && (hit == 2u || (looksOn && seen[index] != 0u))) {
    uint place = hit != 0u ? patchCount - 1u - atomicAdd(touched, 1u) : atomicAdd(quiet, 1u);
    works[place] = BezierWork(index, min(clock.known, kept), clock.pending, hit == 2u ? 1u : 0u);
    clock = BezierClock(0.0, kept);
  } else {
    clock.pending += stepSeconds;
  }
  clocks[index] = clock;
}
