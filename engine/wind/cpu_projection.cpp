// Harlow & Welch, Numerical calculation of time-dependent viscous incompressible flow, 1965. Deviation: the last
// step's pressure is taken off the velocity first and only its change is solved for, which keeps rounding small.
#include "engine/wind/cpu_projection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/wind/cpu_borders.hpp"

namespace windloom {
namespace {

struct Sums {
  double flux = 0, speed = 0, greatest = 0;
};

struct Totals {
  std::vector<Sums> tasks;
  explicit Totals(int rows) : tasks(static_cast<std::size_t>(rowTasks(rows))) {}
  [[nodiscard]] Sums sum() const {
    Sums total;
    for (const Sums& s : tasks) {
      total.flux += s.flux;
      total.speed += s.speed;
      total.greatest = std::max(total.greatest, s.greatest);
    }
    return total;
  }
};

/// Fluxes out of the cells of `velocity`, into `out` where given.
Sums measureFlux(const CpuFields& f, ThreadPool& pool, const CpuVelocity& velocity, CpuPlane* out) {
  Totals totals(f.height());
  forRowTasks(pool, f.height(), [&](int task, int begin, int end) {
    std::vector<float> row(static_cast<std::size_t>(f.width()));
    Sums& sums = totals.tasks[static_cast<std::size_t>(task)];
    for (int k = begin; k < end; ++k) {
      const float *u = velocity.u.row(k), *w = velocity.w.row(k), *wHigh = velocity.w.row(k + 1);
      float* flux = out ? out->row(k) : row.data();
      for (int i = 0; i < f.width(); ++i) flux[i] = (u[i + 1] - u[i]) * f.grid.hz + (wHigh[i] - w[i]) * f.grid.hx;
      for (int i = 0; i < f.width(); ++i) {
        sums.flux += double(flux[i]) * double(flux[i]);
        sums.speed += double(u[i]) * double(u[i]) + double(w[i]) * double(w[i]);
        sums.greatest = std::max(sums.greatest, std::abs(double(flux[i])));
      }
    }
  });
  return totals.sum();
}

float finiteOr(float value, float otherwise) { return std::isfinite(value) ? value : otherwise; }

/// velocity -= grad phi on all faces that aren't blocked; a face that would not be finite keeps its value.
void subtractGradient(const CpuFields& f, ThreadPool& pool, const CpuPlane& phi, const CpuVelocity& from, CpuVelocity& to) {
  const WindGrid& g = f.grid;
  const float ix = 1 / g.hx, iz = 1 / g.hz;
  const auto border = [](Border kind, float inside, float across, float scale) {  // difference over a border, low to high
    return kind == Border::Open ? 2 * scale * inside : kind == Border::Periodic ? scale * (inside - across) : 0.0f;
  };
  forRowTasks(pool, g.height + 1, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      if (k < g.height) {
        const float *p = phi.row(k), *u = from.u.row(k);
        float* out = to.u.row(k);
        for (int i = 1; i < g.width; ++i) out[i] = finiteOr(u[i] - (p[i] - p[i - 1]) * ix, u[i]);
        out[0] = finiteOr(u[0] - border(g.xMin, p[0], p[g.width - 1], ix), u[0]);
        out[g.width] = g.periodicX() ? out[0] : finiteOr(u[g.width] + border(g.xMax, p[g.width - 1], 0, ix), u[g.width]);
      }
      const float* w = from.w.row(k);
      const float *high = phi.row(std::min(k, g.height - 1)), *low = phi.row(std::max(k, 1) - 1);
      float* out = to.w.row(k);
      if (k > 0 && k < g.height) {
        for (int i = 0; i < g.width; ++i) out[i] = finiteOr(w[i] - (high[i] - low[i]) * iz, w[i]);
      } else if (k == 0 || g.periodicZ()) {
        const float *first = phi.row(0), *last = phi.row(g.height - 1);
        for (int i = 0; i < g.width; ++i) out[i] = finiteOr(w[i] - border(g.zMin, first[i], last[i], iz), w[i]);
      } else {
        for (int i = 0; i < g.width; ++i) out[i] = finiteOr(w[i] + border(g.zMax, low[i], 0, iz), w[i]);
      }
    }
  });
  blockFaces(f, to);
}

int solve(CpuFields& f, CpuMultigrid& multigrid, ThreadPool& pool, double wantedSquares, double startSquares) {
  multigrid.start();
  if (f.solver.pressure == Pressure::Jacobi) {
    multigrid.sweep(pool, f.solver.jacobiSweeps);
    return f.solver.jacobiSweeps;
  }
  int cycles = 0;
  for (double squares = startSquares; squares > wantedSquares && cycles < f.solver.maxCycles; ++cycles) {
    squares = multigrid.cycle(pool);
  }
  return cycles;
}

}  // namespace

ProjectionReport project(CpuFields& f, CpuMultigrid& multigrid, ThreadPool& pool) {
  const double area = double(f.grid.hx) * double(f.grid.hz);
  const double air = static_cast<double>(std::max<std::size_t>(f.grid.airCells, 1));
  const double cells = double(f.width()) * double(f.height());
  const Sums before = measureFlux(f, pool, f.moved, nullptr);
  subtractGradient(f, pool, f.phi, f.moved, f.moved);
  const Sums start = measureFlux(f, pool, f.moved, &multigrid.flux());
  const double tolerance = double(f.solver.divergenceTolerance);
  const double floor = double(WIND_ROUNDING_FLOOR) * double(std::max(f.grid.hx, f.grid.hz));
  const double wanted = std::max(tolerance * tolerance * before.flux, floor * floor * before.speed / cells * air);
  ProjectionReport report;
  report.cycles = solve(f, multigrid, pool, wanted, start.flux);
  const CpuPlane& d = multigrid.correction();
  subtractGradient(f, pool, d, f.moved, f.velocity);
  forRowTasks(pool, f.height(), [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      float* phi = f.phi.row(k);
      for (int i = 0; i < f.width(); ++i) phi[i] = finiteOr(phi[i] + d.row(k)[i], 0.0f);
    }
  });
  const Sums after = measureFlux(f, pool, f.velocity, nullptr);
  report.divergenceBefore = std::sqrt(before.flux / air) / area;
  report.divergenceAfter = std::sqrt(after.flux / air) / area;
  report.maxDivergenceAfter = after.greatest / area;
  return report;
}

void resampleToCells(CpuFields& f, ThreadPool& pool) {
  forRowTasks(pool, f.height(), [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const float *u = f.velocity.u.row(k), *w = f.velocity.w.row(k), *wHigh = f.velocity.w.row(k + 1);
      float *x = f.speedX.row(k), *z = f.speedZ.row(k);
      for (int i = 0; i < f.width(); ++i) {
        x[i] = 0.5f * (u[i] + u[i + 1]);
        z[i] = 0.5f * (w[i] + wHigh[i]);
      }
    }
  });
  for (CpuPlane* plane : {&f.speedX, &f.speedZ}) {
    const int w = f.width(), h = f.height();
    for (int k = 0; k < h; ++k) {
      plane->at(-1, k) = plane->at(f.grid.periodicX() ? w - 1 : 0, k);
      plane->at(w, k) = plane->at(f.grid.periodicX() ? 0 : w - 1, k);
    }
    std::copy_n(plane->row(f.grid.periodicZ() ? h - 1 : 0), w, plane->row(-1));
    std::copy_n(plane->row(f.grid.periodicZ() ? 0 : h - 1), w, plane->row(h));
  }
}

}  // namespace windloom
