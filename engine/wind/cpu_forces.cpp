// Vorticity confinement: Fedkiw, Stam & Jensen, Visual Simulation of Smoke, 2001. Deviation: bounded by the local
// speed. Compiled for several instruction sets, chosen when the program runs (Highway).
#include "engine/wind/cpu_forces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "engine/wind/cpu_arrows.hpp"
#include "engine/wind/cpu_borders.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/wind/cpu_forces.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef WINDLOOM_WIND_CPU_FORCES_ONCE
#define WINDLOOM_WIND_CPU_FORCES_ONCE
namespace windloom {

using GustLayers = std::array<WindGustLayer, WIND_GUST_LAYERS>;

/// Increments of one row of cells that the arrows' part is already in.
struct ForceRow {
  int k;
  float *incrementX, *incrementZ;
};

}  // namespace windloom
#endif

HWY_BEFORE_NAMESPACE();
namespace windloom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::RebindToSigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Ints = hn::Vec<IntTag>;

/// Vorticity at the nodes of row k (0..H), out[0..W].
HWY_ATTR void nodeVorticity(const CpuFields& f, int k, float* HWY_RESTRICT out) {
  const WindGrid& g = f.grid;
  const float ix = 1 / g.hx, iz = 1 / g.hz;
  if ((k == 0 || k == g.height) && !g.periodicZ()) {
    std::fill_n(out, g.width + 1, 0.0f);
    return;
  }
  const float* HWY_RESTRICT w = f.velocity.w.row(k);
  const float* HWY_RESTRICT uLow = f.velocity.u.row(k - 1);
  const float* HWY_RESTRICT uHigh = f.velocity.u.row(k);
  for (int i = 0, width = g.width; i <= width; ++i) out[i] = (w[i] - w[i - 1]) * ix - (uHigh[i] - uLow[i]) * iz;
  if (!g.periodicX()) out[0] = out[g.width] = 0;
  for (const CpuRun& run : runsOf(f.solidNodes, k)) std::fill(out + run.begin, out + run.end, 0.0f);
}

/// `low` and `high` are the vorticities at the nodes below and above the row.
HWY_ATTR void addConfinement(const CpuFields& f, ForceRow row, const float* nodesLow, const float* nodesHigh) {
  const FloatTag d;
  const float h = std::sqrt(f.grid.hx * f.grid.hz), quarterX = 0.5f / f.grid.hx, quarterZ = 0.5f / f.grid.hz;
  const Floats halfX = hn::Set(d, quarterX), halfZ = hn::Set(d, quarterZ), tiny = hn::Set(d, 1e-5f / h);
  const Floats soft =
      hn::Set(d, 0.25f * WIND_CONFINEMENT_SOFTNESS * std::sqrt(2 * (quarterX * quarterX + quarterZ * quarterZ)));
  const Floats scale = hn::Set(d, 0.25f * f.dt * f.solver.confinement * h);
  const float growth = 1 + WIND_CONFINEMENT_GAIN * f.dt;
  const Floats limit = hn::Set(d, WIND_CONFINEMENT_LIMIT * WIND_CONFINEMENT_LIMIT), gain = hn::Set(d, growth * growth);
  const Floats least = hn::Set(d, 1e-30f), one = hn::Set(d, 1.0f);
  const float *vx = f.speedX.row(row.k), *vz = f.speedZ.row(row.k);
  for (int i = 0, width = f.width(); i < width; i += static_cast<int>(hn::Lanes(d))) {
    const Floats low = hn::LoadU(d, nodesLow + i), lowNext = hn::LoadU(d, nodesLow + i + 1);
    const Floats high = hn::LoadU(d, nodesHigh + i), highNext = hn::LoadU(d, nodesHigh + i + 1);
    const Floats a = hn::Abs(low), b = hn::Abs(lowNext), c = hn::Abs(high), e = hn::Abs(highNext);
    const Floats etaX = hn::Mul(hn::Sub(hn::Add(b, e), hn::Add(a, c)), halfX),
                 etaZ = hn::Mul(hn::Sub(hn::Add(c, e), hn::Add(a, b)), halfZ);
    const Floats blur = hn::Add(hn::Mul(soft, hn::Add(hn::Add(a, b), hn::Add(c, e))), tiny);
    const Floats steepness = hn::Sqrt(hn::Add(hn::Mul(etaX, etaX), hn::Mul(etaZ, etaZ)));
    const Floats push =
        hn::Div(hn::Mul(scale, hn::Add(hn::Add(low, lowNext), hn::Add(high, highNext))), hn::Add(steepness, blur));
    const Floats dx = hn::Mul(push, etaZ), dz = hn::Neg(hn::Mul(push, etaX));
    const Floats x = hn::LoadU(d, vx + i), z = hn::LoadU(d, vz + i);
    const Floats own = hn::Add(hn::Mul(x, x), hn::Mul(z, z));
    const Floats size = hn::Max(hn::Add(hn::Mul(dx, dx), hn::Mul(dz, dz)), least);
    const Floats cut = hn::Min(hn::Sqrt(hn::Div(hn::Mul(limit, own), size)), one);
    const Floats nx = hn::Add(x, hn::Mul(dx, cut)), nz = hn::Add(z, hn::Mul(dz, cut));
    const Floats reached = hn::Max(hn::Add(hn::Mul(nx, nx), hn::Mul(nz, nz)), least);
    const Floats keep = hn::Min(hn::Sqrt(hn::Div(hn::Mul(gain, own), reached)), one);
    hn::StoreU(hn::Add(hn::LoadU(d, row.incrementX + i), hn::Sub(hn::Mul(nx, keep), x)), d, row.incrementX + i);
    hn::StoreU(hn::Add(hn::LoadU(d, row.incrementZ + i), hn::Sub(hn::Mul(nz, keep), z)), d, row.incrementZ + i);
  }
}

