#pragma once
// The staggered grid both backends work on: sizes, borders, solids. Layout: docs/solver.md section 1.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/grid_mapping.hpp"
#include "engine/model/project.hpp"

namespace windloom {

struct WindGrid {
  GridMapping mapping;
  int width = 0, height = 0;  ///< cells
  float hx = 0, hz = 0;       ///< cell size, m
  Border xMin = Border::Open, xMax = Border::Open, zMin = Border::Open, zMax = Border::Open;
  std::vector<std::uint8_t> solid;  ///< width x height, 1 where solid, cell (i, k) at k * width + i
  std::size_t airCells = 0;

  [[nodiscard]] bool periodicX() const { return xMin == Border::Periodic; }
  [[nodiscard]] bool periodicZ() const { return zMin == Border::Periodic; }
  [[nodiscard]] bool solidAt(int i, int k) const {
    return solid[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)] != 0;
  }
  /// Whether x-face (i, k), i in [0, width], touches a solid cell or lies on a wall border.
  [[nodiscard]] bool blockedX(int i, int k) const;
  /// Whether z-face (i, k), k in [0, height], touches a solid cell or lies on a wall border.
  [[nodiscard]] bool blockedZ(int i, int k) const;
};

/// The grid of these settings with these obstacles (muted ones left out). A side that is Periodic without its
/// partner is a broken promise of the caller.
WindGrid makeWindGrid(const FieldSettings& field, std::span<const Obstacle> obstacles);

/// Marks the cells whose centres lie in an obstacle again, e.g. after an edit.
void rasteriseSolids(WindGrid& grid, std::span<const Obstacle> obstacles);

}  // namespace windloom
