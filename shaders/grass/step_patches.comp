#version 450 core
// Blades of patches, after Belyaev, Laevsky & Chukanov 2011: what bent them fades as a damped swing around the pose that
// they have in a block, so that a patch which has settled looks as its block does; then they are bent out of all that
// touches them, and what was bent stands still.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/grass_blades.glsl"
#include "shaders/include/virtual_wind.glsl"
#include "shaders/include/blade_chain.glsl"
#include "shaders/include/blade_pose.glsl"
#define PATCH_STATE_ACCESS
#include "shaders/include/grass_patches.glsl"
#include "shaders/shared/chain_contact.h"

layout(local_size_x = PATCH_GROUP) in;
layout(std430, binding = RENDER_SSBO_PATCHES) readonly buffer Patches { GrassPatch patches[]; };
layout(std430, binding = RENDER_SSBO_PRIMITIVES) readonly buffer Primitives { ColliderPrimitive primitives[]; };

// What may touch the patch: places in primitives[].
struct Near {
  uint first, end;
};

uniform float dtSeconds;
uniform float swingStiffness;  // k/J, 1/s^2
uniform float swingDamping;    // 1/s

// Spring and damping of one joint over the step.
vec4 swung(vec4 joint, float rate, float keep) {
  vec3 psi = vec3(joint.x, 0.0, joint.y) * keep;
  vec3 omega = vec3(joint.z, 0.0, joint.w) * keep;
  if (psi == vec3(0.0) && omega == vec3(0.0)) return vec4(0.0);
  float stiffness = swingStiffness * rate * rate;
  int parts = dtSeconds > 0.0 ? chainParts(dtSeconds, stiffness) : 0;
  for (int part = 0; part < parts; ++part) {
    float dt = dtSeconds / float(parts);
    vec3 mean = chainMeanOmega(psi, omega, vec3(0.0), stiffness, swingDamping * rate, dt);
    omega = 2.0 * mean - omega;
    psi += mean * dt;
  }
  return vec4(psi.xz, omega.xz);
}

// A kink spreads along the blade and leaves the tip's lean as it is: of a bent rod the higher modes die out first, the second
// being six times as fast as the swing: 31 and 0.33 give the slowest of four joints that rate, as far as a step allows.
void evenOut(inout vec4 joints[CHAIN_SEGMENTS], float rate) {
  float part = 0.33 * (1.0 - exp(-31.0 * rate * sqrt(swingStiffness) * dtSeconds));
  vec4 carried = vec4(0.0);
  for (int i = 0; i + 1 < CHAIN_SEGMENTS; ++i) {
    vec4 upwards = (joints[i] - joints[i + 1]) * part;
    joints[i] += carried - upwards;
    carried = upwards;
  }
  joints[CHAIN_SEGMENTS - 1] += carried;
}

// A primitive as the blade sees it.
ColliderPrimitive seenFrom(ColliderPrimitive primitive, vec3 root, vec3 normal) {
  return ColliderPrimitive(vec4(unplanted(primitive.a.xyz - root, normal), primitive.a.w),
                           vec4(unplanted(primitive.b.xyz - root, normal), 0.0));
}

ContactChain chainOf(BladeRoot own, BladePose pose, float height, vec2 turned[CHAIN_SEGMENTS]) {
  ContactChain chain;
  chain.bent = 0u;
  vec3 before = vec3(0.0);
  vec2 lean = vec2(0.0);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec3 next = posePoint(pose.bend, own.facing, float(i + 1) / float(CHAIN_SEGMENTS));
    chain.size[i] = max(length(next - before), 1e-4) * height;
    chain.part[i] = normalize(next - before + vec3(0.0, 1e-6, 0.0));
    lean += turned[i];
    chain.lean[i] = pose.leans.e[i] + lean;
    before = next;
  }
  return chain;
}

// The next primitive from n on that a blade of this reach can touch, or `end`. Looking for it before the work is
// done, not leaving the work out where it isn't needed, lets processors that step through blades together skip it as well.
uint nextNear(uint n, uint end, vec3 root, float reach) {
  while (n < end && colliderDistance(primitives[n], root) > reach + 2.0 * CONTACT_MARGIN) ++n;
  return n;
}

// Bends the blade out of everything; false: its root is inside, or there is no way out.
bool touched(inout ContactChain chain, Near near, vec3 root, vec3 normal, float reach) {
  for (int pass = 0; pass < CONTACT_PASSES; ++pass) {
    bool clear = true;
    for (uint n = nextNear(near.first, near.end, root, reach); n < near.end; n = nextNear(n + 1u, near.end, root, reach)) {
      ColliderPrimitive primitive = seenFrom(primitives[n], root, normal);
      if (rootInside(primitive)) return false;
      if (chainDistance(chain, primitive) >= 0.97 * CONTACT_MARGIN) continue;
      chain = bentOut(chain, primitive);
      clear = false;
    }
    if (clear) return true;
  }
  for (uint n = nextNear(near.first, near.end, root, reach); n < near.end; n = nextNear(n + 1u, near.end, root, reach)) {
    if (chainDistance(chain, seenFrom(primitives[n], root, normal)) < 0.9 * CONTACT_MARGIN) return false;
  }
  return true;
}

// Bends a blade out of what touches it; false: it is hidden.
bool bentOutOfAll(BladeRoot own, Near near, inout vec4 joints[CHAIN_SEGMENTS]) {
  vec3 root = vec3(own.root.x, groundHeight(own.root), own.root.y);
  if (nextNear(near.first, near.end, root, own.height * 1.25 * max(mapHeight(own.root), 1.0)) == near.end) return true;
  float height = standingHeight(own);
  BladePose pose = blockPose(own, rippledWind(own.root, groupWind(own.root), grass.motion.z));
  ContactChain chain = chainOf(own, pose, height, vec2[](joints[0].xy, joints[1].xy, joints[2].xy, joints[3].xy));
  if (!touched(chain, near, root, groundNormal(own.root), height)) return false;
  vec2 below = vec2(0.0);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec2 lean = chain.lean[i] - pose.leans.e[i];
    if ((chain.bent & (1u << uint(i))) != 0u) joints[i] = vec4(lean - below, 0.0, 0.0);
    below = lean;
  }
  return true;
}

void main() {
  GrassPatch tile = patches[gl_WorkGroupID.y];
  uint index = gl_GlobalInvocationID.x;
  ivec2 cell = ivec2(tile.x, tile.z);
  uint hash = tileHash(cell);
  uint total = bladesInTile(hash);
  if (index >= min(total, patchTable.stride)) return;
  float rate = patchRate(hash, index);

  vec4 joints[CHAIN_SEGMENTS];
  bool hidden = patchState[patchStateAt(tile.slot, index, 0)].x > 0.5 * PATCH_HIDDEN;
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    joints[i] = tile.keep <= 0.0 || hidden ? vec4(0.0) : swung(patchState[patchStateAt(tile.slot, index, i)], rate, tile.keep);
  }

  evenOut(joints, rate);

  hidden = false;
  if (tile.count != 0u) hidden = !bentOutOfAll(bladeRoot(cell, index, total), Near(tile.first, tile.first + tile.count), joints);
  if (hidden) joints = vec4[](vec4(PATCH_HIDDEN, 0.0, 0.0, 0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) patchState[patchStateAt(tile.slot, index, i)] = joints[i];
}
