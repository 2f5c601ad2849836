#version 450 core
// Makes the plants of one species, a work-group for each cell of the world. All about a plant comes from hashes of its
// cell, its index and its species, so that it is the same wherever the camera stands.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/grass_blades.glsl"
#include "shaders/include/grass_patches.glsl"
#include "shaders/include/touched_near.glsl"
#include "shaders/include/virtual_wind.glsl"
#include "shaders/include/plant_pose.glsl"
#include "shaders/shared/plant_block.h"
#include "shaders/shared/hash.h"

layout(local_size_x = PLANT_GROUP) in;
layout(std430, binding = RENDER_SSBO_PLANTS) writeonly buffer Plants { PlantInstance plants[]; };
layout(std430, binding = RENDER_SSBO_PLANT_COMMANDS) buffer Commands { PlantCommand commands[]; };
layout(std430, binding = RENDER_SSBO_PLANT_KINDS) readonly buffer Kinds { PlantKind kinds[]; };

uniform int species;
uniform ivec2 firstCell;
uniform float detail;  // FrameQuality::detail
uniform float margin;  // m around the field
uniform int thinning;
uniform int culling;

shared uint levelCount[PLANT_LEVELS];
shared uint levelStart[PLANT_LEVELS];
shared uint levelRoom[PLANT_LEVELS];
shared uint candidates;

bool inView(vec3 centre, vec3 halfSize) {
  if (culling == 0) return true;
  for (int i = 0; i < 6; ++i) {
    vec4 plane = frame.frustum[i];
    if (dot(plane.xyz, centre) + plane.w < -dot(abs(plane.xyz), halfSize)) return false;
  }
  return true;
}

// Part of the candidates drawn where a metre covers so many pixels, 0..1. Thinned plants get wider, so that as much
// colour stays in the picture, until they are too low to be seen.
float keptPlants(PlantKind kind, float pixels) {
  if (thinning == 0) return 1.0;
  float wide = kind.size.w * kind.size.x * pixels / kind.levels.y * pow(detail, 0.75);
  float tall = smoothstep(1.0, 2.2, kind.size.x * pixels / kind.levels.z);
  return clamp(wide * wide, 0.0, 1.0) * tall;
}

float metresBeyond(vec2 world) {
  vec2 high = frame.field.xy + frame.field.zw;
  return length(max(max(frame.field.xy - world, world - high), vec2(0.0)));
}

// 1 in a patch, 0 between them; mean about 0.4. Species have patches of their own.
float patchAt(vec2 world, PlantKind kind) {
  vec2 own = vec2(kind.seed & 0xffu, (kind.seed >> 8u) & 0xffu) * 0.37;
  vec2 at = world / (5.0 * kind.growth.z) + own;
  float broad = textureLod(noiseTexture, at, 0.0).g;
  float ragged = textureLod(noiseTexture, world.yx / (1.3 * kind.growth.z), 0.0).r;
  return smoothstep(0.47, 0.60, 0.72 * broad + 0.28 * ragged);
}

// Ground height around a cell.
vec2 groundOver(vec2 low, float side) {
  if (groundIsFlat()) return vec2(0.0);
  float a = groundHeight(low), b = groundHeight(low + vec2(side, 0.0)), c = groundHeight(low + vec2(0.0, side)),
        d = groundHeight(low + side), e = groundHeight(low + 0.5 * side);
  float slack = 0.75 * side;
  return clamp(vec2(min(min(min(a, b), min(c, d)), e) - slack, max(max(max(a, b), max(c, d)), e) + slack), frame.groundRange.x, frame.groundRange.y);
}

