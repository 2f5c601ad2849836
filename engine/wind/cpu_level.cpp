// Row kernels compiled for several instruction sets, chosen when the program runs (Highway). The loops are plain: with
// the target set by Highway's attributes the compiler vectorises them; no multiply-add, so that all sets give the same
// bytes.
#include "engine/wind/cpu_level.hpp"

#include <algorithm>

#include "shaders/shared/wind_constants.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/wind/cpu_level.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace windloom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
#include "engine/wind/cpu_sums.hpp"

/// Rows of the stages between the sweeps: the last four of each.
class Rings {
 public:
  Rings(const CpuLevel& level, std::vector<float>& memory)
      : m_width(level.width), m_stride((level.width + 2 * CpuPlane::kMargin + 15) / 16 * 16) {
    memory.assign(static_cast<std::size_t>(m_stride) * (kStages * 4 + 2), 0.0f);
    m_memory = memory.data() + CpuPlane::kMargin;
  }
  [[nodiscard]] float* row(int stage, int k) {
    return m_memory + static_cast<std::ptrdiff_t>(stage * 4 + (k & 3)) * m_stride;
  }
  [[nodiscard]] float* zero() { return m_memory + static_cast<std::ptrdiff_t>(kStages * 4) * m_stride; }
  [[nodiscard]] float* residual() { return m_memory + static_cast<std::ptrdiff_t>(kStages * 4 + 1) * m_stride; }

 private:
  static constexpr int kStages = static_cast<int>(kMostSweeps) + 1;
  int m_width, m_stride;
  float* m_memory;
};

struct RowPlace {
  const CpuLevel& level;
  int k;  // row in the level
};

struct Neighbours {
  const float *own, *low, *high;
};

/// out = d + weight (D^-1 (sum c d_neighbour - b) - d), 0 in cells without air.
HWY_ATTR void smoothRow(RowPlace at, Neighbours d, float weight, float* HWY_RESTRICT out) {
  const CpuLevel& l = at.level;
  const float* HWY_RESTRICT b = l.b.row(at.k);
  const float *HWY_RESTRICT own = d.own, *HWY_RESTRICT low = d.low, *HWY_RESTRICT high = d.high;
  const float keep = 1 - weight;
  for (int n = l.runStart[static_cast<std::size_t>(at.k)]; n < l.runStart[static_cast<std::size_t>(at.k) + 1]; ++n) {
    const LevelRun run = l.runs[static_cast<std::size_t>(n)];
    if (run.plain) {
      const float ax = l.plainX, az = l.plainZ, scale = weight * l.plainInverse;
      for (int i = run.begin; i < run.end; ++i) {
        const float sum = ax * (own[i - 1] + own[i + 1]) + az * (low[i] + high[i]);
        out[i] = keep * own[i] + scale * (sum - b[i]);
      }
    } else {
      const float *cx = l.cx.row(at.k), *czLow = l.cz.row(at.k), *czHigh = l.cz.row(at.k + 1),
                  *inverse = l.inverse.row(at.k);
      for (int i = run.begin; i < run.end; ++i) {
        const float sum = (cx[i] * own[i - 1] + cx[i + 1] * own[i + 1]) + (czLow[i] * low[i] + czHigh[i] * high[i]);
        const float value = keep * own[i] + weight * inverse[i] * (sum - b[i]);
        out[i] = inverse[i] > 0 ? value : 0.0f;
      }
    }
  }
}

/// The first sweep from d = 0.
HWY_ATTR void startRow(RowPlace at, float weight, float* HWY_RESTRICT out) {
  const float *HWY_RESTRICT b = at.level.b.row(at.k), *HWY_RESTRICT inverse = at.level.inverse.row(at.k);
  for (int i = 0; i < at.level.width; ++i) out[i] = -(weight * inverse[i]) * b[i];
}

/// out = b - A d.
HWY_ATTR void residualRow(RowPlace at, Neighbours d, float* HWY_RESTRICT out) {
  const CpuLevel& l = at.level;
  const float* HWY_RESTRICT b = l.b.row(at.k);
  const float *HWY_RESTRICT own = d.own, *HWY_RESTRICT low = d.low, *HWY_RESTRICT high = d.high;
  for (int n = l.runStart[static_cast<std::size_t>(at.k)]; n < l.runStart[static_cast<std::size_t>(at.k) + 1]; ++n) {
    const LevelRun run = l.runs[static_cast<std::size_t>(n)];
    if (run.plain) {
      const float ax = l.plainX, az = l.plainZ, diagonal = 2 * (ax + az);
      for (int i = run.begin; i < run.end; ++i) {
        out[i] = (b[i] + diagonal * own[i]) - (ax * (own[i - 1] + own[i + 1]) + az * (low[i] + high[i]));
      }
    } else {
      const float *cx = l.cx.row(at.k), *czLow = l.cz.row(at.k), *czHigh = l.cz.row(at.k + 1),
                  *inverse = l.inverse.row(at.k);
      for (int i = run.begin; i < run.end; ++i) {
        const float sum = (cx[i] * own[i - 1] + cx[i + 1] * own[i + 1]) + (czLow[i] * low[i] + czHigh[i] * high[i]);
        out[i] = inverse[i] > 0 ? b[i] - (sum - own[i] / inverse[i]) : 0.0f;
      }
    }
  }
}

