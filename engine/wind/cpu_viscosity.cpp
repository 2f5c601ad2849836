// Varga, Matrix Iterative Analysis, 1962 (Chebyshev semi-iteration on Jacobi's method).
#include "engine/wind/cpu_viscosity.hpp"

#include <algorithm>
#include <cmath>

#include "engine/wind/cpu_borders.hpp"

namespace windloom {
namespace {

struct Stencil {
  float bx, bz, inverse;
};

/// y_{m+1} = y_{m-1} + c (J(y_m) - y_{m-1}) for one row; `next` holds y_{m-1} and gets y_{m+1}.
void sweepRow(const Stencil& s, float c, const CpuPlane& rhs, const CpuPlane& y, CpuPlane& next, int k, int begin,
              int end) {
  const float *q = rhs.row(k), *own = y.row(k), *low = y.row(k - 1), *high = y.row(k + 1);
  float* out = next.row(k);
  for (int i = begin; i < end; ++i) {
    const float jacobi = (q[i] + s.bx * (own[i - 1] + own[i + 1]) + s.bz * (low[i] + high[i])) * s.inverse;
    out[i] += c * (jacobi - out[i]);
  }
}

void sweep(const CpuFields& f, ThreadPool& pool, const Stencil& s, float c, const CpuVelocity& rhs,
           const CpuVelocity& y, CpuVelocity& next) {
  const int skipX = f.grid.periodicX() ? 0 : 1, skipZ = f.grid.periodicZ() ? 0 : 1;
  forRows(pool, f.width(), f.height() + 1, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      if (k < f.height()) sweepRow(s, c, rhs.u, y.u, next.u, k, skipX, f.width() + 1 - skipX);
      if (k >= skipZ && k <= f.height() - skipZ) sweepRow(s, c, rhs.w, y.w, next.w, k, 0, f.width());
    }
  });
  blockFaces(f, next);
  fillGhosts(f, next, OpenGhost::Copy);
}

void copyAll(const CpuPlane& from, CpuPlane& to) {
  std::memcpy(to.memory(), from.memory(), from.bytes());
}

void copyRows(const CpuVelocity& from, CpuVelocity& to) {
  copyAll(from.u, to.u);
  copyAll(from.w, to.w);
}

}  // namespace

int viscositySweeps(double diagonal) {
  const double s = (diagonal - 1) / diagonal;
  const double rho = s / (1 + std::sqrt(1 - s * s));
  if (rho <= 0) return 2;
  const double wanted = rho < 1 ? std::ceil(std::log(2e5) / -std::log(rho)) : double(WIND_VISCOSITY_SWEEPS);
  return static_cast<int>(std::clamp(wanted, 2.0, double(WIND_VISCOSITY_SWEEPS)));
}

void diffuse(CpuFields& f, ThreadPool& pool) {
  if (f.solver.viscosity <= 0) return;
  const double bx = double(f.solver.viscosity) * double(f.dt) / (double(f.grid.hx) * double(f.grid.hx));
  const double bz = double(f.solver.viscosity) * double(f.dt) / (double(f.grid.hz) * double(f.grid.hz));
  const double diagonal = 1 + 2 * bx + 2 * bz;
  const Stencil stencil{static_cast<float>(bx), static_cast<float>(bz), static_cast<float>(1 / diagonal)};
  const double s = (diagonal - 1) / diagonal;
  blockFaces(f, f.moved);
  fillGhosts(f, f.moved, OpenGhost::Copy);
  copyRows(f.moved, f.forced);     // y_{m-1}: y_0 first
  copyRows(f.moved, f.corrected);  // y_m
  CpuVelocity *previous = &f.forced, *current = &f.corrected;
  double c = 1;
  const int sweeps = viscositySweeps(diagonal);
  for (int m = 1; m <= sweeps; ++m) {
    if (m == 2) c = 2 / (2 - s * s);
    if (m > 2) c = 1 / (1 - s * s * c / 4);
    sweep(f, pool, stencil, static_cast<float>(c), f.moved, *current, *previous);
    std::swap(previous, current);
  }
  std::swap(f.moved, *current);
}

}  // namespace windloom
