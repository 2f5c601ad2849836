#pragma once
// Which pieces of the ground carry shells, and how finely: squares that halve towards the camera, so that their
// lattices' quads stay 20 to 40 pixels wide. Pure arithmetic.
//
// A square is drawn at up to SHELL_TILE_REACH times its side; towards that distance its lattice turns into the next
// coarser one (Strugar 2010, "Continuous distance-dependent level of detail"), so that neighbours meet without gaps.

#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/frame_block.h"
#include "shaders/shared/shell_block.h"

namespace windloom {

struct ShellTile {
  glm::vec2 low{0.0f};              ///< m
  float side = 1;                   ///< m
  float nearest = 0, farthest = 0;  ///< from the camera, m
};

struct ShellGround {
  glm::vec2 low{0.0f}, high{1.0f};       ///< m: where grass may grow
  const HeightField* heights = nullptr;  ///< null: flat at 0
  float tallest = 0.5f;                  ///< blade, m
};

/// Distance that stands for all of them where projection is parallel, m: there a metre covers as many pixels as at this
/// distance under a usual perspective.
float shellParallelDistance(const shared::FrameBlock& frame);

/// Tiles in sight that lie in the area at least in part, near ones first, at most `farthest` m away.
std::vector<ShellTile> selectShellTiles(const ShellGround& ground, const shared::FrameBlock& frame, float farthest);

/// Where a map lets nothing grow: the largest density of each of some cells of the field.
class GrowthMask {
 public:
  GrowthMask() = default;
  /// `map` null: everything grows. The picture lies over the rectangle; beyond it everything grows.
  GrowthMask(const GrassMap* map, glm::vec2 low, glm::vec2 size);
  /// False only where nothing grows in all of the rectangle.
  [[nodiscard]] bool grows(glm::vec2 low, glm::vec2 high) const;

 private:
  static constexpr int kSide = 128;
  glm::vec2 m_low{0.0f}, m_size{1.0f};
  std::vector<unsigned char> m_cells;  // kSide a row; empty: everything grows
};

}  // namespace windloom
