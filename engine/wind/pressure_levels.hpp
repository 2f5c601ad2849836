#pragma once
// The grids of the multigrid pressure solve, made once for both backends. docs/solver.md section 6.

#include <vector>

#include "engine/wind/wind_grid.hpp"

namespace windloom {

/// One level. Rows are stored without gaps: x-faces (width + 1) x height, z-faces width x (height + 1), cells width x
/// height.
struct PressureLevel {
  int width = 0, height = 0;
  int factorX = 1, factorZ = 1;         ///< how many cells of the finer level one cell covers (level 0: 1)
  std::vector<float> cx, cz;            ///< conductances of the faces between cells; 0 on borders that aren't periodic
  std::vector<float> shareX, shareZ;    ///< open part of each face, 0..1
  std::vector<float> groundX, groundZ;  ///< conductances to p = 0 behind open borders: of row k at its low end in [2
                                        ///< k], at its high end in [2 k + 1]; of columns likewise
  glm::vec2 scale{1};                  ///< conductance of a whole face between whole cells of this level, x and z
  std::vector<float> inverseDiagonal;  ///< 1 / (sum of the cell's conductances and ground), 0 where that is 0
};

enum class FinestLevel { Full, SizeOnly };  ///< SizeOnly: the arrays of level 0 stay empty

/// Level 0 is the grid itself, the last one, which is solved exactly, has at most WIND_DENSE_CELLS cells.
std::vector<PressureLevel> buildPressureLevels(const WindGrid& grid, FinestLevel finest = FinestLevel::Full);

}  // namespace windloom
