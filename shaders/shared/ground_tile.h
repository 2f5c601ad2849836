// A tile of uneven ground as its vertex shader sees it (std430).
#ifndef WINDLOOM_SHARED_GROUND_TILE_H
#define WINDLOOM_SHARED_GROUND_TILE_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

// Spaces between samples along a tile's side; level L takes every 2^L-th sample.
#define GROUND_TILE_SIDE 32
#define GROUND_LEVELS 6

struct GroundTile {
  uint x;       // tile + 1: 0 and the last one go from the rectangle's edge out to the horizon
  uint z;
  uint level;
  uint around;  // levels of the neighbours at low x, high x, low z, high z, a byte each
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::GroundTile) == 16, "std430 layout");
#endif
#endif