/// out = d + the coarse correction, interpolated linearly from the cell above and its neighbours on this cell's side.
HWY_ATTR void prolongRow(RowPlace at, const CpuLevel& coarse, const float* HWY_RESTRICT d, float* HWY_RESTRICT out) {
  const int ck = at.k / coarse.factorZ, width = at.level.width;
  const bool pairs = coarse.factorZ == 2, upper = pairs && (at.k & 1) != 0;
  const float* HWY_RESTRICT c = coarse.d.row(ck);
  const float* HWY_RESTRICT z = coarse.d.row(upper ? ck + 1 : pairs ? ck - 1 : ck);
  const float *HWY_RESTRICT sx = coarse.shareX.row(ck), *HWY_RESTRICT sz = coarse.shareZ.row(upper ? ck + 1 : ck);
  if (coarse.factorX == 1) {
    for (int i = 0; i < width; ++i) out[i] = d[i] + (c[i] + 0.25f * sz[i] * (z[i] - c[i]));
    return;
  }
  for (int i = 0; i < width / 2; ++i) {
    const float middle = c[i] + 0.25f * sz[i] * (z[i] - c[i]);
    out[2 * i] = d[2 * i] + (middle + 0.25f * sx[i] * (c[i - 1] - c[i]));
    out[2 * i + 1] = d[2 * i + 1] + (middle + 0.25f * sx[i + 1] * (c[i + 1] - c[i]));
  }
  if (width % 2 != 0) {
    const int i = width / 2;
    const float middle = c[i] + 0.25f * sz[i] * (z[i] - c[i]);
    out[2 * i] = d[2 * i] + (middle + 0.25f * sx[i] * (c[i - 1] - c[i]));
  }
}

HWY_ATTR void restrictRow(const float* HWY_RESTRICT residual, const CpuLevel& fine, CpuLevel& coarse, int k) {
  float* HWY_RESTRICT out = coarse.b.row(k / coarse.factorZ);
  if (k % coarse.factorZ == 0) std::fill_n(out, coarse.width, 0.0f);
  if (coarse.factorX == 1) {
    for (int i = 0; i < coarse.width; ++i) out[i] += residual[i];
    return;
  }
  for (int i = 0; i < fine.width / 2; ++i) out[i] += residual[2 * i] + residual[2 * i + 1];
  if (fine.width % 2 != 0) out[fine.width / 2] += residual[fine.width - 1];
}

/// The pipeline: row r enters at stage 0, and stage m works on row r - m.
class Pipeline {
 public:
  HWY_ATTR Pipeline(const LevelPass& pass, int begin, int end, std::vector<float>& memory)
      : m_pass(pass), m_level(*pass.level), m_rings(m_level, memory), m_begin(begin), m_end(end) {}

  HWY_ATTR LevelProducts run() {
    const int sweeps = this->sweeps(), tail = m_pass.end == PassEnd::None ? 0 : 1;
    const int reach = sweeps + tail;
    LevelProducts products;
    for (int r = m_begin - reach; r < m_end + 2 * reach; ++r) {
      if (m_pass.start == PassStart::Prolong && inside(r, reach)) enter(r);
      for (int m = 1; m <= sweeps; ++m) {
        const int k = r - m;
        if (inside(k, reach - m)) sweepRow(m, k);
      }
      const int k = r - reach;
      if (tail != 0 && k >= m_begin && k < m_end) leave(k, products);
    }
    return products;
  }

