#pragma once
// Which tiles of uneven ground are drawn, and how finely. Pure arithmetic.
//
// The samples are cut into square tiles. A tile is drawn with every 2^L-th sample where that moves the ground by no
// more than a given number of pixels (a restricted form of Lindstrom et al. 1996, "Real-time, continuous level of
// detail rendering of height fields", on whole tiles). Flat parts cost two triangles a tile.

#include <array>
#include <vector>

#include "engine/model/height_field.hpp"
#include "shaders/shared/frame_block.h"
#include "shaders/shared/ground_tile.h"

namespace windloom {

using shared::FrameBlock;
using shared::GroundTile;

/// What is known of a field's tiles before a camera is.
struct GroundTiles {
  struct Tile {
    std::array<float, GROUND_LEVELS> error{};  ///< most that a level is off, m
    float lowest = 0, highest = 0;             ///< m
  };
  glm::ivec2 count{0};
  std::vector<Tile> tiles;  ///< count.x a row
};
GroundTiles measureGroundTiles(const HeightField& field);

/// Tiles in view by level, the ones from the edge to the horizon included. `reach` m to the horizon. Where more than
/// `mostTriangles` would be drawn, more than `pixels` are allowed.
struct GroundSelection {
  std::array<std::vector<GroundTile>, GROUND_LEVELS> levels;
  long triangles = 0;
};
GroundSelection selectGroundTiles(const HeightField& field, const GroundTiles& tiles, const FrameBlock& frame, float reach,
                                  float pixels, long mostTriangles);

}  // namespace windloom
