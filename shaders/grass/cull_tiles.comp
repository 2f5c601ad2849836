#version 450 core
// Which tiles of the meadow may be seen, and how many of their blades: appends chunks for place_blades.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = RENDER_SSBO_CHUNKS) writeonly buffer Chunks { GrassChunk chunks[]; };
layout(std430, binding = RENDER_SSBO_COMMANDS) buffer Commands { GrassCommands commands; };
layout(std430, binding = RENDER_SSBO_GRASS_BOUNDS) readonly buffer Bounds { vec2 bounds[]; };  // of the ground in a tile, m

void main() {
  uint tile = gl_GlobalInvocationID.x;
  if (tile >= tileCount()) return;
  float tall = grass.size.y;
  vec2 low = tileLow(tile) - tall;
  vec2 high = low + grass.tiles.z + 2.0 * tall;
  vec2 level = groundIsFlat() ? vec2(0.0) : bounds[tile];
  vec3 centre = vec3(0.5 * (low.x + high.x), 0.5 * (level.x + level.y + tall), 0.5 * (low.y + high.y));
  vec3 halfSize = vec3(0.5 * (high.x - low.x), 0.5 * (level.y - level.x + tall), 0.5 * (high.y - low.y));
  if (!insideFrustum(centre, halfSize)) return;

  float pixels = frame.pixelScale.x;
  if (!isOrthographic()) {
    float depth = dot(centre - frame.cameraPosition.xyz, frame.viewForward.xyz);
    pixels /= max(depth - dot(abs(frame.viewForward.xyz), halfSize), 0.05);
  }
  uint blades = bladesInTile(tile);
  uint count = min(blades, uint(ceil(float(blades) * keptPart(pixels))));
  if (count == 0u) return;
  uint runs = (count + GRASS_CHUNK - 1u) / GRASS_CHUNK;
  uint at = atomicAdd(commands.chunks, runs);
  atomicMax(commands.groupsY, (at + runs + GRASS_GROUPS_X - 1u) / GRASS_GROUPS_X);
  for (uint run = 0u; run < runs; ++run) {
    uint first = run * GRASS_CHUNK;
    chunks[at + run] = GrassChunk(tile, first, min(GRASS_CHUNK, count - first), 0u);
  }
}
