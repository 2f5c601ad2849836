#version 450 core
// Lists the chunks of the tiles: level by level, near tiles first.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/grass_work.glsl"

layout(local_size_x = GRASS_CULL_GROUP) in;
layout(std430, binding = RENDER_SSBO_CHUNKS) writeonly buffer Chunks { GrassChunk chunks[]; };
layout(std430, binding = RENDER_SSBO_COMMANDS) readonly buffer Commands { GrassCommands commands; };

shared uvec4 sums[GRASS_CULL_GROUP];

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint n = gl_GlobalInvocationID.x;
  uint work = n < tilesInRings() ? tileWork[n] : 0u;
  uint own = chunksOfWork(work);
  uint level = work >> GRASS_WORK_LEVEL;
  sums[lane] = uvec4(level == 0u ? own : 0u, level == 1u ? own : 0u, level == 2u ? own : 0u, 0u);
  barrier();
  for (uint step = 1u; step < GRASS_CULL_GROUP; step <<= 1u) {
    uvec4 before = lane >= step ? sums[lane - step] : uvec4(0u);
    barrier();
    sums[lane] += before;
    barrier();
  }
  if (own == 0u) return;
  ivec2 tile = tileInRings(n);
  uint blades = bladesOfWork(work);
  uint at = commands.starts[level] + groupWork[gl_WorkGroupID.x][level] + sums[lane][level] - own;
  for (uint run = 0u; run < own && at + run < commands.chunks; ++run) {
    uint first = run * GRASS_CHUNK;
    chunks[at + run] = GrassChunk(tile.x, tile.y, first, min(GRASS_CHUNK, blades - first));
  }
}
