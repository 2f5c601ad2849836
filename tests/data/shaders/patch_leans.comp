#version 450 core
#define CHAINS
// What drawn blades read from patches, for a test: all blades of a tile, their leans, chains and roots.
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
#include "shaders/include/grass_patches.glsl"

layout(local_size_x = 1) in;
struct Seen {
  vec4 root;    // xyz m; w 1: drawn
  vec4 points[CHAIN_SEGMENTS];  // ends of the segments, m from the root; w patch
  vec4 low;     // leans
  vec4 high;
  uvec4 tile;  // x: its hash
};
layout(std430, binding = 0) writeonly buffer Answers { Seen seen[]; };
uniform ivec2 tile;

void main() {
  uint index = gl_GlobalInvocationID.x;
  BladeRoot own = bladeRoot(tile, index, bladesInTile(tileHash(tile)));
  int slot = patchOf(tile);
  ChainLeans leans;
  bool drawn = patchLeans(slot, index, leans);
  BladePose pose = blockPose(own, rippledWind(own.root, groupWind(own.root), grass.motion.z));
  float height = standingHeight(own);
  vec3 at = vec3(0.0);
  vec3 before = vec3(0.0);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec3 next = posePoint(pose.bend, own.facing, float(i + 1) / float(CHAIN_SEGMENTS));
    at += chainMatrix(chainTurn(pose.leans.e[i] + leans.e[i])) * (next - before) * height;
    before = next;
    seen[index].points[i] = vec4(at, float(slot));
  }
  seen[index].root = vec4(own.root.x, groundHeight(own.root), own.root.y, drawn ? 1.0 : 0.0);
  seen[index].tile = uvec4(tileHash(tile), 0u, 0u, 0u);
  seen[index].low = vec4(leans.e[0], leans.e[1]);
  seen[index].high = vec4(leans.e[2], leans.e[3]);
}
