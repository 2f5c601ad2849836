#pragma once
// Arrows binned into tiles of cells, so that a cell only looks at arrows near it, however many there are.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/evaluate.hpp"
#include "engine/wind/wind_grid.hpp"

namespace windloom {

/// Tile (a, b) covers cells [n a, n a + n) x [n b, n b + n) with n = cellsPerSide. The arrows that may reach it are
/// indices[start[t]] .. indices[start[t + 1] - 1] with t = b * columns + a, ascending.
struct ArrowTiles {
  int cellsPerSide = 0;  ///< WIND_TILE, doubled as often as it takes to keep the lists below 8 million entries
  int columns = 0, rows = 0;
  std::vector<std::uint32_t> start;  ///< columns * rows + 1
  std::vector<std::uint32_t> indices;

  /// What the lists were made from.
  struct Shape {
    glm::vec2 from, to;
    float radius;
  };
  std::vector<Shape> shapes;
  GridMapping field{};
};

/// Bins the arrows, where their shapes or the field changed since the last call; reuses the memory of `tiles`.
void binArrows(const WindGrid& grid, std::span<const ArrowForce> arrows, ArrowTiles& tiles);

}  // namespace windloom
