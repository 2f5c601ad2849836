#pragma once
// The grids of the multigrid pressure solve, made once for both backends. docs/solver.md section 6.

#include <vector>

#include "engine/wind/wind_grid.hpp"

namespace windloom {

/// One level. Rows are stored without gaps: x-faces (width + 1) x height, z-faces width x (height + 1), cells width x
/// height.
struct PressureLevel {
  int width = 0, height = 0;
  int factorX = 1, factorZ = 1;        ///< how many cells of the finer level one cell covers (level 0: 1)
  std::vector<float> cx, cz;           ///< conductances of the faces between cells; 0 on borders that aren't periodic
  std::vector<float> shareX, shareZ;   ///< open part of each face, 0..1
  std::vector<float> ground;           ///< conductance of each cell to p = 0 behind open borders
  std::vector<float> inverseDiagonal;  ///< 1 / (sum of the cell's conductances and ground), 0 where that is 0
};

/// The factors (x, z) by which a level of this many cells of this nominal size is coarsened; (1, 1) for a single cell.
using CoarseningRule = glm::ivec2 (*)(glm::ivec2 cells, glm::dvec2 cellSizeM);

/// By two (docs/solver.md section 6): the rule of the CPU backend.
glm::ivec2 coarseningOf(glm::ivec2 cells, glm::dvec2 cellSizeM);

/// By four, and the axis of the longer cells by two or one until they are square: the rule of the GPU backend, where a
/// level costs more than a sweep.
glm::ivec2 coarseningByFour(glm::ivec2 cells, glm::dvec2 cellSizeM);

enum class FinestLevel { Full, SizeOnly };  ///< SizeOnly: the arrays of level 0 stay empty

/// Level 0 is the grid itself, the last one has a single cell.
std::vector<PressureLevel> buildPressureLevels(const WindGrid& grid, CoarseningRule rule = coarseningOf,
                                               FinestLevel finest = FinestLevel::Full);

}  // namespace windloom
