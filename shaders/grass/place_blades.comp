#version 450 core
// Makes the blades of the visible chunks: root, size and colour from hashes of tile and index (so that a
// blade is the same wherever the camera stands), bend from the wind of its group. Each goes to the list
// of its level of detail.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = RENDER_SSBO_CHUNKS) readonly buffer Chunks { GrassChunk chunks[]; };
layout(std430, binding = RENDER_SSBO_BLADES) writeonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = RENDER_SSBO_COMMANDS) buffer Commands { GrassCommands commands; };

shared uint levelCount[GRASS_LEVELS];
shared uint levelStart[GRASS_LEVELS];
shared uint levelRoom[GRASS_LEVELS];

const float kClumpM = 0.75;
const float kMaxRestBend = 0.75;  // rad

float unit(inout uint state) {
  state = pcgHash(state);
  return hashToUnit(state);
}

// The clump a root belongs to: the nearest of jittered centres, as a hash.
uint clumpOf(vec2 root) {
  ivec2 cell = ivec2(floor(root / kClumpM));
  float nearest = 1e9;
  uint found = 0u;
  for (int z = -1; z <= 1; ++z) {
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = cell + ivec2(x, z);
      uint hash = hashCombine(hashCombine(uint(at.x), uint(at.y)), uint(grass.droop.w));
      vec2 away = (vec2(at) + vec2(hash & 0xffffu, hash >> 16u) / 65536.0) * kClumpM - root;
      float d = dot(away, away);
      if (d < nearest) {
        nearest = d;
        found = hash;
      }
    }
  }
  return found;
}

// Low-discrepancy root positions (the R2 sequence, Roberts 2018, shifted per tile): every first part of the
// list covers the tile evenly, so that thinning leaves no holes.
vec2 rootInTile(uint tile, uint index, uint seed) {
  uvec2 steps = (index + 1u) * uvec2(3242174889u, 2447445414u) + uvec2(pcgHash(seed), pcgHash(seed ^ 0x9e3779b9u));
  vec2 even = vec2(steps >> 8u) / 16777216.0;
  uint jitter = hashCombine(seed, index);
  vec2 noise = vec2(jitter & 0xffffu, jitter >> 16u) / 65536.0 - 0.5;
  return tileLow(tile) + fract(even + noise * 0.8 * inversesqrt(max(grass.tiles.w, 1.0))) * grass.tiles.z;
}

// How far in the margin around the field, 0..1 and more; ragged.
float inMargin(vec2 root) {
  float beyond = beyondField(root);
  return beyond <= 0.0 ? 0.0 : max(beyond / grass.tileOrigin.z + 0.7 * (noiseAtLevel(root, 19.0, 1.0).r - 0.5), 0.0);
}

// The colour of a blade that is too small on screen to be lit for itself: the meadow's, so that blades and ground
// agree, tinted by how the blade differs from its neighbours.
vec3 colourFromAfar(vec3 place, vec2 felt, SolidsNear solids, float slope, vec3 ownTint) {
  vec2 root = place.xz;
  vec2 patchTint = meadowPatch(root);
  vec3 mean = bladeAlbedo(0.7, patchTint.x * grass.dryColour.w, patchTint.y, 0.0);
  vec3 own = bladeAlbedo(0.7, ownTint.x, ownTint.y, ownTint.z);
  float sunlit = smoothstep(-0.15, 0.15, 0.3 * grass.baseColour.w - solids.shadowHeight);
  vec3 light = meadowColour(root, felt, directionToCamera(place), sunlit) * mix(openness(solids.distanceM), 1.0, 0.5);
  return toPicture(throughAir(light * slope * clamp(own / mean, 0.5, 1.8), place));
}

// Undone by blade.vert.
uint packFacing(vec2 facing, float height) {
  float part = (height - frame.groundRange.x) / max(frame.groundRange.y - frame.groundRange.x, 1e-6);
  return (packSnorm4x8(vec4(facing, 0.0, 0.0)) & 0xffffu) | uint(clamp(part, 0.0, 1.0) * 65535.0 + 0.5) << 16u;
}