 private:
  [[nodiscard]] int sweeps() const { return static_cast<int>(m_pass.weights.size()); }
  /// Whether stage rows with `more` rows on each side of the task hold row k.
  [[nodiscard]] bool inside(int k, int more) const {
    return k >= m_begin - more && k < m_end + more && (m_level.periodicZ || (k >= 0 && k < m_level.height));
  }
  [[nodiscard]] int wrap(int k) const {
    return m_level.periodicZ ? (k % m_level.height + m_level.height) % m_level.height : k;
  }
  [[nodiscard]] const float* rowOf(int stage, int k) {
    if (!m_level.periodicZ && (k < 0 || k >= m_level.height)) return m_rings.zero();
    if (stage == 0 && m_pass.start == PassStart::Plane) return m_level.d.row(wrap(k));
    return m_rings.row(stage, k);
  }
  [[nodiscard]] Neighbours around(int stage, int k) {
    return {rowOf(stage, k), rowOf(stage, k - 1), rowOf(stage, k + 1)};
  }
  void setEnds(float* row) const {
    row[-1] = m_level.periodicX ? row[m_level.width - 1] : 0.0f;
    row[m_level.width] = m_level.periodicX ? row[0] : 0.0f;
  }
  HWY_ATTR void enter(int k) {
    float* out = m_rings.row(0, k);
    float* before = m_rings.residual();  // free until the row's residual is due
    startRow({m_level, wrap(k)}, WIND_SMOOTH_DOWN, before);
    prolongRow({m_level, wrap(k)}, *m_pass.coarse, before, out);
    setEnds(out);
  }
  HWY_ATTR void sweepRow(int stage, int k) {
    float* out = m_rings.row(stage, k);
    if (stage == 1 && m_pass.start == PassStart::Zero) {
      startRow({m_level, wrap(k)}, m_pass.weights[0], out);
    } else {
      smoothRow({m_level, wrap(k)}, around(stage - 1, k), m_pass.weights[static_cast<std::size_t>(stage - 1)], out);
    }
    setEnds(out);
    const bool keeps = m_pass.end != PassEnd::Restrict && stage == sweeps();
    if (keeps && k >= m_begin && k < m_end) std::copy_n(out, m_level.width, m_level.next.row(k));
  }
  HWY_ATTR void leave(int k, LevelProducts& products) {
    residualRow({m_level, k}, around(sweeps(), k), m_rings.residual());
    if (m_pass.end == PassEnd::Restrict) {
      restrictRow(m_rings.residual(), m_level, *m_pass.coarse, k);
      return;
    }
    float* HWY_RESTRICT applied = m_level.applied.row(k);
    const float *HWY_RESTRICT b = m_level.b.row(k), *HWY_RESTRICT residual = m_rings.residual();
    for (int i = 0, width = m_level.width; i < width; ++i) applied[i] = b[i] - residual[i];
    products.withResidual += productOf(b, applied, m_level.width);
    if (m_pass.joins) products.withLast += productOf(applied, m_level.lastApplied.row(k), m_level.width);
    products.withItself += productOf(applied, applied, m_level.width);
  }

  const LevelPass& m_pass;
  CpuLevel& m_level;
  Rings m_rings;
  int m_begin, m_end;
};

HWY_ATTR LevelProducts levelPassRows(const LevelPass& pass, int begin, int end) {
  thread_local std::vector<float> memory;
  return Pipeline(pass, begin, end, memory).run();
}

HWY_ATTR void advanceRow(const DirectionRows& rows, int count, float alpha, float beta) {
  const float *HWY_RESTRICT fresh = rows.fresh, *HWY_RESTRICT freshApplied = rows.freshApplied;
  float *HWY_RESTRICT direction = rows.direction, *HWY_RESTRICT applied = rows.applied;
  float *HWY_RESTRICT solution = rows.solution, *HWY_RESTRICT residual = rows.residual;
  for (int i = 0; i < count; ++i) {
    const float p = fresh[i] - beta * direction[i], ap = freshApplied[i] - beta * applied[i];
    direction[i] = p;
    applied[i] = ap;
    solution[i] += alpha * p;
    residual[i] -= alpha * ap;
  }
}

HWY_ATTR void beginRow(const DirectionRows& rows, int count, float alpha) {
  const float *HWY_RESTRICT fresh = rows.fresh, *HWY_RESTRICT freshApplied = rows.freshApplied;
  float *HWY_RESTRICT direction = rows.direction, *HWY_RESTRICT applied = rows.applied;
  float *HWY_RESTRICT solution = rows.solution, *HWY_RESTRICT residual = rows.residual;
  for (int i = 0; i < count; ++i) {
    direction[i] = fresh[i];
    applied[i] = freshApplied[i];
    solution[i] = alpha * fresh[i];
    residual[i] -= alpha * freshApplied[i];
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace windloom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace windloom {

HWY_EXPORT(levelPassRows);
HWY_EXPORT(advanceRow);
HWY_EXPORT(beginRow);

LevelProducts runLevelPass(const LevelPass& pass, int begin, int end) {
  return HWY_DYNAMIC_DISPATCH(levelPassRows)(pass, begin, end);
}

void advanceSolution(const DirectionRows& rows, int count, float alpha, float beta) {
  HWY_DYNAMIC_DISPATCH(advanceRow)(rows, count, alpha, beta);
}

void beginSolution(const DirectionRows& rows, int count, float alpha) {
  HWY_DYNAMIC_DISPATCH(beginRow)(rows, count, alpha);
}

}  // namespace windloom
#endif
