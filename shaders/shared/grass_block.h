// Grass as its passes see it: settings (std140), work lists and blades (std430).
#ifndef WINDLOOM_SHARED_GRASS_BLOCK_H
#define WINDLOOM_SHARED_GRASS_BLOCK_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

#define GRASS_DEFORMATION_ARC 0.0f
#define GRASS_DEFORMATION_QUADRATIC 1.0f

// Blades of one work-group of the placing pass; a chunk never spans two tiles.
#define GRASS_CHUNK 64u
// Levels of detail: strips of 6, 3 and 1 segments.
#define GRASS_LEVELS 3u
// The placing pass runs one work-group a chunk in rows of so many.
#define GRASS_GROUPS_X 64u

struct GrassBlock {
  vec4 baseColour;  // rgb linear; w height, m
  vec4 tipColour;   // rgb linear; w height variation
  vec4 dryColour;   // rgb linear; w dryness
  vec4 size;        // x width m, y tallest blade m, z clumping, w GRASS_DEFORMATION_*
  vec4 motion;      // x F / stiffness, s/m; y stiffness variation; z flutter; w lambda
  vec4 droop;       // x k1, y k2 of CWD-Sim eq. 11; z blades per m^2; w seed
  vec4 shadow;      // m_min, m_max, c1, c2 of eq. 14
  vec4 tiles;       // x tiles along x, y along z, z side of a tile m, w blades in a tile
  vec4 tileOrigin;  // x, z low corner of tile (0, 0), m; z, w width of the thinning margin around the field, m
  vec4 cover;       // x least blade width in pixels; y most widening; z detail; w blade height in pixels where it fades out
  vec4 levels;      // x, y blade heights in pixels from which levels 0 and 1 are drawn; z how closed the canopy is, 0..1;
                    // w area of the blades over that of the ground
  vec4 capacity;    // blades that fit each level's list
};

/// A run of blades of one tile that may be visible.
struct GrassChunk {
  uint tile;   // z * tiles along x + x
  uint first;  // index of the first blade in the tile
  uint count;  // blades, <= GRASS_CHUNK
  uint unused;
};

/// A blade ready to be drawn. 32 bytes.
struct GrassBlade {
  float x;          // root, m
  float z;
  uint sizes;       // half2: height m, width m
  uint facing;      // snorm2x8: unit vector of the blade's front in (x, z); unorm16: root from the lowest to the highest ground
  uint bend;        // half2: arc: direction times angle in rad; quadratic: F V
  uint shade;       // half2: height of the shadow of solids over the root, m; |F| of eq. 14
  uint tint;        // unorm4: dryness, half the brightness (with the slope's light), hue from -1..1, openness beside solids
  uint canopy;      // unorm4: half the height of the canopy around it over the mean one; its colour in the picture from afar
};

/// glDrawArraysIndirect and glDispatchComputeIndirect arguments, written by the culling passes.
struct GrassCommands {
  uint groupsX;  // glDispatchComputeIndirect
  uint groupsY;
  uint groupsZ;
  uint chunks;
  uint draws[12];  // per level: vertices, instances, first vertex, base instance
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::GrassBlock) == 12 * 16, "std140 layout");
static_assert(sizeof(windloom::shared::GrassChunk) == 16, "std430 layout");
static_assert(sizeof(windloom::shared::GrassBlade) == 32, "std430 layout");
static_assert(sizeof(windloom::shared::GrassCommands) == 64, "std430 layout");
#endif
#endif
