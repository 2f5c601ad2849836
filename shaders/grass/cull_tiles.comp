#version 450 core
// Which tiles of the meadow may be seen, and how many of their blades at which level of detail. The chunks are listed by
// list_chunks, in the order of the tiles, so that equal frames are drawn in equal order.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/occluders.glsl"
#include "shaders/include/grass_work.glsl"

layout(local_size_x = GRASS_CULL_GROUP) in;
layout(std430, binding = RENDER_SSBO_GRASS_BOUNDS) readonly buffer Bounds { vec2 bounds[]; };  // of the ground in a tile, m

shared uint levelChunks[GRASS_LEVELS];

// Cosine between ground and view that no blade of the tile exceeds.
float mostFacing(vec3 centre, vec3 halfSize) {
  if (isOrthographic() || !groundIsFlat()) {
    vec3 n = groundLight(centre.xz, frame.pixelScale.x / max(length(centre - frame.cameraPosition.xyz), 1.0)).normal;
    float slack = groundIsFlat() ? 0.0 : 0.35;
    return clamp(dot(n, directionToCamera(centre)) + slack, 0.0, 1.0);
  }
  vec3 away = max(abs(centre - frame.cameraPosition.xyz) - halfSize, vec3(0.0));
  float up = abs(frame.cameraPosition.y - centre.y) + halfSize.y;
  return up / max(length(vec2(length(away.xz), up)), 1e-3);
}

// Blades, and the level in the upper bits.
uint workOf(ivec2 tile) {
  if (any(lessThan(tile, ivec2(grass.tileRange.xy))) || any(greaterThan(tile, ivec2(grass.tileRange.zw)))) return 0u;
  float tall = grass.size.y;
  vec2 low = tileLow(tile) - tall;
  vec2 high = low + grass.tiles.x + 2.0 * tall;
  vec2 level = vec2(0.0);
  if (!groundIsFlat()) {
    ivec2 at = tile - ivec2(grass.boundsRange.xy);
    level = bounds[at.y * int(grass.boundsRange.z) + at.x];
  }
  vec3 centre = vec3(0.5 * (low.x + high.x), 0.5 * (level.x + level.y + tall), 0.5 * (low.y + high.y));
  vec3 halfSize = vec3(0.5 * (high.x - low.x), 0.5 * (level.y - level.x + tall), 0.5 * (high.y - low.y));
  if (!insideFrustum(centre, halfSize) || isOccluded(centre, halfSize)) return 0u;
  float pixels = frame.pixelScale.x;
  if (!isOrthographic()) {
    float depth = dot(centre - frame.cameraPosition.xyz, frame.viewForward.xyz) - dot(abs(frame.viewForward.xyz), halfSize);
    // What is seen lies within the corners of the picture: not less deep than so much of its distance.
    float distance = length(max(abs(centre - frame.cameraPosition.xyz) - halfSize, vec3(0.0)));
    float corner = inversesqrt(1.0 + dot(frame.viewport.xy, frame.viewport.xy) / (4.0 * frame.pixelScale.x * frame.pixelScale.x));
    pixels /= max(max(depth, distance * corner), 0.05);
  }
  uint blades = bladesInTile(tileHash(tile));
  uint count = min(blades, uint(ceil(float(blades) * keptPart(pixels, mostFacing(centre, halfSize)))));
  // The strips take on each other's shape by the same size, see blade.vert.
  float size = grass.baseColour.w * pixels;
  uint detail = size > grass.levels.x ? 0u : size > grass.levels.y ? 1u : 2u;
  return count | detail << GRASS_WORK_LEVEL;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint n = gl_GlobalInvocationID.x;
  if (lane < GRASS_LEVELS) levelChunks[lane] = 0u;
  barrier();
  if (n < tilesInRings()) {
    uint work = workOf(tileInRings(n));
    tileWork[n] = work;
    uint chunks = chunksOfWork(work);
    if (chunks > 0u) atomicAdd(levelChunks[work >> GRASS_WORK_LEVEL], chunks);
  }
  barrier();
  if (lane == 0u) groupWork[gl_WorkGroupID.x] = uvec4(levelChunks[0], levelChunks[1], levelChunks[2], 0u);
}