uint candidatesOf(ivec2 cell, uint seed, PlantKind kind) {
  float side = kind.growth.w;
  float tall = kind.size.x * (1.0 + kind.size.y) * 2.0;
  vec2 low = vec2(cell) * side;
  vec2 level = groundOver(low, side);
  vec3 centre = vec3(low.x + 0.5 * side, 0.5 * (level.x + level.y + tall), low.y + 0.5 * side);
  vec3 halfSize = vec3(0.5 * side + tall, 0.5 * (level.y - level.x + tall), 0.5 * side + tall).xyz;
  if (!inView(centre, halfSize)) return 0u;
  if (metresBeyond(centre.xz) > margin + side) return 0u;
  float pixels = frame.pixelScale.x;
  if (!isOrthographic()) {
    float depth = dot(centre - frame.cameraPosition.xyz, frame.viewForward.xyz) - dot(abs(frame.viewForward.xyz), halfSize);
    // What is seen lies within the corners of the picture: not less deep than so much of its distance.
    float distance = length(max(abs(centre - frame.cameraPosition.xyz) - halfSize, vec3(0.0)));
    float corner = inversesqrt(1.0 + dot(frame.viewport.xy, frame.viewport.xy) / (4.0 * frame.pixelScale.x * frame.pixelScale.x));
    pixels /= max(max(depth, distance * corner), 0.05);
  }
  // The broken part of the mean is spread over the cells.
  uint total = uint(kind.growth.x + hashToUnit(pcgHash(seed ^ 0x51ed27u)));
  return min(total, uint(ceil(float(total) * keptPlants(kind, pixels))));
}

// Low-discrepancy places (the R2 sequence, Roberts 2018, shifted per cell), so that every first part of a cell's
// plants covers it evenly.
vec2 rootOf(ivec2 cell, uint index, uint seed, PlantKind kind) {
  uvec2 steps = (index + 1u) * uvec2(3242174889u, 2447445414u) + uvec2(pcgHash(seed), pcgHash(seed ^ 0x9e3779b9u));
  vec2 even = vec2(steps >> 8u) / 16777216.0;
  uint jitter = hashCombine(seed, index);
  vec2 noise = vec2(jitter & 0xffffu, jitter >> 16u) / 65536.0 - 0.5;
  vec2 within = fract(even + noise * 1.6 * inversesqrt(max(kind.growth.x, 1.0)));
  return (vec2(cell) + within) * kind.growth.w;
}

// The bend in this wind, with the inertia that all grass has where the project wants it. `factor` is F over its own stiffness.
vec2 steadyBend(vec2 root, vec2 rest, vec2 felt, float factor) {
  if (grass.size.w != GRASS_DEFORMATION_INERTIAL) return arcSteadyBend(rest, felt, factor);
  vec2 still = arcSteadyBend(rest, vec2(0.0), 0.0);
  return still + virtualLeans(root, still, factor).e[CHAIN_SEGMENTS - 1];
}

