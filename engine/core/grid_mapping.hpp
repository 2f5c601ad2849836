#pragma once
// The wind grid in the world; the arithmetic is shaders/shared/grid_mapping.h.

#include <algorithm>

#include "shaders/shared/grid_mapping.h"

namespace windloom {

using shared::cellCentreToWorld;
using shared::GridMapping;
using shared::worldToCell;
using shared::worldToUv;

/// Field of `size` metres around `centre`, cut into `resolution` cells (both > 0).
inline GridMapping makeGridMapping(glm::vec2 centre, glm::vec2 size, glm::ivec2 resolution) {
  return {centre - size * 0.5f, size, resolution, size / glm::vec2(resolution)};
}

/// The cell that holds a world position, clamped to the grid (CWD-Sim eq. 1).
inline glm::ivec2 cellOf(const GridMapping& grid, glm::vec2 world) {
  const glm::vec2 cell = glm::floor(worldToUv(world, grid.minCorner, grid.size) * glm::vec2(grid.resolution));
  return glm::clamp(glm::ivec2(glm::clamp(cell, glm::vec2(-1), glm::vec2(grid.resolution))), glm::ivec2(0), grid.resolution - 1);
}

}  // namespace windloom
