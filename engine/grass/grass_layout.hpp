#pragma once
// How many blades stand where, and what the grass shaders need to know about it. Pure arithmetic.
//
// The meadow is cut into square tiles of about a thousand blades: cells of the world, so that a blade is where it is
// whatever is drawn. Blades of a tile are ordered so that any first part of them covers the tile evenly; how many are
// drawn falls with their size on screen and with how many layers of them stand behind each other.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/frame_block.h"
#include "shaders/shared/grass_block.h"

namespace windloom {

using shared::GrassBlock;

/// Tiles over the field and a margin around it in which the meadow thins out.
struct GrassLayout {
  float tileSideM = 1.0f;
  glm::ivec2 low{0}, high{-1};  ///< lowest and highest tile along x and z; tile (i, k) begins at (i, k) sides
  float bladesInTile = 0.0f;    ///< mean; a tile holds this rounded down or up
  long long bladesTotal = 0;    ///< that the project asks for: density times the field's area

  [[nodiscard]] bool empty() const { return high.x < low.x; }
  [[nodiscard]] glm::ivec2 tiles() const { return high - low + 1; }
};

/// Width of the margin around the field, m.
inline constexpr float kMeadowMarginM = 16.0f;
/// Most tiles along a side of the meadow.
inline constexpr int kMaxTilesPerSide = 1024;

/// `density` > 0 makes at least one tile; density 0 gives a layout without tiles.
GrassLayout makeGrassLayout(const FieldSettings& field, const GrassSettings& grass);

/// The lowest and the highest ground in each tile, row by row, m.
std::vector<glm::vec2> groundInTiles(const GrassLayout& layout, const HeightField& ground);

/// How finely the grass of a frame is drawn; see FrameQuality.
struct GrassQuality {
  float detail = 1.0f;  ///< clamped to [0.02, 1]
  bool thinning = true, culling = true;
  bool quick = false;  ///< on a software renderer: strips change their number of segments at once
};

/// Settings for the shaders. `frame` is the camera's.
GrassBlock makeGrassBlock(const GrassSettings& grass, std::span<const Species> species, const GrassLayout& layout,
                          const GrassQuality& quality, const shared::FrameBlock& frame);

/// Tiles that the culling pass looks at: those of the rings around the camera that reach all tiles in range.
std::uint32_t tilesInRings(const GrassBlock& block);

/// Most chunks that these tiles can hold.
double chunksInRange(const GrassBlock& block);

/// Part of the blades drawn where a metre covers `pixelsPerMetre` and the ground is seen under an angle of cosine
/// `facing`: the same as keptPart() in shaders/include/grass_tiles.glsl, at most 1.
float keptPart(const GrassBlock& block, float pixelsPerMetre, float facing = 1.0f);

}  // namespace windloom
