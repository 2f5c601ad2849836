#pragma once
// The state of the CPU backend and what its stages share. docs/solver.md names the arrays and the stages.

#include <array>
#include <optional>
#include <vector>

#include "engine/wind/arrow_tiles.hpp"
#include "engine/wind/cpu_plane.hpp"
#include "engine/wind/cpu_tasks.hpp"
#include "engine/wind/gusts.hpp"
#include "engine/wind/wind_grid.hpp"
#include "engine/wind/wind_solver.hpp"

namespace windloom {

/// What is beyond this, or no number, isn't healthy.
inline constexpr float kLargestHealthy = 3e38f;

/// Faces that were reset because they weren't finite.
struct CpuHealth {
  long count = 0;
  glm::ivec2 first{-1, -1};  ///< cell of the first one

  void add(const CpuHealth& next) {
    if (count == 0) first = next.first;
    count += next.count;
  }
};

/// One staggered vector field.
struct CpuVelocity {
  CpuPlane u, w;  // (W + 1) x H and W x (H + 1)
  CpuVelocity() = default;
  explicit CpuVelocity(const WindGrid& grid) : u(grid.width + 1, grid.height), w(grid.width, grid.height + 1) {}
};

/// Entries [begin, end) of row `row`.
struct CpuRun {
  int row, begin, end;
};

/// Runs sorted by row, found by row.
struct CpuRuns {
  std::vector<CpuRun> runs;
  std::vector<int> start;  // rows + 1
};

/// Texels in a row of CpuFields' gust table.
inline constexpr int kGustRow = WIND_GUST_TABLE + 1;

struct CpuFields {
  WindGrid grid;
  SolverSettings solver;
  AmbientWind ambientSettings;
  std::optional<WallSpeeds> noSlip;
  float dt = 0;
  glm::vec2 ambient{0};              // without gusts, m/s
  float gustAmplitude = 0;           // m/s
  std::vector<glm::vec2> gustTable;  // with its first row and column again at the end: rows of kGustRow

  CpuVelocity velocity;                  // the field that left the last step
  CpuVelocity forced, moved, corrected;  // q; q', then q*; room for the correction
  CpuVelocity lowest, highest;           // bounds of the correction
  CpuPlane phi, expected;                // m^2/s: the last step's, and what this one's is expected to be
  bool hasPhi = false;                   // false: no step came before, or its phi was of no use
  CpuPlane speedX, speedZ;               // cell velocity
  CpuRuns blockedX, blockedZ;            // faces kept at 0
  CpuRuns solidNodes;                    // nodes that touch a solid cell: no vorticity there

  [[nodiscard]] int width() const { return grid.width; }
  [[nodiscard]] int height() const { return grid.height; }
};

}  // namespace windloom
