// Where blades stand and how many of them are drawn. Needs frame.glsl, meadow.glsl.
#include "shaders/shared/hash.h"

uint tileCount() { return uint(grass.tiles.x) * uint(grass.tiles.y); }

vec2 tileLow(uint tile) {
  uint along = uint(grass.tiles.x);
  return grass.tileOrigin.xy + vec2(tile % along, tile / along) * grass.tiles.z;
}

uint tileHash(uint tile) { return hashCombine(tile, uint(grass.droop.w)); }

// Whole blades of a tile; the broken part of the mean is spread over the tiles.
uint bladesInTile(uint tile) { return uint(grass.tiles.w + hashToUnit(pcgHash(tileHash(tile) ^ 0x51ed27u))); }

// m from the field, 0 in it.
float beyondField(vec2 world) {
  vec2 high = frame.field.xy + frame.field.zw;
  return length(max(max(frame.field.xy - world, world - high), vec2(0.0)));
}

// Part of the blades that is drawn where a metre covers so many pixels; may be over 1: all, with room to spare.
// Blades thin out where they would be narrower than the least width on screen, and altogether where the
// canopy is only a few pixels high and the ground's shading takes over.
float keptPart(float pixels) {
  float byWidth = grass.size.x * pixels / grass.cover.x;
  float byHeight = smoothstep(0.6, 1.6, grass.baseColour.w * pixels / grass.cover.w);
  return byWidth * byHeight;
}

bool insideFrustum(vec3 centre, vec3 halfSize) {
  for (int i = 0; i < 6; ++i) {
    vec4 plane = frame.frustum[i];
    if (dot(plane.xyz, centre) + plane.w < -dot(abs(plane.xyz), halfSize)) return false;
  }
  return true;
}
