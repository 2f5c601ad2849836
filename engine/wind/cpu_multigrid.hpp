#pragma once
// The multigrid solver of the CPU backend. docs/solver.md section 6.

#include <vector>

#include "engine/core/thread_pool.hpp"
#include "engine/wind/cpu_level.hpp"

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

  /// d = 0.
  void start();
  /// One V-cycle from the present d; afterwards the sum over cells of (b - A d)^2.
  double cycle(ThreadPool& pool);
  /// Jacobi sweeps from the present d.
  void sweep(ThreadPool& pool, int sweeps);

  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  double run(ThreadPool& pool, const LevelPass& pass);
  void setGhosts(CpuPlane& plane) const;
  void wrapSides(CpuLevel& level) const;

  Border m_xMin = Border::Open, m_xMax = Border::Open, m_zMin = Border::Open, m_zMax = Border::Open;
  std::vector<CpuLevel> m_levels;
  std::vector<double> m_sums;
  bool m_zero = true;  // d of the finest level counts as 0, whatever it holds
};

}  // namespace windloom