constexpr int kGustChunk = 64;  // cells whose texels wait in the first cache

/// What the gusts of a chunk are made from.
struct GustChunk {
  HWY_ALIGN float sumX[kGustChunk], sumZ[kGustChunk], partAlong[kGustChunk], partAcross[kGustChunk];
  HWY_ALIGN std::int32_t texel[kGustChunk];
  HWY_ALIGN float low[kGustChunk * 4], high[kGustChunk * 4];  // both components of two texels in a row
};

/// Sums of the copies of the table over the cells from (i, k). The texels are copied one by one: a gather of the eight
/// numbers of each cell took several times as long.
HWY_ATTR void sumGustLayers(const CpuFields& f, int i, int k, const GustLayers& layers, GustChunk& chunk) {
  const FloatTag d;
  const IntTag di;
  const glm::vec2 corner = f.grid.mapping.minCorner, size = f.grid.mapping.cellSize;
  const float z = corner.y + (static_cast<float>(k) + 0.5f) * size.y;
  std::fill_n(chunk.sumX, kGustChunk, 0.0f);
  std::fill_n(chunk.sumZ, kGustChunk, 0.0f);
  for (const WindGustLayer& layer : layers) {
    const Floats cosine = hn::Set(d, layer.axis.x), sine = hn::Set(d, layer.axis.y);
    const Floats scale = hn::Set(d, layer.texelsPerMetre), weight = hn::Set(d, layer.weight);
    const Ints wrap = hn::Set(di, WIND_GUST_TABLE - 1), stride = hn::Set(di, kGustRow);
    for (std::size_t n = 0; n < kGustChunk; n += hn::Lanes(d)) {
      const Floats cell = hn::Iota(d, static_cast<float>(i + static_cast<int>(n)) + 0.5f);
      const Floats x = hn::Add(hn::Set(d, corner.x), hn::Mul(cell, hn::Set(d, size.x)));
      const Floats turnedX = hn::Add(hn::Mul(x, cosine), hn::Set(d, z * layer.axis.y));
      const Floats turnedZ = hn::Sub(hn::Set(d, z * layer.axis.x), hn::Mul(x, sine));
      const Floats a = hn::Add(hn::Mul(turnedX, scale), hn::Set(d, layer.offset.x));
      const Floats b = hn::Add(hn::Mul(turnedZ, scale), hn::Set(d, layer.offset.y));
      const Floats aWhole = hn::Floor(a), bWhole = hn::Floor(b);
      hn::Store(hn::Sub(a, aWhole), d, chunk.partAlong + n);
      hn::Store(hn::Sub(b, bWhole), d, chunk.partAcross + n);
      const Ints column = hn::And(hn::ConvertTo(di, aWhole), wrap), row = hn::And(hn::ConvertTo(di, bWhole), wrap);
      hn::Store(hn::Add(hn::Mul(row, stride), column), di, chunk.texel + n);
    }
    for (int n = 0; n < kGustChunk; ++n) {
      const glm::vec2* texel = f.gustTable.data() + chunk.texel[n];
      std::memcpy(chunk.low + 4 * n, texel, 2 * sizeof(glm::vec2));
      std::memcpy(chunk.high + 4 * n, texel + kGustRow, 2 * sizeof(glm::vec2));
    }
    for (std::size_t n = 0; n < kGustChunk; n += hn::Lanes(d)) {
      Floats a, b, nextA, nextB, aboveA, aboveB, lastA, lastB;
      hn::LoadInterleaved4(d, chunk.low + 4 * n, a, b, nextA, nextB);
      hn::LoadInterleaved4(d, chunk.high + 4 * n, aboveA, aboveB, lastA, lastB);
      const Floats ta = hn::Load(d, chunk.partAlong + n), tb = hn::Load(d, chunk.partAcross + n);
      const auto between = [&](Floats from, Floats to, Floats part)
                               HWY_ATTR { return hn::Add(from, hn::Mul(hn::Sub(to, from), part)); };
      const Floats va = between(between(a, nextA, ta), between(aboveA, lastA, ta), tb);
      const Floats vb = between(between(b, nextB, ta), between(aboveB, lastB, ta), tb);
      const Floats alongX = hn::Sub(hn::Mul(va, cosine), hn::Mul(vb, sine)),
                   alongZ = hn::Add(hn::Mul(va, sine), hn::Mul(vb, cosine));
      hn::Store(hn::Add(hn::Load(d, chunk.sumX + n), hn::Mul(weight, alongX)), d, chunk.sumX + n);
      hn::Store(hn::Add(hn::Load(d, chunk.sumZ + n), hn::Mul(weight, alongZ)), d, chunk.sumZ + n);
    }
  }
}

