#version 450 core
// Makes the blades of the visible chunks: root, size and colour from hashes of tile and index (so that a blade is the same
// wherever the camera stands), bend from the wind of its group. A chunk's blades keep their order and close up.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/include/occluders.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/colliders.glsl"
#include "shaders/include/grass_blades.glsl"
#include "shaders/shared/segment_chain.h"
#ifdef CHAINS
#include "shaders/include/virtual_wind.glsl"
#endif
#include "shaders/include/blade_chain.glsl"
#include "shaders/include/blade_pose.glsl"
#include "shaders/include/blade_shape.glsl"
#include "shaders/include/blade_light.glsl"
#ifdef CHAINS
#include "shaders/include/grass_patches.glsl"
#endif

layout(local_size_x = GRASS_CHUNK * GRASS_CHUNKS_A_GROUP) in;
layout(std430, binding = RENDER_SSBO_CHUNKS) buffer Chunks { GrassChunk chunks[]; };
layout(std430, binding = RENDER_SSBO_BLADES) writeonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = RENDER_SSBO_COMMANDS) buffer Commands { GrassCommands commands; };
layout(std430, binding = RENDER_SSBO_CHAINS) writeonly buffer Chains { uvec4 chains[]; };  // half2: leans of the segments

shared uint drawnLanes[GRASS_CHUNKS_A_GROUP];  // bit by lane of the chunk

const float kFootLit = 0.2, kTipLit = 0.7;  // along a blade: stand for its foot and tip
const float kMeanLit = 0.44, kMeanCalm = 0.1;  // and what lies between them for all of it; less where it stands upright

// The colour of a blade that is too small on screen to be lit at every vertex: lit at two places.
void lightFromAfar(inout GrassBlade blade, BladeLook look, float share, float single, float hidden, vec3 root, BladePose pose, vec2 facing) {
  vec3 v = directionToCamera(root + vec3(0.0, 0.5 * look.height, 0.0));
  vec3 side = bladeSide(pose.bend, facing, v);
  // Blades that stand for those they hide look as these do: seen from the top down.
  float depth = seenDepth(v.y);
  float crowd = 1.0 - single * (1.0 - hidden);
  const vec3 up = vec3(0.0, 1.0, 0.0);
  vec3 colours[2];
  for (int i = 0; i < 2; ++i) {
    float s = i == 0 ? mix(kFootLit, 1.0 - 0.85 * depth, crowd) : mix(kTipLit, 1.0 - 0.15 * depth, crowd);
    Spine spine = spineAt(pose.bend, blade.chain != 0u, pose.leans, s, facing, look.height);
    vec3 tangent = planted(spine.tangent, look.ground);
    vec3 place = planted(spine.position, look.ground);
    vec3 light = 0.5 * (bladeLight(look, place.y, tangent, s, side, -0.7, v, up) + bladeLight(look, place.y, tangent, s, side, 0.7, v, up));
    if (single < 1.0) {
      vec3 other = bladeSide(pose.bend, vec2(facing.y, -facing.x), v);
      vec3 more = 0.5 * (bladeLight(look, place.y, tangent, s, other, -0.7, v, up) + bladeLight(look, place.y, tangent, s, other, 0.7, v, up));
      light = mix(light, more, 0.5 - 0.5 * single);
    }
    colours[i] = toPicture(throughAir(light, root));
  }
  // What is left of dark feet and light tips where many blades share a pixel.
  float calm = 1.0 - smoothstep(0.0, 0.5, length(pose.bend + pose.leans.e[CHAIN_SEGMENTS - 1]));
  vec3 mean = mix(colours[0], colours[1], kMeanLit - kMeanCalm * calm);
  float contrast = mix(0.25, 1.0, single);
  blade.foot = packUnorm4x8(vec4(mix(mean, colours[0], contrast), 0.5 * share));
  blade.tip = packUnorm4x8(vec4(mix(mean, colours[1], contrast), hidden));
}

// Undone by blade.vert.
uint packFacing(vec2 facing, uint species, float height) {
  float turn = fract(atan(facing.y, facing.x) / 6.2831853);
  float part = (height - frame.groundRange.x) / max(frame.groundRange.y - frame.groundRange.x, 1e-6);
  return (uint(turn * 2048.0) & 2047u) | species << 11u | uint(clamp(part, 0.0, 1.0) * 65535.0 + 0.5) << 16u;
}

// The blade's pose, with what of it objects have bent; false: it is hidden under one.
bool poseOf(BladeRoot own, vec2 felt, int patchSlot, uint index, out BladePose pose, out bool chained) {
  pose = blockPose(own, felt);
  chained = false;
#ifdef CHAINS
  chained = grass.size.w == GRASS_DEFORMATION_INERTIAL;
  if (patchSlot < 0) return true;
  ChainLeans touched;
  if (!patchLeans(patchSlot, index, touched)) return false;
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    pose.leans.e[i] += touched.e[i];
    chained = chained || touched.e[i] != vec2(0.0);
  }
#endif
  return true;
}

uvec4 packLeans(ChainLeans leans) {
  return uvec4(packHalf2x16(leans.e[0]), packHalf2x16(leans.e[1]), packHalf2x16(leans.e[2]), packHalf2x16(leans.e[3]));
}

