// Cell-centred geometric multigrid: Wesseling, An Introduction to Multigrid Methods, 1992 (averaging restriction,
// linear prolongation); smoother: Jacobi with Chebyshev weights, after Adams, Brezina, Hu & Tuminaro, Parallel
// multigrid smoothing: polynomial versus Gauss-Seidel, 2003.
#include "engine/wind/cpu_multigrid.hpp"

#include <algorithm>
#include <numeric>

#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

constexpr int kShortestPlainRun = 16;  // shorter ones aren't worth a loop of their own

CpuPlane planeOf(int width, int height, const std::vector<float>& values) {
  CpuPlane plane(width, height);
  for (int k = 0; k < height; ++k) {
    std::copy_n(values.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(width), width, plane.row(k));
  }
  return plane;
}

float ghostFactor(Border border) { return border == Border::Open ? -1.0f : 1.0f; }

void findPlainRuns(CpuLevel& level, glm::vec2 conductance) {
  level.plainX = conductance.x;
  level.plainZ = conductance.y;
  level.plainInverse = 1 / (2 * (conductance.x + conductance.y));
  const auto close = [](float a, float b) { return std::abs(a - b) <= 1e-6f * b; };
  level.runStart.assign(1, 0);
  level.runs.clear();
  for (int k = 0; k < level.height; ++k) {
    const float *cx = level.cx.row(k), *low = level.cz.row(k), *high = level.cz.row(k + 1), *inverse = level.inverse.row(k);
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
  m_zero = true;
  glm::vec2 cell(grid.hx, grid.hz);
  for (const PressureLevel& source : buildPressureLevels(grid)) {
    cell *= glm::vec2(source.factorX, source.factorZ);
    m_levels.push_back(levelOf(source, grid, {cell.y / cell.x, cell.x / cell.y}));
  }
}

void CpuMultigrid::wrapSides(CpuLevel& level) const {
  for (int k = 0; k < level.height; ++k) {
    level.d.at(-1, k) = level.periodicX ? level.d.at(level.width - 1, k) : 0.0f;
    level.d.at(level.width, k) = level.periodicX ? level.d.at(0, k) : 0.0f;
  }
}

void CpuMultigrid::setGhosts(CpuPlane& plane) const {
  const int w = plane.width(), h = plane.height();
  const bool wrapX = m_xMin == Border::Periodic, wrapZ = m_zMin == Border::Periodic;
  const float xLow = ghostFactor(m_xMin), xHigh = ghostFactor(m_xMax), zLow = ghostFactor(m_zMin), zHigh = ghostFactor(m_zMax);
  for (int k = 0; k < h; ++k) {
    plane.at(-1, k) = xLow * plane.at(wrapX ? w - 1 : 0, k);
    plane.at(w, k) = xHigh * plane.at(wrapX ? 0 : w - 1, k);
  }
  for (int i = 0; i < w; ++i) {
    plane.at(i, -1) = zLow * plane.at(i, wrapZ ? h - 1 : 0);
    plane.at(i, h) = zHigh * plane.at(i, wrapZ ? 0 : h - 1);
  }
}

void CpuMultigrid::start() {
  m_levels[0].d.clear();
  m_zero = true;
}

double CpuMultigrid::run(ThreadPool& pool, const LevelPass& pass) {
  CpuLevel& level = *pass.level;
  const int tasks = (level.height + kLevelRowsPerTask - 1) / kLevelRowsPerTask;
  m_sums.assign(static_cast<std::size_t>(tasks), 0);
  pool.parallelFor(tasks, [&](int task) {
    const int begin = task * kLevelRowsPerTask;
    m_sums[static_cast<std::size_t>(task)] = runLevelPass(pass, begin, std::min(level.height, begin + kLevelRowsPerTask));
  });
  std::swap(level.d, level.next);
  return std::accumulate(m_sums.begin(), m_sums.end(), 0.0);
}

double CpuMultigrid::cycle(ThreadPool& pool) {
  const std::size_t last = m_levels.size() - 1;
  for (std::size_t l = 0; l < last; ++l) {
    const bool zero = l > 0 || m_zero;
    if (!zero) wrapSides(m_levels[l]);
    run(pool, {&m_levels[l], &m_levels[l + 1], zero ? PassStart::Zero : PassStart::Plane, PassEnd::Restrict,
               {WIND_SMOOTH_0, WIND_SMOOTH_1, WIND_SMOOTH_2}, 3});
  }
  m_zero = false;
  CpuLevel& single = m_levels[last];
  single.d.at(0, 0) = -single.b.at(0, 0) * single.inverse.at(0, 0);
  double squares = 0;
  for (std::size_t l = last; l-- > 0;) {
    setGhosts(m_levels[l + 1].d);
    squares = run(pool, {&m_levels[l], &m_levels[l + 1], PassStart::Prolong, l == 0 ? PassEnd::Measure : PassEnd::None,
                         {WIND_SMOOTH_2, WIND_SMOOTH_1, WIND_SMOOTH_0}, 3});
  }
  return squares;
}

void CpuMultigrid::sweep(ThreadPool& pool, int sweeps) {
  for (int done = 0; done < sweeps;) {
    const int now = std::min(3, sweeps - done);
    if (!m_zero) wrapSides(m_levels[0]);
    run(pool, {&m_levels[0], nullptr, m_zero ? PassStart::Zero : PassStart::Plane, PassEnd::None, {1, 1, 1}, now});
    m_zero = false;
    done += now;
  }
}

std::size_t CpuMultigrid::memoryBytes() const {
  std::size_t sum = 0;
  for (const CpuLevel& l : m_levels) {
    for (const CpuPlane* p : {&l.d, &l.b, &l.next, &l.cx, &l.cz, &l.shareX, &l.shareZ, &l.inverse}) sum += p->bytes();
  }
  return sum;
}

}  // namespace windloom