HWY_ATTR void addGusts(const CpuFields& f, ForceRow row, const GustLayers& layers) {
  const FloatTag d;
  const Floats one = hn::Set(d, 1.0f), amplitude = hn::Set(d, f.gustAmplitude);
  const Floats part = hn::Set(d, 1 - std::exp(-f.dt / WIND_GUST_RESPONSE));
  const Floats fade = hn::Set(d, 1 / (4 * f.gustAmplitude * f.gustAmplitude));
  const float *vx = f.speedX.row(row.k), *vz = f.speedZ.row(row.k);
  GustChunk chunk;
  for (int i = 0, width = f.width(); i < width; i += static_cast<int>(hn::Lanes(d))) {
    const int n = i % kGustChunk;
    if (n == 0) sumGustLayers(f, i, row.k, layers, chunk);
    const Floats meanX = hn::Set(d, f.ambient.x), meanZ = hn::Set(d, f.ambient.y);
    const Floats x = hn::Sub(hn::Add(meanX, hn::Mul(amplitude, hn::Load(d, chunk.sumX + n))), hn::LoadU(d, vx + i));
    const Floats z = hn::Sub(hn::Add(meanZ, hn::Mul(amplitude, hn::Load(d, chunk.sumZ + n))), hn::LoadU(d, vz + i));
    const Floats square = hn::Add(hn::Mul(x, x), hn::Mul(z, z));
    const Floats weight = hn::Div(part, hn::Add(one, hn::Mul(square, fade)));
    hn::StoreU(hn::Add(hn::LoadU(d, row.incrementX + i), hn::Mul(weight, x)), d, row.incrementX + i);
    hn::StoreU(hn::Add(hn::LoadU(d, row.incrementZ + i), hn::Mul(weight, z)), d, row.incrementZ + i);
  }
}

