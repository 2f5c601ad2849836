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

  /// The right-hand side b, set by the caller before solving: flux in m^2/s; 0 in solid cells. Solving overwrites it.
  [[nodiscard]] CpuPlane& flux() { return m_levels[0].b; }
  /// The solution d is this times correctionFactor().
  [[nodiscard]] const CpuPlane& correction() const { return m_solution; }
  [[nodiscard]] float correctionFactor() const { return m_factor; }

  /// Solves from d = 0 until the sum over cells of (b - A d)^2 is at most `wantedSquares` or `maxCycles` V-cycles are
  /// done, but at least one; `startSquares` is the sum at the start. Returns the cycles.
  int solve(ThreadPool& pool, double startSquares, double wantedSquares, int maxCycles);
  /// Jacobi sweeps from d = 0.
  void sweep(ThreadPool& pool, int sweeps);

  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  LevelProducts cycle(ThreadPool& pool, bool joins);
  LevelProducts run(ThreadPool& pool, const LevelPass& pass);
  void advance(ThreadPool& pool, float alpha, float beta, bool joins);
  void solveLast();
  void setGhosts(CpuPlane& plane) const;

  Border m_xMin = Border::Open, m_xMax = Border::Open, m_zMin = Border::Open, m_zMax = Border::Open;
  std::vector<CpuLevel> m_levels;
  CpuPlane m_solution, m_direction;
  float m_factor = 0;
  std::vector<float> m_lastInverse;  // d of the last level is this times its b
  std::vector<LevelProducts> m_products;
};

}  // namespace windloom