bool makeBlade(ivec2 tile, uint index, uint total, int patchSlot, out GrassBlade blade, out uvec4 leans) {
  BladeRoot own = bladeRoot(tile, index, total);
  vec2 root = own.root;
  vec3 place = vec3(root.x, groundHeight(root), root.y);
  float pixels = pixelsPerMetre(place);
  GroundLight ground = groundLight(root, pixels);
  float facingCamera = dot(ground.normal, directionToCamera(place));
  float kept = keptPart(pixels, facingCamera);
  float grown = smoothstep(0.0, 1.0, (kept - own.rank) / (0.25 * kept));
  if (grown <= 0.0) return false;
  vec3 middle = place + vec3(0.0, 0.5 * grass.size.y, 0.0);
  vec3 reach = vec3(grass.size.y, 0.5 * grass.size.y, grass.size.y);
  if (!insideFrustum(middle, reach) || isOccluded(middle, reach)) return false;
  uint state = own.state;
  float margin = inMargin(root);
  if (unit(state) < margin * margin) return false;
  if (unit(state) >= mapDensity(root) * slopeDensity(ground.normal)) return false;
  SolidsNear solids = solidsNear(root);
  float solid = solids.distanceM;
  if (solid < 0.02) return false;
  solids.shadowHeight = max(solids.shadowHeight, softened(ground.shadowHeight));

  uint clumpState = pcgHash(own.clump ^ 0x68bc21ebu);
  float shareClump = grass.size.z;
  float canopy = canopyAround(root, margin);
  float height = own.height * mix(0.55, 1.0, grown) * (0.6 + 0.4 * smoothstep(0.0, 0.5, solid)) * canopy;
  float width = grass.species[own.species].form.x * bladeWidening(pixels) * grown * (0.8 + 0.4 * unit(state));

  vec2 facing = own.facing;
  vec2 felt = rippledWind(root, groupWind(root), grass.motion.z);
  BladePose pose;
  bool chained;
  if (!poseOf(own, felt, patchSlot, index, pose, chained)) return false;
  leans = packLeans(pose.leans);

  // A blade that stands for many takes on what they have in common.
  float single = singleness(pixels);
  vec2 patchTint = meadowPatch(root);
  float dryPart = grass.dryColour.w * (0.4 + 1.2 * patchTint.x);
  float dryOwn = step(1.0 - dryPart, mix(unit(state), unit(clumpState), 0.6 * shareClump + 0.2)) * (0.45 + 0.5 * unit(state));
  float dry = clamp(mix(0.38 * dryPart, dryOwn, single) + 0.15 * patchTint.x, 0.0, 1.0);
  float bright = patchTint.y * (0.78 + 0.44 * mix(mix(0.5, unit(state), single), unit(clumpState), 0.5 * shareClump));
  float hue = 2.0 * mix(mix(0.5, unit(state), single), unit(clumpState), 0.7 * shareClump) - 1.0;

  float slope = slopeLight(ground.normal, smoothstep(-0.15, 0.15, 0.3 * grass.baseColour.w - solids.shadowHeight));
  blade.x = root.x;
  blade.z = root.y;
  blade.sizes = packHalf2x16(vec2(height, width));
  blade.facing = packFacing(facing, own.species, place.y);
  blade.bend = packHalf2x16(pose.bend);
  blade.shade = packHalf2x16(vec2(solids.shadowHeight, shadeForce(length(felt))));
  blade.tint = packUnorm4x8(vec4(dry, 0.5 * bright * slope * colliderShade(middle), 0.5 + 0.5 * hue, openness(solid)));
  blade.chain = chained ? 1u : 0u;
  float share = canopy * grass.species[own.species].base.w / grass.baseColour.w;
  BladeLook look = BladeLook(own.species, height, canopyOf(share), closedOf(share), solids.shadowHeight, shadeForce(length(felt)), unpackUnorm4x8(blade.tint), ground.normal, mapColour(root));
  lightFromAfar(blade, look, share, single, hiddenPart(facingCamera), place, pose, facing);
  return true;
}

void main() {
  uint part = gl_LocalInvocationID.x / GRASS_CHUNK;
  uint lane = gl_LocalInvocationID.x % GRASS_CHUNK;
  uint at = (gl_WorkGroupID.y * GRASS_GROUPS_X + gl_WorkGroupID.x) * GRASS_CHUNKS_A_GROUP + part;
  if (lane == 0u) drawnLanes[part] = 0u;
  barrier();
  GrassBlade blade;
  uvec4 leans;
  bool drawn = false;
  bool valid = at < commands.chunks;
  if (valid) {
    GrassChunk chunk = chunks[at];
    ivec2 tile = ivec2(chunk.x, chunk.z);
    int patchSlot = -1;
#ifdef CHAINS
    patchSlot = patchOf(tile);
#endif
    drawn = lane < chunk.count && makeBlade(tile, chunk.first + lane, bladesInTile(tileHash(tile)), patchSlot, blade, leans);
    if (drawn) atomicOr(drawnLanes[part], 1u << lane);
  }
  barrier();
  uint lanes = drawnLanes[part];
  if (drawn) {
    uint slot = at * GRASS_CHUNK + uint(bitCount(lanes & ((1u << lane) - 1u)));
    blades[slot] = blade;
#ifdef CHAINS
    if (blade.chain != 0u) chains[slot] = leans;
#endif
  }
  if (valid && lane == 0u) {
    chunks[at].count = uint(bitCount(lanes));
    atomicAdd(commands.blades, uint(bitCount(lanes)));
  }
}
