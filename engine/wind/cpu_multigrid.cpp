// Cell-centred geometric multigrid: Wesseling, An Introduction to Multigrid Methods, 1992 (averaging restriction,
// linear prolongation); smoother: Jacobi with Chebyshev weights, after Adams, Brezina, Hu & Tuminaro, Parallel
// multigrid smoothing: polynomial versus Gauss-Seidel, 2003.
#include "engine/wind/cpu_multigrid.hpp"

#include <algorithm>
#include <numeric>

#include "engine/wind/cpu_fields.hpp"
#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

constexpr float kWeights[3] = {WIND_SMOOTH_0, WIND_SMOOTH_1, WIND_SMOOTH_2};

CpuPlane planeOf(int width, int height, const std::vector<float>& values) {
  CpuPlane plane(width, height);
  for (int k = 0; k < height; ++k) {
    std::copy_n(values.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(width), width, plane.row(k));
  }
  return plane;
}

float ghostFactor(Border border) { return border == Border::Open ? -1.0f : 1.0f; }

}  // namespace

void CpuMultigrid::rebuild(const WindGrid& grid) {
  m_xMin = grid.xMin;
  m_xMax = grid.xMax;
  m_zMin = grid.zMin;
  m_zMax = grid.zMax;
  m_levels.clear();
  for (const PressureLevel& source : buildPressureLevels(grid)) {
    Level level;
    level.width = source.width;
    level.height = source.height;
    level.factorX = source.factorX;
    level.factorZ = source.factorZ;
    level.d = CpuPlane(level.width, level.height);
    level.b = CpuPlane(level.width, level.height);
    level.next = CpuPlane(level.width, level.height);
    level.cx = planeOf(level.width + 1, level.height, source.cx);
    level.cz = planeOf(level.width, level.height + 1, source.cz);
    level.shareX = planeOf(level.width + 1, level.height, source.shareX);
    level.shareZ = planeOf(level.width, level.height + 1, source.shareZ);
    level.inverse = planeOf(level.width, level.height, source.inverseDiagonal);
    m_levels.push_back(std::move(level));
  }
}

void CpuMultigrid::wrapGhosts(CpuPlane& plane) const {
  const int w = plane.width(), h = plane.height();
  if (m_xMin == Border::Periodic) {
    for (int k = 0; k < h; ++k) {
      plane.at(-1, k) = plane.at(w - 1, k);
      plane.at(w, k) = plane.at(0, k);
    }
  }
  if (m_zMin == Border::Periodic) {
    std::copy_n(plane.row(h - 1), w, plane.row(-1));
    std::copy_n(plane.row(0), w, plane.row(h));
  }
}

void CpuMultigrid::borderGhosts(CpuPlane& plane) const {
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

void CpuMultigrid::start() { m_levels[0].d.clear(); }

void CpuMultigrid::sweepLevel(ThreadPool& pool, Level& level, float weight) {
  wrapGhosts(level.d);
  forRowTasks(pool, level.height, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const float *d = level.d.row(k), *low = level.d.row(k - 1), *high = level.d.row(k + 1), *b = level.b.row(k);
      const float *cx = level.cx.row(k), *czLow = level.cz.row(k), *czHigh = level.cz.row(k + 1), *inverse = level.inverse.row(k);
      float* out = level.next.row(k);
      for (int i = 0; i < level.width; ++i) {
        const float sum = (cx[i] * d[i - 1] + cx[i + 1] * d[i + 1]) + (czLow[i] * low[i] + czHigh[i] * high[i]);
        out[i] = d[i] + weight * ((sum - b[i]) * inverse[i] - d[i]);
      }
    }
  });
  std::swap(level.d, level.next);
}

namespace {
/// b - A d of one row.
template <class Level>
void residualRow(const Level& level, int k, float* out) {
  const float *d = level.d.row(k), *low = level.d.row(k - 1), *high = level.d.row(k + 1), *b = level.b.row(k);
  const float *cx = level.cx.row(k), *czLow = level.cz.row(k), *czHigh = level.cz.row(k + 1), *inverse = level.inverse.row(k);
  for (int i = 0; i < level.width; ++i) {
    const float sum = (cx[i] * d[i - 1] + cx[i + 1] * d[i + 1]) + (czLow[i] * low[i] + czHigh[i] * high[i]);
    out[i] = inverse[i] > 0 ? b[i] - (sum - d[i] / inverse[i]) : 0.0f;
  }
}
}  // namespace

