#version 450 core
// Lists the patches of Bezier grass that bezier_patches found, near ones first: for the first round those with large blades
// and, of the others, those whose first blades are drawn before the rest; for the second round the others. A thread looks at
// one.
#include "shaders/include/frame.glsl"
#include "shaders/include/bezier_work.glsl"

layout(local_size_x = BEZIER_CULL_GROUP) in;

shared uint firstOf[2u * BEZIER_BUCKETS];

void main() {
  uint lane = gl_LocalInvocationIndex;
  if (lane < 2u * BEZIER_BUCKETS) {
    uint round0 = lane / BEZIER_BUCKETS * BEZIER_BUCKETS;
    uint sum = 0u;
    for (uint i = round0; i < lane; ++i) sum += commands.buckets[i];
    firstOf[lane] = sum;
    // One group tells the culling how many there are.
    if (gl_WorkGroupID.x == 0u && lane == BEZIER_BUCKETS - 1u) commands.groupsNear[0] = sum + commands.buckets[lane];
    if (gl_WorkGroupID.x == 0u && lane == 2u * BEZIER_BUCKETS - 1u) commands.groupsFar[0] = sum + commands.buckets[lane];
  }
  barrier();
  uint at = gl_GlobalInvocationID.x;
  if (at >= uint(bezier.patches.x) || seen[at] == 0u) return;
  uint bucket = bucketOf(patches[at]);
  bool large = seen[at] == BEZIER_SEEN_LARGE;
  if (large || bezier.view.z > 0.0) seen[patchesNear(firstOf[bucket] + atomicAdd(commands.taken[bucket], 1u))] = at;
  bucket += BEZIER_BUCKETS;
  if (!large) seen[patchesFar(firstOf[bucket] + atomicAdd(commands.taken[bucket], 1u))] = at;
}
