// Patches: tiles of the meadow whose blades remember what bent them (std430).
#ifndef WINDLOOM_SHARED_GRASS_PATCH_H
#define WINDLOOM_SHARED_GRASS_PATCH_H
#include "shaders/shared/hash.h"
WL_SHARED_BEGIN

// Blades of a work-group of the stepping pass.
#define PATCH_GROUP 64
// A turn (rad) that marks a blade as hidden: its root is inside of something.
#define PATCH_HIDDEN 1000.0f

/// A patch in this step.
struct GrassPatch {
  int x;       // its tile
  int z;
  uint slot;   // where its blades are remembered
  float keep;  // part of the bend that stays: 0 for a new patch, between 0 and 1 while it gives way
  uint first;  // of the primitives that may touch it now, those of a patch one after the other
  uint count;  // of them
};

/// An entry of the table from tiles to patches: open addressing by patchHash, linear probing.
struct PatchEntry {
  int x;
  int z;
  uint slot;
  uint used;  // 0: empty
};

/// What stands before the entries.
struct PatchTableHead {
  uint mask;    // entries - 1, a power of two less one
  uint count;   // patches; 0: nothing to look for
  uint stride;  // blades remembered of a patch
  uint blades;  // of all slots
};

/// How fast a blade swings over the meadow's mean: trampled grass doesn't rise in step. `tileHash` as in grass_tiles.glsl.
WL_FUNCTION float patchRate(uint tileHash, uint index) { return 0.85f + 0.3f * hashToUnit(hashCombine(tileHash ^ 0x7f4a7c15u, index)); }

WL_FUNCTION uint patchHash(int x, int z) { return hashCombine(uint(x), uint(z)); }

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::GrassPatch) == 24, "std430 layout");
static_assert(sizeof(windloom::shared::PatchEntry) == 16, "std430 layout");
static_assert(sizeof(windloom::shared::PatchTableHead) == 16, "std430 layout");
#endif
#endif
