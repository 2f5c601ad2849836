#version 450 core
// From chunks in each work-group of tiles to where its first one stands in the list, and the commands that place and draw.
#include "shaders/include/frame.glsl"
#include "shaders/shared/grass_block.h"
#include "shaders/include/grass_work.glsl"

layout(local_size_x = GRASS_CULL_GROUP) in;
layout(std430, binding = RENDER_SSBO_COMMANDS) buffer Commands { GrassCommands commands; };
uniform uint groups;
uniform uint chunkLimit;

shared uvec4 sums[GRASS_CULL_GROUP];

uint levelStart(uvec4 total, uint level) { return level == 0u ? 0u : level == 1u ? total.x : total.x + total.y; }

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint run = (groups + GRASS_CULL_GROUP - 1u) / GRASS_CULL_GROUP;
  uint first = min(lane * run, groups);
  uint last = min(first + run, groups);
  uvec4 sum = uvec4(0u);
  for (uint g = first; g < last; ++g) sum += groupWork[g];
  sums[lane] = sum;
  barrier();
  for (uint step = 1u; step < GRASS_CULL_GROUP; step <<= 1u) {
    uvec4 before = lane >= step ? sums[lane - step] : uvec4(0u);
    barrier();
    sums[lane] += before;
    barrier();
  }
  uvec4 at = sums[lane] - sum;
  for (uint g = first; g < last; ++g) {
    uvec4 own = groupWork[g];
    groupWork[g] = at;
    at += own;
  }
  if (lane != 0u) return;
  uvec4 total = sums[GRASS_CULL_GROUP - 1u];
  uint chunks = min(total.x + total.y + total.z, chunkLimit);
  commands.chunks = chunks;
  uint work = (chunks + GRASS_CHUNKS_A_GROUP - 1u) / GRASS_CHUNKS_A_GROUP;
  commands.groupsX = GRASS_GROUPS_X;
  commands.groupsY = (work + GRASS_GROUPS_X - 1u) / GRASS_GROUPS_X;
  commands.groupsZ = 1u;
  commands.blades = 0u;  // place_blades counts them
  const uint kSegments[GRASS_LEVELS] = uint[GRASS_LEVELS](6u, 3u, 1u);
  for (uint level = 0u; level < GRASS_LEVELS; ++level) {
    commands.draws[5u * level] = GRASS_CHUNK * 3u * (2u * kSegments[level] - 1u);
    commands.draws[5u * level + 2u] = 0u;
    commands.draws[5u * level + 3u] = 0u;
    commands.draws[5u * level + 4u] = 0u;
    uint start = min(levelStart(total, level), chunkLimit);
    commands.starts[level] = start;
    commands.draws[5u * level + 1u] = min(levelStart(total, level) + total[level], chunkLimit) - start;
  }
}
