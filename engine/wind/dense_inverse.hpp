#pragma once
// The exact solve on the coarsest level of the pressure's multigrid.

#include <vector>

#include "engine/wind/pressure_levels.hpp"

namespace windloom {

/// The matrix M, n x n for the level's n cells, with which d = M b solves A d = b (docs/solver.md section 6) for every
/// b whose sum over each pocket of air without an open border is 0; the d of such a pocket then has the mean 0.
/// Symmetric. Rows and columns of cells without air are 0. Takes n^3 operations: for a few dozen cells.
std::vector<float> denseInverse(const PressureLevel& level);

}  // namespace windloom
