// Cell-centred geometric multigrid: Wesseling, An Introduction to Multigrid Methods, 1992 (averaging restriction,
// linear prolongation); smoother: Jacobi with Chebyshev weights, after Adams, Brezina, Hu & Tuminaro, Parallel
// multigrid smoothing: polynomial versus Gauss-Seidel, 2003. V-cycles are joined by generalised conjugate residuals
// with one direction kept (Eisenstat, Elman & Schultz, Variational iterative methods, 1983): see docs/solver.md.
#include "engine/wind/cpu_multigrid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/wind/cpu_tasks.hpp"
#include "engine/wind/dense_inverse.hpp"
#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

constexpr int kShortestPlainRun = 16;  // shorter ones aren't worth a loop of their own

/// Reciprocal Chebyshev points of [WIND_SMOOTH_FROM, 2], the largest first.
std::span<const float> upWeights() {
  static_assert(WIND_SWEEPS_UP <= kMostSweeps);
  static const std::vector<float> weights = [] {
    std::vector<float> made;
    for (int m = WIND_SWEEPS_UP - 1; m >= 0; --m) {
      const double middle = 0.5 * (2 + double(WIND_SMOOTH_FROM)), reach = 0.5 * (2 - double(WIND_SMOOTH_FROM));
      made.push_back(static_cast<float>(
          1 / (middle + reach * std::cos(std::numbers::pi * (2 * m + 1) / (2 * double(WIND_SWEEPS_UP))))));
    }
    return made;
  }();
  return weights;
}

CpuPlane planeOf(int width, int height, const std::vector<float>& values) {
  CpuPlane plane(width, height);
  for (int k = 0; k < height; ++k) {
    std::copy_n(values.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(width), width, plane.row(k));
  }
  return plane;
}

float ghostFactor(Border border) {
  return border == Border::Open ? -1.0f : 1.0f;
}

void findPlainRuns(CpuLevel& level, glm::vec2 conductance) {
  level.plainX = conductance.x;
  level.plainZ = conductance.y;
  level.plainInverse = 1 / (2 * (conductance.x + conductance.y));
  const auto close = [](float a, float b) { return std::abs(a - b) <= 1e-6f * b; };
  level.runStart.assign(1, 0);
  level.runs.clear();
  for (int k = 0; k < level.height; ++k) {
    const float *cx = level.cx.row(k), *low = level.cz.row(k), *high = level.cz.row(k + 1),
                *inverse = level.inverse.row(k);
    const auto plain = [&](int i) {
      return close(cx[i], conductance.x) && close(cx[i + 1], conductance.x) && close(low[i], conductance.y) &&
             close(high[i], conductance.y) && close(inverse[i], level.plainInverse);
    };
    const auto add = [&](LevelRun run) {
      if (run.plain && run.end - run.begin < kShortestPlainRun) run.plain = false;
      const bool first = static_cast<int>(level.runs.size()) == level.runStart.back();
      if (!first && !level.runs.back().plain && !run.plain) {
        level.runs.back().end = run.end;
      } else {
        level.runs.push_back(run);
      }
    };
    for (int begin = 0; begin < level.width;) {
      const bool kind = plain(begin);
      int end = begin + 1;
      while (end < level.width && plain(end) == kind) ++end;
      add({begin, end, kind});
      begin = end;
    }
    level.runStart.push_back(static_cast<int>(level.runs.size()));
  }
}

CpuLevel levelOf(const PressureLevel& source, const WindGrid& grid, glm::vec2 conductance) {
  CpuLevel level;
  level.width = source.width;
  level.height = source.height;
  level.factorX = source.factorX;
  level.factorZ = source.factorZ;
  level.periodicX = grid.periodicX();
  level.periodicZ = grid.periodicZ();
  level.d = CpuPlane(level.width, level.height);
  level.b = CpuPlane(level.width, level.height);
  level.next = CpuPlane(level.width, level.height);
  level.cx = planeOf(level.width + 1, level.height, source.cx);
  level.cz = planeOf(level.width, level.height + 1, source.cz);
  level.shareX = planeOf(level.width + 1, level.height, source.shareX);
  level.shareZ = planeOf(level.width, level.height + 1, source.shareZ);
  level.inverse = planeOf(level.width, level.height, source.inverseDiagonal);
  findPlainRuns(level, conductance);
  return level;
}

}  // namespace

