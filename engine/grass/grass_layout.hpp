#pragma once
// How many blades stand where, and what the grass shaders need to know about it. Pure arithmetic.
//
// The meadow is cut into square tiles of about a thousand blades. Blades of a tile are ordered so that any
// first part of them covers the tile evenly; how many are drawn falls with the width of a blade on screen.

#include <cstdint>
#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/grass_block.h"

namespace windloom {

using shared::GrassBlock;

/// Tiles over the field and a margin around it in which the meadow thins out.
struct GrassLayout {
  glm::ivec2 tiles{0};          ///< along x and z
  float tileSideM = 1.0f;
  glm::vec2 origin{0.0f};       ///< low corner of tile (0, 0), m
  float bladesInTile = 0.0f;    ///< mean; a tile holds this rounded down or up
  long long bladesTotal = 0;    ///< that the project asks for: density times the field's area
  std::uint32_t chunkLimit = 0; ///< most chunks (GRASS_CHUNK blades) there can be
  glm::uvec3 capacity{0};       ///< most blades drawn in each level of detail
};

/// Width of the margin around the field, m.
inline constexpr float kMeadowMarginM = 16.0f;

/// `density` > 0 makes at least one tile; density 0 gives a layout without tiles.
GrassLayout makeGrassLayout(const FieldSettings& field, const GrassSettings& grass);

/// The lowest and the highest ground in each tile, row by row, m.
std::vector<glm::vec2> groundInTiles(const GrassLayout& layout, const HeightField& ground);

/// Settings for the shaders. `detail` as FrameQuality::detail, clamped to [0.02, 1].
GrassBlock makeGrassBlock(const GrassSettings& grass, const GrassLayout& layout, float detail);

/// Part of the blades drawn where a metre covers `pixelsPerMetre`, 0..1: the same as keptPart() in
/// shaders/include/grass_tiles.glsl.
float keptPart(const GrassBlock& block, float pixelsPerMetre);

}  // namespace windloom