/// Adds gusts and confinement to the increments of rows [begin, end), row k at k * stride from the pointers.
HWY_ATTR void addFieldForces(const CpuFields& f, int begin, int end, const GustLayers& layers, float* incrementX,
                             float* incrementZ, std::ptrdiff_t stride) {
  thread_local std::vector<float> memory;
  const std::ptrdiff_t room = f.speedX.stride();
  memory.assign(static_cast<std::size_t>(room) * 2, 0.0f);
  const auto scratch = [&](int n) { return memory.data() + n * room + CpuPlane::kMargin; };
  const bool confine = f.solver.confinement > 0;
  if (confine) nodeVorticity(f, begin, scratch(begin & 1));
  for (int k = begin; k < end; ++k) {
    const ForceRow row{k, incrementX + k * stride, incrementZ + k * stride};
    if (f.gustAmplitude > 0) addGusts(f, row, layers);
    if (!confine) continue;
    nodeVorticity(f, k + 1, scratch((k + 1) & 1));
    addConfinement(f, row, scratch(k & 1), scratch((k + 1) & 1));
  }
}

/// What isn't finite becomes the ambient wind.
HWY_ATTR void healRow(const CpuFields& f, int k, float* row, int count, float ambient, CpuHealth& health) {
  int bad = 0;
  for (int i = 0; i < count; ++i) bad += std::abs(row[i]) <= kLargestHealthy ? 0 : 1;
  for (int i = 0; i < count && bad > 0; ++i) {
    if (std::abs(row[i]) <= kLargestHealthy) continue;
    row[i] = ambient;
    health.add({1, {std::min(i, f.width() - 1), std::min(k, f.height() - 1)}});
    --bad;
  }
}

HWY_ATTR void addToFacesX(const CpuFields& f, int k, const float* HWY_RESTRICT increment, float* HWY_RESTRICT out,
                          CpuHealth& health) {
  const int w = f.width();
  const float* HWY_RESTRICT u = f.velocity.u.row(k);
  for (int i = 1; i < w; ++i) out[i] = u[i] + 0.5f * (increment[i - 1] + increment[i]);
  const bool periodic = f.grid.periodicX();
  out[0] = u[0] + (periodic ? 0.5f * (increment[w - 1] + increment[0]) : increment[0]);
  out[w] = periodic ? out[0] : u[w] + increment[w - 1];
  healRow(f, k, out, w + 1, f.ambient.x, health);
}

