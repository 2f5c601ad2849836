#pragma once
// How the GPU backend keeps the levels of the pressure solve, and how it cuts them into regions. Nothing here needs
// OpenGL.

#include <span>
#include <vector>

#include "engine/wind/pressure_levels.hpp"
#include "shaders/shared/wind_block.h"

namespace windloom {

[[nodiscard]] std::size_t cellCount(const PressureLevel& level);

/// The conductances of a full level (not FinestLevel::SizeOnly), (width + 1) x (height + 1) nodes, as
/// shaders/wind/level_faces.glsl reads them.
std::vector<shared::uint> packFaces(const PressureLevel& level);

/// Which cells of a level are like those of an endless field of air: no border, solid or narrower cell at a face.
class PlainCells {
 public:
  /// Of the grid itself.
  explicit PlainCells(const WindGrid& grid);
  /// Of a coarser level with these faces.
  PlainCells(const PressureLevel& level, std::span<const shared::uint> faces);

  /// Whether the cells [low, high) all are, and lie inside the field.
  [[nodiscard]] bool all(glm::ivec2 low, glm::ivec2 high) const;

 private:
  PlainCells(int width, int height);
  void set(int i, int k, bool plain);  // row by row
  [[nodiscard]] const int& others(int i, int k) const;
  int m_width, m_height;
  std::vector<int> m_others;  // how many cells before (i, k) along both axes aren't plain
};

/// How the regions of a pass lie: the first one begins at -margin, the next ones `inner` cells on.
struct RegionTiling {
  glm::ivec2 inner, margin, groups;
  int region;  // cells along a side
};

/// Of each region 1 where all of it is plain, otherwise 0; row by row.
std::vector<shared::uint> kindsOf(const PlainCells& plain, const RegionTiling& tiling);

/// What the tail, one work-group for all levels from a certain one on, keeps in shared memory.
struct TailSize {
  std::size_t cells = 0, first = 0, last = 0;  ///< of all its levels, of the first and of the last one
  std::size_t nodes = 0;                       ///< of all its levels but the first
  [[nodiscard]] std::size_t bytes() const;
};
TailSize tailSize(std::span<const PressureLevel> levels, std::size_t first);

/// The first level that the tail can take over with so much shared memory; level 0 never.
std::size_t firstOfTail(std::span<const PressureLevel> levels, std::size_t sharedBytes);

/// Whether one pass can take this level and the next on the way down: around a periodic border the cells of the next
/// level must all be whole.
bool makesPair(const PressureLevel& level, const PressureLevel& next, const WindGrid& grid);

}  // namespace windloom
