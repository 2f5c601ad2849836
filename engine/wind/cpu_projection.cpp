#include "engine/wind/cpu_projection.hpp"

#include <algorithm>
#include <cmath>

#include "engine/wind/cpu_projection_rows.hpp"

namespace windloom {
namespace {

/// Runs a pass and adds up what its tasks found, in order.
template <class Rows>
RowFindings runPass(ThreadPool& pool, int width, int height, const Rows& rows) {
  std::vector<RowFindings> tasks(static_cast<std::size_t>(tasksFor(height)));
  forRows(pool, width, height,
          [&](int task, int begin, int end) { tasks[static_cast<std::size_t>(task)] = rows(begin, end); });
  RowFindings total;
  for (const RowFindings& t : tasks) {
    total.health.add(t.health);
    total.fluxSquares += t.fluxSquares;
    total.predictedSquares += t.predictedSquares;
    total.speedSquares += t.speedSquares;
    total.cellSquares += t.cellSquares;
    total.greatestFlux = std::max(total.greatestFlux, t.greatestFlux);
    total.greatestCellSquare = std::max(total.greatestCellSquare, t.greatestCellSquare);
    total.greatestCellX = std::max(total.greatestCellX, t.greatestCellX);
    total.greatestCellZ = std::max(total.greatestCellZ, t.greatestCellZ);
  }
  return total;
}

int solve(CpuFields& f, CpuMultigrid& multigrid, ThreadPool& pool, double wantedSquares, double startSquares) {
  if (f.solver.pressure == Pressure::Jacobi) {
    multigrid.sweep(pool, f.solver.jacobiSweeps);
    return f.solver.jacobiSweeps;
  }
  return multigrid.solve(pool, startSquares, wantedSquares, f.solver.maxCycles);
}

/// Ghosts of the cell velocities: as the cell inside, or of the other side.
void setCellGhosts(CpuFields& f) {
  const int w = f.width(), h = f.height();
  const bool wrapX = f.grid.periodicX(), wrapZ = f.grid.periodicZ();
  for (CpuPlane* plane : {&f.speedX, &f.speedZ}) {
    for (int k = 0; k < h; ++k) {
      plane->at(-1, k) = plane->at(wrapX ? w - 1 : 0, k);
      plane->at(w, k) = plane->at(wrapX ? 0 : w - 1, k);
    }
    std::copy_n(plane->row(wrapZ ? h - 1 : 0), w, plane->row(-1));
    std::copy_n(plane->row(wrapZ ? 0 : h - 1), w, plane->row(h));
  }
}

}  // namespace

namespace {

/// The first step of a field: what one cycle finds becomes the expected pressure. Taken off the velocity on its own it
/// is exact; as a part of the whole solution its rounding would hide what is left to solve.
void adoptOneCycle(CpuFields& f, CpuMultigrid& multigrid, ThreadPool& pool, double squares) {
  (void)multigrid.solve(pool, squares, 0, 1);
  for (int k = 0; k < f.height(); ++k) {
    const float* d = multigrid.correction().row(k);
    for (int i = 0; i < f.width(); ++i) {
      const float found = multigrid.correctionFactor() * d[i];
      f.phi.at(i, k) = f.expected.at(i, k) = std::abs(found) <= kLargestHealthy ? found : 0.0f;
    }
  }
  f.hasPhi = true;
}

}  // namespace

void forgetPressure(CpuFields& f) {
  f.expected.clear();
  f.hasPhi = false;
}

ProjectionReport project(CpuFields& f, CpuMultigrid& multigrid, ThreadPool& pool) {
  const double area = double(f.grid.hx) * double(f.grid.hz);
  const double air = static_cast<double>(std::max<std::size_t>(f.grid.airCells, 1));
  const double cells = double(f.width()) * double(f.height());
  const auto predict = [&] {
    return runPass(pool, f.width(), f.height(),
                   [&](int begin, int end) { return predictRowsOf(f, multigrid.flux(), begin, end); });
  };
  RowFindings before = predict();
  if (!f.hasPhi && f.solver.pressure == Pressure::Multigrid) {
    adoptOneCycle(f, multigrid, pool, before.predictedSquares);
    before = predict();
  } else if (!(before.predictedSquares <= before.fluxSquares)) {  // what was expected is of no use
    forgetPressure(f);
    before = predict();
  }
  constexpr double kRoom = 0.95;  // rounding in the last gradient adds to the residual
  const double tolerance = kRoom * double(f.solver.divergenceTolerance);
  const double floor = double(WIND_ROUNDING_FLOOR) * double(std::max(f.grid.hx, f.grid.hz));
  const double wanted =
      std::max(tolerance * tolerance * before.fluxSquares, floor * floor * before.speedSquares / cells * air);
  ProjectionReport report;
  report.cycles = solve(f, multigrid, pool, wanted, before.predictedSquares);
  const RowFindings after = runPass(pool, f.width(), f.height(), [&](int begin, int end) {
    return finishRowsOf(f, multigrid.correction(), multigrid.correctionFactor(), begin, end);
  });
  f.hasPhi = true;
  std::swap(f.velocity, f.moved);
  setCellGhosts(f);
  report.divergenceBefore = std::sqrt(before.fluxSquares / air) / area;
  report.divergenceAfter = std::sqrt(after.fluxSquares / air) / area;
  report.maxDivergenceBefore = before.greatestFlux / area;
  report.maxDivergenceAfter = after.greatestFlux / area;
  report.kineticEnergy = 0.5 * after.cellSquares / air;
  report.maxSpeed = std::sqrt(double(after.greatestCellSquare));
  report.cfl = double(std::max(after.greatestCellX * f.dt / f.grid.hx, after.greatestCellZ * f.dt / f.grid.hz));
  report.health = before.health;
  return report;
}

void resampleToCells(CpuFields& f, ThreadPool& pool) {
  forRows(pool, f.width(), f.height(), [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const float *u = f.velocity.u.row(k), *w = f.velocity.w.row(k), *wHigh = f.velocity.w.row(k + 1);
      float *x = f.speedX.row(k), *z = f.speedZ.row(k);
      for (int i = 0; i < f.width(); ++i) {
        x[i] = 0.5f * (u[i] + u[i + 1]);
        z[i] = 0.5f * (w[i] + wHigh[i]);
      }
    }
  });
  setCellGhosts(f);
}

}  // namespace windloom
