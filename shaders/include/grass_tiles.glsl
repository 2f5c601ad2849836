// Where blades stand and how many of them are drawn. Needs frame.glsl, meadow.glsl.
#include "shaders/shared/grass_density.h"
#include "shaders/shared/hash.h"

// Tiles are cells of the world, numbered from the one under the camera outwards in square rings: near ones come first.
ivec2 tileInRings(uint n) {
  ivec2 centre = ivec2(grass.tileCentre.xy);
  if (n == 0u) return centre;
  int r = int((sqrt(float(n)) + 1.0) * 0.5);
  if (uint((2 * r - 1) * (2 * r - 1)) > n) --r;
  if (uint((2 * r + 1) * (2 * r + 1)) <= n) ++r;
  int k = int(n) - (2 * r - 1) * (2 * r - 1);
  int side = k / (2 * r);
  int along = k % (2 * r) - r;
  return centre + (side == 0 ? ivec2(along, -r) : side == 1 ? ivec2(r, along) : side == 2 ? ivec2(-along, r) : ivec2(-r, -along));
}

uint tilesInRings() {
  uint side = 2u * uint(grass.tiles.z) + 1u;
  return side * side;
}

vec2 tileLow(ivec2 tile) { return vec2(tile) * grass.tiles.x; }

uint tileHash(ivec2 tile) { return hashCombine(hashCombine(uint(tile.x), uint(tile.y)), uint(grass.droop.w)); }

// Whole blades of a tile; the broken part of the mean is spread over the tiles.
uint bladesInTile(uint hash) { return uint(grass.tiles.y + hashToUnit(pcgHash(hash ^ 0x51ed27u))); }

// m from the field, 0 in it.
float beyondField(vec2 world) {
  vec2 high = frame.field.xy + frame.field.zw;
  return length(max(max(frame.field.xy - world, world - high), vec2(0.0)));
}

// Less than the paper's 1: measured in the picture benchmark.
const float kContourLift = 0.05;
// Fitted to pictures of every blade, at 100 and 700 blades per square metre (bench picture).
const float kSeenDepth = 2.3, kSeenCover = 0.477, kSeenSlant = 0.75;

// Part of the blades that is drawn where a metre covers so many pixels; may be over 1: all, with room to spare. `facing` of
// contourGain.
float keptPart(float pixels, float facing) {
  if (grass.tileCentre.w > 0.5) return 2.0;
  float byLayers = keptByLayers(contourGain(facing, kContourLift), grass.levels.w, grass.cover.z);
  return keptTogether(byLayers, grass.size.x * pixels / grass.cover.x) * keptByHeight(grass.baseColour.w * pixels, grass.cover.w);
}

float bladeWidening(float pixels) {
  return grass.tileCentre.w > 0.5 ? 1.0 : widening(grass.size.x * pixels, grass.cover.x, grass.cover.y);
}

// How far a blade is seen for itself: 1 from the least width on, less the more it stands for others.
float singleness(float pixels) {
  return grass.tileCentre.w > 0.5 ? 1.0 : clamp(grass.size.x * pixels / grass.cover.x, 0.0, 1.0);
}

// Part of the blades that hide behind others, and are left out.
float hiddenPart(float facing) {
  if (grass.tileCentre.w > 0.5) return 0.0;
  return 1.0 - min(keptByLayers(contourGain(facing, kContourLift), grass.levels.w, grass.cover.z), 1.0);
}

// How far down the canopy is seen from its top, in heights, under an angle of sine `up`.
float seenDepth(float up) {
  return clamp(kSeenDepth * pow(max(up, 1e-4), kSeenSlant) / pow(max(grass.levels.w, 1e-3), kSeenCover), 0.05, 1.0);
}

bool insideFrustum(vec3 centre, vec3 halfSize) {
  if (grass.boundsRange.w < 0.5) return true;
  for (int i = 0; i < 6; ++i) {
    vec4 plane = frame.frustum[i];
    if (dot(plane.xyz, centre) + plane.w < -dot(abs(plane.xyz), halfSize)) return false;
  }
  return true;
}