bool makePlant(ivec2 cell, uint index, uint seed, PlantKind kind, out PlantInstance plant, out uint level) {
  vec2 root = rootOf(cell, index, seed, kind);
  uint state = hashCombine(seed ^ 0x2545f491u, index);
  uint place = state;
  vec3 at = vec3(root.x, groundHeight(root), root.y);
  float pixels = pixelsPerMetre(at);
  float kept = keptPlants(kind, pixels);
  float rank = (float(index) + 0.5) / max(kind.growth.x, 1.0);
  float grown = thinning == 0 ? 1.0 : smoothstep(0.0, 1.0, (kept - rank) / (0.25 * kept));
  if (grown <= 0.0) return false;
  float tall = kind.size.x * (1.0 + kind.size.y) * 2.0;
  if (!inView(at + vec3(0.0, 0.5 * tall, 0.0), vec3(tall, 0.5 * tall, tall))) return false;
  SolidsNear solids = solidsNear(root);
  if (solids.distanceM < 0.04) return false;
  GroundLight ground = groundLight(root, pixels);

  float beyond = metresBeyond(root) / margin;
  float thin = beyond <= 0.0 ? 0.0 : max(beyond + 0.7 * (noiseAtLevel(root, 19.0, 1.0).r - 0.5), 0.0);
  float patches = mix(1.0, patchAt(root, kind), kind.growth.y);
  float grows = (1.0 - min(thin * thin, 1.0)) * patches * mapDensity(root) * slopeDensity(groundLight(root, 0.0).normal);
  if (unit(state) >= grows) return false;

  float tallness = (1.0 + kind.size.y * (2.0 * unit(state) - 1.0)) * mapHeight(root) * mix(1.0, 0.6, min(thin, 1.0));
  // At the rim of a patch plants are smaller.
  tallness *= mix(1.0, 0.8 + 0.2 * patches, kind.growth.y) * mix(0.4, 1.0, grown);
  if (tallness < 0.05) return false;
  float widen = clamp(inversesqrt(max(kept, 1e-4)), 1.0, kind.levels.w) * grown * (0.9 + 0.2 * unit(state));
  float yaw = 6.2831853 * unit(state);
  float phase = unit(state);
  float factor = kind.motion.x / (1.0 + kind.motion.y * (2.0 * unit(state) - 1.0));
  vec2 felt = rippledWind(root, smoothWind(root), kind.motion.z);
  vec2 touched;
  if (!touchedNear(root, touched)) return false;
  vec2 bend = steadyBend(root, plantRest(phase), felt, factor) + plantFlutter(felt, phase, kind.motion.z) + touched;

  float shadow = max(solids.shadowHeight, softened(ground.shadowHeight));
  vec3 up = normalize(mix(vec3(0.0, 1.0, 0.0), groundLight(root, 0.0).normal, kind.motion.w));
  plant.x = at.x;
  plant.y = at.y;
  plant.z = at.z;
  plant.sizes = packHalf2x16(vec2(tallness, widen));
  plant.bend = packHalf2x16(bend);
  plant.turn = packSnorm2x16(vec2(cos(yaw), sin(yaw)));
  plant.tilt = packSnorm2x16(up.xz);
  plant.shade = packHalf2x16(vec2(shadow, shadeForce(length(felt))));
  plant.tint = packUnorm4x8(vec4(0.5 * (0.86 + 0.28 * unit(state)), unit(state), openness(solids.distanceM), phase));
  plant.felt = packHalf2x16(felt);
  float slope = slopeLight(ground.normal, smoothstep(-0.15, 0.15, 0.3 * grass.baseColour.w - shadow));
  plant.canopy = packHalf2x16(vec2(grass.baseColour.w * mapHeight(root) * mix(1.0, 0.3, min(thin, 1.0)), slope));
  plant.place = place;
  // Each at a distance of its own, so that no line shows where the smaller mesh begins.
  level = tallness * kind.size.x * pixels * (0.85 + 0.3 * fract(phase * 5.7)) > kind.levels.x * inversesqrt(detail) ? 0u : 1u;
  return true;
}

// Takes room for the group's plants in each list, giving back what doesn't fit.
void takeRoom(uint level) {
  uint wanted = levelCount[level];
  if (wanted == 0u) return;
  uint command = uint(species) * PLANT_LEVELS + level;
  uint capacity = kinds[species].room[level];
  uint start = atomicAdd(commands[command].instances, wanted);
  uint room = start >= capacity ? 0u : min(wanted, capacity - start);
  if (room < wanted) atomicAdd(commands[command].instances, room - wanted);
  levelStart[level] = kinds[species].first[level] + start;
  levelRoom[level] = room;
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  PlantKind kind = kinds[species];
  ivec2 cell = firstCell + ivec2(gl_WorkGroupID.xy);
  uint seed = hashCombine(hashCombine(uint(cell.x), uint(cell.y)), kind.seed);
  if (lane == 0u) candidates = candidatesOf(cell, seed, kind);
  barrier();
  uint count = candidates;
  for (uint first = 0u; first < count; first += uint(PLANT_GROUP)) {
    if (lane < PLANT_LEVELS) levelCount[lane] = 0u;
    barrier();
    PlantInstance plant;
    uint level = 0u;
    uint slot = 0u;
    bool drawn = first + lane < count && makePlant(cell, first + lane, seed, kind, plant, level);
    if (drawn) slot = atomicAdd(levelCount[level], 1u);
    barrier();
    if (lane < PLANT_LEVELS) takeRoom(lane);
    barrier();
    if (drawn && slot < levelRoom[level]) plants[levelStart[level] + slot] = plant;
  }
}
