#pragma once
// What both backends check and convert before they run.

#include <span>

#include "engine/wind/wind_grid.hpp"
#include "engine/wind/wind_solver.hpp"

namespace windloom {

/// Refuses (BadInput) a setup no grid can be made of: sizes or time step that aren't positive and finite, a resolution
/// outside 1..16384 per side, a periodic side without its partner.
Status checkWindSetup(const WindSetup& setup);

/// Refuses (BadInput) a field of the wrong size or with values that aren't finite, naming the cell.
Status checkInitialField(const WindGrid& grid, std::span<const glm::vec2> cells);

/// The velocity of x-face (i, k), or z-face (i, k), of a cell-centred field, limited to maxSpeed; 0 where blocked.
/// docs/solver.md section 1.
float initialFaceX(const WindGrid& grid, std::span<const glm::vec2> cells, int i, int k, float maxSpeed);
float initialFaceZ(const WindGrid& grid, std::span<const glm::vec2> cells, int i, int k, float maxSpeed);

}  // namespace windloom