void CpuMultigrid::rebuild(const WindGrid& grid) {
  m_xMin = grid.xMin;
  m_xMax = grid.xMax;
  m_zMin = grid.zMin;
  m_zMax = grid.zMax;
  m_levels.clear();
  glm::vec2 cell(grid.hx, grid.hz);
  const std::vector<PressureLevel> sources = buildPressureLevels(grid);
  m_lastInverse = denseInverse(sources.back());
  for (const PressureLevel& source : sources) {
    cell *= glm::vec2(source.factorX, source.factorZ);
    m_levels.push_back(levelOf(source, grid, {cell.y / cell.x, cell.x / cell.y}));
  }
  for (CpuPlane* plane : {&m_solution, &m_direction, &m_levels[0].applied, &m_levels[0].lastApplied}) {
    *plane = CpuPlane(grid.width, grid.height);
  }
}

void CpuMultigrid::setGhosts(CpuPlane& plane) const {
  const int w = plane.width(), h = plane.height();
  const bool wrapX = m_xMin == Border::Periodic, wrapZ = m_zMin == Border::Periodic;
  const float xLow = ghostFactor(m_xMin), xHigh = ghostFactor(m_xMax), zLow = ghostFactor(m_zMin),
              zHigh = ghostFactor(m_zMax);
  for (int k = 0; k < h; ++k) {
    plane.at(-1, k) = xLow * plane.at(wrapX ? w - 1 : 0, k);
    plane.at(w, k) = xHigh * plane.at(wrapX ? 0 : w - 1, k);
  }
  for (int i = 0; i < w; ++i) {
    plane.at(i, -1) = zLow * plane.at(i, wrapZ ? h - 1 : 0);
    plane.at(i, h) = zHigh * plane.at(i, wrapZ ? 0 : h - 1);
  }
}

LevelProducts CpuMultigrid::run(ThreadPool& pool, const LevelPass& pass) {
  CpuLevel& level = *pass.level;
  m_products.assign(static_cast<std::size_t>(tasksFor(level.height, kLevelRowsPerTask)), {});
  forRows(
      pool, level.width, level.height,
      [&](int task, int begin, int end) {
        m_products[static_cast<std::size_t>(task)] = runLevelPass(pass, begin, end);
      },
      kLevelRowsPerTask);
  if (pass.end != PassEnd::Restrict) std::swap(level.d, level.next);
  LevelProducts sum;
  for (const LevelProducts& p : m_products) {
    sum.withResidual += p.withResidual;
    sum.withLast += p.withLast;
    sum.withItself += p.withItself;
  }
  return sum;
}

void CpuMultigrid::solveLast() {
  CpuLevel& level = m_levels.back();
  const std::size_t w = static_cast<std::size_t>(level.width), count = w * static_cast<std::size_t>(level.height);
  std::vector<float> d(count, 0.0f);
  for (std::size_t c = 0; c < count; ++c) {
    const float b = level.b.at(static_cast<int>(c % w), static_cast<int>(c / w));
    for (std::size_t r = 0; r < count; ++r) d[r] += m_lastInverse[c * count + r] * b;
  }
  for (int k = 0; k < level.height; ++k) std::copy_n(&d[static_cast<std::size_t>(k) * w], w, level.d.row(k));
}