void CpuMultigrid::restrictResidual(ThreadPool& pool, const Level& fine, Level& coarse) {
  const int fx = coarse.factorX, fz = coarse.factorZ;
  forRowTasks(pool, coarse.height, [&](int, int begin, int end) {
    std::vector<float> residual(static_cast<std::size_t>(fine.width));
    for (int k = begin; k < end; ++k) {
      float* out = coarse.b.row(k);
      std::fill_n(out, coarse.width, 0.0f);
      for (int m = k * fz; m < std::min((k + 1) * fz, fine.height); ++m) {
        residualRow(fine, m, residual.data());
        for (int i = 0; i < fine.width; ++i) out[i / fx] += residual[static_cast<std::size_t>(i)];
      }
    }
  });
}

void CpuMultigrid::prolong(ThreadPool& pool, Level& coarse, Level& fine) {
  borderGhosts(coarse.d);
  const int fx = coarse.factorX, fz = coarse.factorZ;
  forRowTasks(pool, fine.height, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      const int ck = k / fz;
      const bool highZ = fz == 2 && (k & 1);
      const float *c = coarse.d.row(ck), *z = coarse.d.row(highZ ? ck + 1 : ck - 1);
      const float *sx = coarse.shareX.row(ck), *sz = coarse.shareZ.row(highZ ? ck + 1 : ck);
      const float *inverse = fine.inverse.row(k);
      const float quarterX = fx == 2 ? 0.25f : 0.0f, quarterZ = fz == 2 ? 0.25f : 0.0f;
      float* d = fine.d.row(k);
      for (int i = 0; i < fine.width; ++i) {
        const int ci = i / fx;
        const int high = fx == 2 && (i & 1) ? 1 : 0;
        const float own = c[ci];
        const float e = own + quarterX * sx[ci + high] * (c[high ? ci + 1 : ci - 1] - own) + quarterZ * sz[ci] * (z[ci] - own);
        d[i] += inverse[i] > 0 ? e : 0.0f;
      }
    }
  });
}

void CpuMultigrid::cycle(ThreadPool& pool) {
  const std::size_t last = m_levels.size() - 1;
  for (std::size_t l = 0; l < last; ++l) {
    for (int m = 0; m < 3; ++m) sweepLevel(pool, m_levels[l], kWeights[m]);
    wrapGhosts(m_levels[l].d);
    restrictResidual(pool, m_levels[l], m_levels[l + 1]);
    m_levels[l + 1].d.clear();
  }
  Level& single = m_levels[last];
  if (last > 0) single.d.at(0, 0) = -single.b.at(0, 0) * single.inverse.at(0, 0);
  for (std::size_t l = last; l-- > 0;) {
    prolong(pool, m_levels[l + 1], m_levels[l]);
    for (int m = 2; m >= 0; --m) sweepLevel(pool, m_levels[l], kWeights[m]);
  }
}

double CpuMultigrid::residualSquares(ThreadPool& pool) {
  Level& level = m_levels[0];
  wrapGhosts(level.d);
  m_sums.assign(static_cast<std::size_t>(rowTasks(level.height)), 0);
  forRowTasks(pool, level.height, [&](int task, int begin, int end) {
    std::vector<float> residual(static_cast<std::size_t>(level.width));
    double sum = 0;
    for (int k = begin; k < end; ++k) {
      residualRow(level, k, residual.data());
      for (const float r : residual) sum += double(r) * double(r);
    }
    m_sums[static_cast<std::size_t>(task)] = sum;
  });
  return std::accumulate(m_sums.begin(), m_sums.end(), 0.0);
}

std::size_t CpuMultigrid::memoryBytes() const {
  std::size_t sum = 0;
  for (const Level& l : m_levels) {
    for (const CpuPlane* p : {&l.d, &l.b, &l.next, &l.cx, &l.cz, &l.shareX, &l.shareZ, &l.inverse}) sum += p->bytes();
  }
  return sum;
}

}  // namespace windloom
