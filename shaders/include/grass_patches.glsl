// Blades of patches: how far what touched them still bends them. Needs render_bindings.h.
#include "shaders/shared/grass_patch.h"
#include "shaders/shared/segment_chain.h"

#ifndef PATCH_STATE_ACCESS
#define PATCH_STATE_ACCESS readonly
#endif
layout(std430, binding = RENDER_SSBO_PATCH_TABLE) readonly buffer PatchTable {
  PatchTableHead patchTable;
  PatchEntry patchEntries[];
};
// Segment by segment, all blades of each: x, y the lean over the segment below, rad; z, w how fast it changes, rad/s.
layout(std430, binding = RENDER_SSBO_PATCH_STATE) PATCH_STATE_ACCESS buffer PatchState { vec4 patchState[]; };

// The patch that a tile is, -1: none.
int patchOf(ivec2 tile) {
  if (patchTable.count == 0u) return -1;
  uint at = patchHash(tile.x, tile.y) & patchTable.mask;
  for (uint probe = 0u; probe <= patchTable.mask; ++probe) {
    PatchEntry entry = patchEntries[at];
    if (entry.used == 0u) return -1;
    if (entry.x == tile.x && entry.z == tile.y) return int(entry.slot);
    at = (at + 1u) & patchTable.mask;
  }
  return -1;
}

uint patchStateAt(uint slot, uint index, int segment) {
  return uint(segment) * patchTable.blades + slot * patchTable.stride + index;
}

// Leans of blade `index` of a patch over the pose that it has in a block; false: it is hidden.
bool patchLeans(int slot, uint index, out ChainLeans leans) {
  vec2 sum = vec2(0.0);
  bool remembered = slot >= 0 && index < patchTable.stride;
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    if (remembered) sum += patchState[patchStateAt(uint(slot), index, i)].xy;
    leans.e[i] = sum;
  }
  return sum.x < 0.5 * PATCH_HIDDEN;
}