bool makeBlade(uint tile, uint index, uint total, out GrassBlade blade, out uint level) {
  uint seed = tileHash(tile);
  vec2 root = rootInTile(tile, index, seed);
  uint state = hashCombine(seed ^ 0x2545f491u, index);
  vec3 place = vec3(root.x, groundHeight(root), root.y);
  float pixels = pixelsPerMetre(place);
  float kept = keptPart(pixels);
  float rank = (float(index) + 0.5) / float(total);
  float grown = smoothstep(0.0, 1.0, (kept - rank) / (0.25 * kept));
  if (grown <= 0.0) return false;
  if (!insideFrustum(place + vec3(0.0, 0.5 * grass.size.y, 0.0), vec3(grass.size.y, 0.5 * grass.size.y, grass.size.y))) return false;
  float margin = inMargin(root);
  if (unit(state) < margin * margin) return false;
  SolidsNear solids = solidsNear(root);
  float solid = solids.distanceM;
  if (solid < 0.02) return false;
  GroundLight ground = groundLight(root, pixels);
  solids.shadowHeight = max(solids.shadowHeight, softened(ground.shadowHeight));

  uint clump = clumpOf(root);
  uint clumpState = pcgHash(clump);
  float shareClump = grass.size.z;
  float size = mix(unit(state), unit(clumpState), shareClump * 0.7);
  float height = grass.baseColour.w * (1.0 + grass.tipColour.w * (2.0 * size - 1.0)) * mix(0.55, 1.0, grown);
  height *= 0.6 + 0.4 * smoothstep(0.0, 0.5, solid);
  float canopy = mix(1.0, 0.3, smoothstep(0.0, 0.8, margin));
  canopy *= 1.0 + 0.5 * shareClump * (noiseAtLevel(root, 13.0, 1.0).g - 0.5);
  height *= canopy;
  float widen = clamp(1.1 / max(kept, 1e-3), 1.0, grass.cover.y);
  float width = grass.size.x * widen * grown * (0.8 + 0.4 * unit(state));

  float yaw = 6.2831853 * unit(state);
  float lean = 6.2831853 * unit(clumpState);
  vec2 facing = normalize(vec2(cos(yaw), sin(yaw)) + shareClump * 0.8 * vec2(cos(lean), sin(lean)) + vec2(1e-4));
  float factor = grass.motion.x / (1.0 + grass.motion.y * (2.0 * unit(state) - 1.0));
  vec2 wind = groupWind(root);
  vec2 felt = rippledWind(root, wind, grass.motion.z);
  vec2 bend = felt * factor;
  if (grass.size.w == GRASS_DEFORMATION_ARC) {
    // The droop of eq. 11 as a rest bend: k2 moves the tip forward by k2 of the height.
    vec2 rest = facing * min(grass.droop.y * 1.38 * (0.7 + 4.5 * unit(state) * unit(state)), kMaxRestBend);
    bend = arcSteadyBend(rest, felt, factor) + arcFlutter(felt, frame.viewForward.w, unit(state), 0.75 + 0.5 * unit(state), grass.motion.z);
  }

  vec2 patchTint = meadowPatch(root);
  float dryClump = step(1.0 - grass.dryColour.w * (0.4 + 1.2 * patchTint.x), mix(unit(state), unit(clumpState), 0.6 * shareClump + 0.2));
  float dry = clamp(dryClump * (0.45 + 0.5 * unit(state)) + 0.15 * patchTint.x, 0.0, 1.0);
  float bright = patchTint.y * (0.78 + 0.44 * mix(unit(state), unit(clumpState), 0.5 * shareClump));
  float hue = 2.0 * mix(unit(state), unit(clumpState), 0.7 * shareClump) - 1.0;

  float slope = slopeLight(ground.normal, smoothstep(-0.15, 0.15, 0.3 * grass.baseColour.w - solids.shadowHeight));
  blade.x = root.x;
  blade.z = root.y;
  blade.sizes = packHalf2x16(vec2(height, width));
  blade.facing = packFacing(facing, place.y);
  blade.bend = packHalf2x16(bend);
  blade.shade = packHalf2x16(vec2(solids.shadowHeight, shadeForce(length(felt))));
  blade.tint = packUnorm4x8(vec4(dry, 0.5 * bright * slope, 0.5 + 0.5 * hue, openness(solid)));
  blade.canopy = packUnorm4x8(vec4(0.5 * canopy, colourFromAfar(place, felt, solids, slope, vec3(dry, bright, hue))));
  float tall = height * pixels;
  level = tall > grass.levels.x ? 0u : tall > grass.levels.y ? 1u : 2u;
  return true;
}

uint listStart(uint level) {
  return level == 0u ? 0u : level == 1u ? uint(grass.capacity.x) : uint(grass.capacity.x) + uint(grass.capacity.y);
}

// Takes room for the group's blades in each list, giving back what doesn't fit.
void takeRoom(uint level) {
  uint wanted = levelCount[level];
  if (wanted == 0u) return;
  uint capacity = uint(grass.capacity[level]);
  uint start = atomicAdd(commands.draws[level * 4u + 1u], wanted);
  uint room = start >= capacity ? 0u : min(wanted, capacity - start);
  if (room < wanted) atomicAdd(commands.draws[level * 4u + 1u], room - wanted);
  levelStart[level] = listStart(level) + start;
  levelRoom[level] = room;
}

void main() {
  uint lane = gl_LocalInvocationID.x;
  uint run = gl_WorkGroupID.y * GRASS_GROUPS_X + gl_WorkGroupID.x;
  if (lane < GRASS_LEVELS) levelCount[lane] = 0u;
  barrier();
  GrassBlade blade;
  uint level = 0u;
  uint slot = 0u;
  bool drawn = false;
  if (run < commands.chunks) {
    GrassChunk chunk = chunks[run];
    drawn = lane < chunk.count && makeBlade(chunk.tile, chunk.first + lane, bladesInTile(chunk.tile), blade, level);
    if (drawn) slot = atomicAdd(levelCount[level], 1u);
  }
  barrier();
  if (lane < GRASS_LEVELS) takeRoom(lane);
  barrier();
  if (drawn && slot < levelRoom[level]) blades[levelStart[level] + slot] = blade;
}
