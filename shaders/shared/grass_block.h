// Grass as its passes see it: settings (std140), work lists and blades (std430).
#ifndef WINDLOOM_SHARED_GRASS_BLOCK_H
#define WINDLOOM_SHARED_GRASS_BLOCK_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

#define GRASS_DEFORMATION_ARC 0.0f
#define GRASS_DEFORMATION_QUADRATIC 1.0f
#define GRASS_DEFORMATION_INERTIAL 2.0f

// Blades of a chunk, which is drawn as one instance; a chunk never spans two tiles.
#define GRASS_CHUNK 8u
// Chunks that a work-group of the placing pass makes; groups run in rows of so many.
#define GRASS_CHUNKS_A_GROUP 8u
#define GRASS_GROUPS_X 64u
// Levels of detail: strips of 6, 3 and 1 segments.
#define GRASS_LEVELS 3u
// Tiles that a work-group of the culling passes looks at.
#define GRASS_CULL_GROUP 128u
// Species of blades, the meadow's own included.
#define GRASS_SPECIES 17

/// Blades of one sort. The first is the meadow's own.
struct BladeSpecies {
  vec4 base;   // rgb linear; w height, m
  vec4 tip;    // rgb linear; w height variation
  vec4 form;   // x width m; y stiffness; z blades for each of the meadow's own; w patchiness
  vec4 patches;  // x size of its patches, m; y, z where its noise is read
};

struct GrassBlock {
  vec4 baseColour;  // rgb linear; w height, m
  vec4 tipColour;   // rgb linear; w height variation
  vec4 dryColour;   // rgb linear; w dryness
  vec4 size;        // x width m, y tallest blade m, z clumping, w GRASS_DEFORMATION_*
  vec4 motion;      // x F / stiffness, s/m; y stiffness variation; z flutter; w lambda
  vec4 droop;       // x k1, y k2 of CWD-Sim eq. 11; z blades per m^2; w seed
  vec4 shadow;      // m_min, m_max, c1, c2 of eq. 14
  vec4 tiles;       // x side of a tile m, y mean blades in a tile, z rings of tiles that are looked at, w species
  vec4 tileRange;   // lowest and highest tile along x and z that may be seen
  vec4 tileCentre;  // x, z tile that the rings lie around; z width of the thinning margin around the field, m;
                    // w 1: every blade is drawn; 2: as shells
  vec4 boundsRange; // x, z lowest tile with known ground, z tiles along x; w 1: out of sight is left out
  vec4 cover;       // x least blade width in pixels; y most widening; z layers that count; w blade height in pixels where it
                    // fades out
  vec4 levels;      // x, y blade heights in pixels from which levels 0 and 1 are drawn; z how closed the canopy is, 0..1;
                    // w area of the blades over that of the ground
  vec4 ground;      // x how far blades stand at right angles to the ground, 0..1; y, z cosines of the slopes where grass ends
                    // and begins to thin out
  vec4 limits;      // x chunks that fit; y 1: blades may have chains; z 1: there is an occluder pyramid; w its levels
  BladeSpecies species[GRASS_SPECIES];
};

/// A run of blades of one tile.
struct GrassChunk {
  int x;       // the tile
  int z;
  uint first;  // index of the first blade in the tile
  uint count;  // blades, <= GRASS_CHUNK; after placing: blades to be drawn
};

/// A blade ready to be drawn.
struct GrassBlade {
  float x;          // root, m
  float z;
  uint sizes;       // half2: height m, width m
  uint facing;      // bits 0-10: where its front points, of a turn; 11-15 species; unorm16: root from the lowest to the
                    // highest ground
  uint bend;        // half2: arc: direction times angle in rad; quadratic: F V
  uint shade;       // half2: height of the shadow of solids over the root, m; |F| of eq. 14
  uint tint;        // unorm4: dryness, half the brightness (with the slope's light), hue from -1..1, openness beside solids
  uint foot;        // unorm4: its colour in the picture from afar at the foot; half the height of the canopy around it over
                    // the mean one
  uint tip;         // unorm4: the same at the tip; part of the blades around it that it hides
  uint chain;       // 1: the leans of its segments stand in the list of chains
};

/// Arguments of indirect commands, written by the culling passes.
struct GrassCommands {
  uint groupsX;  // glDispatchComputeIndirect
  uint groupsY;
  uint groupsZ;
  uint chunks;      // of all levels
  uint starts[4];   // first chunk of each level
  uint blades;      // that were placed
  uint unused[3];
  uint draws[16];   // per level: indices, instances, first index, base vertex, base instance
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::BladeSpecies) == 64, "std140 layout");
static_assert(sizeof(windloom::shared::GrassBlock) == 15 * 16 + GRASS_SPECIES * 64, "std140 layout");
static_assert(sizeof(windloom::shared::GrassChunk) == 16, "std430 layout");
static_assert(sizeof(windloom::shared::GrassBlade) == 40, "std430 layout");
static_assert(sizeof(windloom::shared::GrassCommands) == 112, "std430 layout");
#endif
#endif