/// One V-cycle for the present b from d = 0. `joins`: it isn't the first of its solve.
LevelProducts CpuMultigrid::cycle(ThreadPool& pool, bool joins) {
  const std::size_t last = m_levels.size() - 1;
  constexpr float kDown[] = {WIND_SMOOTH_DOWN};
  for (std::size_t l = 0; l < last; ++l) {
    run(pool, {&m_levels[l], &m_levels[l + 1], PassStart::Zero, PassEnd::Restrict, kDown});
  }
  solveLast();
  LevelProducts products;
  for (std::size_t l = last; l-- > 0;) {
    setGhosts(m_levels[l + 1].d);
    products = run(pool, {&m_levels[l], &m_levels[l + 1], PassStart::Prolong, l == 0 ? PassEnd::Apply : PassEnd::None,
                          upWeights(), joins});
  }
  return products;
}

/// Makes the last cycle's correction part of the solution.
void CpuMultigrid::advance(ThreadPool& pool, float alpha, float beta, bool joins) {
  CpuLevel& fine = m_levels[0];
  forRows(pool, fine.width, fine.height, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const DirectionRows rows{fine.d.row(k),           fine.applied.row(k), m_direction.row(k),
                               fine.lastApplied.row(k), m_solution.row(k),   fine.b.row(k)};
      if (joins) {
        advanceSolution(rows, fine.width, alpha, beta);
      } else {
        beginSolution(rows, fine.width, alpha);
      }
    }
  });
}

int CpuMultigrid::solve(ThreadPool& pool, double startSquares, double wantedSquares, int maxCycles) {
  m_factor = 0;
  double squares = startSquares, lastSize = 0;
  int cycles = 0;
  while ((squares > wantedSquares || cycles == 0) && cycles < maxCycles) {
    const bool joins = cycles > 0;
    const LevelProducts p = cycle(pool, joins);
    const double beta = joins ? p.withLast / lastSize : 0;
    const double size = p.withItself - (joins ? beta * beta * lastSize : 0);
    if (!(size > 0)) break;
    ++cycles;
    const double alpha = p.withResidual / size;
    lastSize = size;
    squares -= alpha * p.withResidual;
    if (!joins && (squares <= wantedSquares || cycles == maxCycles)) {  // the usual case needs no more than this
      std::swap(m_solution, m_levels[0].d);
      m_factor = static_cast<float>(alpha);
      return cycles;
    }
    advance(pool, static_cast<float>(alpha), static_cast<float>(beta), joins);
    m_factor = 1;
  }
  return cycles;
}

void CpuMultigrid::sweep(ThreadPool& pool, int sweeps) {
  CpuLevel& fine = m_levels[0];
  constexpr float kPlain[kMostSweeps] = {1, 1, 1, 1, 1};
  for (int done = 0; done < sweeps;) {
    const int now = std::min(static_cast<int>(kMostSweeps), sweeps - done);
    for (int k = 0; k < fine.height; ++k) {
      fine.d.at(-1, k) = fine.periodicX ? fine.d.at(fine.width - 1, k) : 0.0f;
      fine.d.at(fine.width, k) = fine.periodicX ? fine.d.at(0, k) : 0.0f;
    }
    run(pool, {&fine, nullptr, done == 0 ? PassStart::Zero : PassStart::Plane, PassEnd::None,
               std::span(kPlain).first(static_cast<std::size_t>(now))});
    done += now;
  }
  std::swap(fine.d, m_solution);
  m_factor = 1;
}

std::size_t CpuMultigrid::memoryBytes() const {
  std::size_t sum = m_solution.bytes() + m_direction.bytes() + m_lastInverse.size() * sizeof(float);
  for (const CpuLevel& l : m_levels) {
    for (const CpuPlane* p :
         {&l.d, &l.b, &l.next, &l.cx, &l.cz, &l.shareX, &l.shareZ, &l.inverse, &l.applied, &l.lastApplied}) {
      if (p->width() > 0) sum += p->bytes();
    }
  }
  return sum;
}

}  // namespace windloom
