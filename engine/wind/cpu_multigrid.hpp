#pragma once
// The multigrid solver of the CPU backend. docs/solver.md section 6.

#include <vector>

#include "engine/core/thread_pool.hpp"
#include "engine/wind/cpu_plane.hpp"
#include "engine/wind/pressure_levels.hpp"

namespace windloom {

class CpuMultigrid {
 public:
  explicit CpuMultigrid(const WindGrid& grid) { rebuild(grid); }

  /// Takes over new solids or borders of a grid.
  void rebuild(const WindGrid& grid);

  /// The right-hand side b, set by the caller before solving: flux in m^2/s; 0 in solid cells.
  [[nodiscard]] CpuPlane& flux() { return m_levels[0].b; }
  /// The solution d.
  [[nodiscard]] const CpuPlane& correction() const { return m_levels[0].d; }
  [[nodiscard]] CpuPlane& correction() { return m_levels[0].d; }

  /// d = 0.
  void start();
  /// One V-cycle from the present d.
  void cycle(ThreadPool& pool);
  /// One Jacobi sweep of the given weight.
  void sweep(ThreadPool& pool, float weight) { sweepLevel(pool, m_levels[0], weight); }
  /// Sum over cells of (b - A d)^2.
  [[nodiscard]] double residualSquares(ThreadPool& pool);

  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  struct Level {
    int width = 0, height = 0, factorX = 1, factorZ = 1;
    CpuPlane d, b, next;             // cells
    CpuPlane cx, cz, shareX, shareZ;  // faces
    CpuPlane inverse;                // cells
  };
  void sweepLevel(ThreadPool& pool, Level& level, float weight);
  void restrictResidual(ThreadPool& pool, const Level& fine, Level& coarse);
  void prolong(ThreadPool& pool, Level& coarse, Level& fine);
  void wrapGhosts(CpuPlane& plane) const;
  void borderGhosts(CpuPlane& plane) const;

  Border m_xMin = Border::Open, m_xMax = Border::Open, m_zMin = Border::Open, m_zMax = Border::Open;
  std::vector<Level> m_levels;
  std::vector<double> m_sums;
};

}  // namespace windloom