HWY_ATTR void addToFacesZ(const CpuFields& f, int k, const float* low, const float* high, float* HWY_RESTRICT out,
                          CpuHealth& health) {
  const float* HWY_RESTRICT w = f.velocity.w.row(k);
  for (int i = 0, width = f.width(); i < width; ++i) out[i] = w[i] + 0.5f * (low[i] + high[i]);
  healRow(f, k, out, f.width(), f.ambient.y, health);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace windloom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace windloom {
namespace {

HWY_EXPORT(addFieldForces);
HWY_EXPORT(addToFacesX);
HWY_EXPORT(addToFacesZ);

/// Increments of cell rows in a task's own memory; rows count from the task's first.
class IncrementRows {
 public:
  IncrementRows(std::vector<float>& memory, int stride, int rows) : m_stride(stride), m_rows(rows) {
    memory.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows) * 2);
    m_memory = memory.data();
  }
  [[nodiscard]] std::ptrdiff_t stride() const { return m_stride; }
  [[nodiscard]] float* x(int n) const { return m_memory + static_cast<std::ptrdiff_t>(n) * m_stride; }
  [[nodiscard]] float* z(int n) const { return m_memory + static_cast<std::ptrdiff_t>(m_rows + n) * m_stride; }

 private:
  std::ptrdiff_t m_stride;
  int m_rows;
  float* m_memory;
};

/// Each task's increments along z of its first and of its last row of cells.
class Seams {
 public:
  Seams(int stride, int tasks) : m_stride(stride), m_memory(static_cast<std::size_t>(stride * 2 * tasks)) {}
  [[nodiscard]] float* first(int task) { return m_memory.data() + m_stride * 2 * task; }
  [[nodiscard]] float* last(int task) { return first(task) + m_stride; }
  [[nodiscard]] const float* first(int task) const { return m_memory.data() + m_stride * 2 * task; }
  [[nodiscard]] const float* last(int task) const { return first(task) + m_stride; }

 private:
  std::ptrdiff_t m_stride;
  std::vector<float> m_memory;
};

struct ForceJob {
  CpuFields& f;
  std::span<const PreparedArrow> arrows;
  const ArrowTiles& tiles;
  GustLayers layers;

  /// Increments of rows [begin, end), which must lie in one row of tiles.
  void increments(int begin, int end, const IncrementRows& out) const {
    const int side = tiles.cellsPerSide, b = begin / side;
    for (int a = 0; a < tiles.columns; ++a) {
      const auto t = static_cast<std::size_t>(b * tiles.columns + a);
      const auto indices = std::span(tiles.indices).subspan(tiles.start[t], tiles.start[t + 1] - tiles.start[t]);
      arrowIncrements(f, {a * side, std::min(f.width(), (a + 1) * side), begin, end}, arrows, indices,
                      {out.x(0) + a * side, out.z(0) + a * side, out.stride()});
    }
    const std::ptrdiff_t stride = out.stride();
    HWY_DYNAMIC_DISPATCH(addFieldForces)
    (f, begin, end, layers, out.x(0) - begin * stride, out.z(0) - begin * stride, stride);
  }

  /// All faces of rows [begin, end) but the z-faces that another task's cells act on too; those wait in the seams.
  [[nodiscard]] CpuHealth rows(int task, int begin, int end, Seams& seams) const {
    CpuHealth health;
    thread_local std::vector<float> memory;
    const int count = end - begin;
    const IncrementRows own(memory, f.speedX.stride(), count);
    increments(begin, end, own);
    const auto faceZ = [&](int k, int low, int high) {
      HWY_DYNAMIC_DISPATCH(addToFacesZ)(f, k, own.z(low), own.z(high), f.forced.w.row(k), health);
    };
    if (begin == 0 && !f.grid.periodicZ()) faceZ(0, 0, 0);
    for (int n = 0; n < count; ++n) {
      HWY_DYNAMIC_DISPATCH(addToFacesX)(f, begin + n, own.x(n), f.forced.u.row(begin + n), health);
      if (n > 0) faceZ(begin + n, n - 1, n);
    }
    if (end == f.height() && !f.grid.periodicZ()) faceZ(end, count - 1, count - 1);
    std::copy_n(own.z(0), f.width(), seams.first(task));
    std::copy_n(own.z(count - 1), f.width(), seams.last(task));
    return health;
  }

  /// The z-faces between a task's rows and those below.
  [[nodiscard]] CpuHealth seam(int task, int tasks, const Seams& seams) const {
    CpuHealth health;
    if (task == 0 && !f.grid.periodicZ()) return health;
    const int k = task * kRowsPerTask, below = task > 0 ? task - 1 : tasks - 1;
    HWY_DYNAMIC_DISPATCH(addToFacesZ)(f, k, seams.last(below), seams.first(task), f.forced.w.row(k), health);
    return health;
  }
};

}  // namespace

CpuHealth applyForces(CpuFields& f, ThreadPool& pool, std::span<const ArrowForce> arrows, const ArrowTiles& tiles,
                      double time) {
  static_assert(WIND_TILE % kRowsPerTask == 0, "a task's rows lie in one row of tiles");
  thread_local std::vector<PreparedArrow> prepared;
  prepared.clear();
  for (const ArrowForce& arrow : arrows) prepared.emplace_back(arrow);
  const ForceJob job{f, prepared, tiles, gustLayersAt(f.ambientSettings, time)};
  const int tasks = tasksFor(f.height());
  Seams seams(f.speedX.stride(), tasks);
  std::vector<CpuHealth> found(static_cast<std::size_t>(tasks));
  forRows(pool, f.width(), f.height(), [&](int task, int begin, int end) {
    found[static_cast<std::size_t>(task)] = job.rows(task, begin, end, seams);
  });
  CpuHealth health;
  for (int task = 0; task < tasks; ++task) {
    health.add(job.seam(task, tasks, seams));
    health.add(found[static_cast<std::size_t>(task)]);
  }
  if (f.grid.periodicZ()) std::copy_n(f.forced.w.row(0), f.width(), f.forced.w.row(f.height()));
  return health;
}

}  // namespace windloom
#endif
