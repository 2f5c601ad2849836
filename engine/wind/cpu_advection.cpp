// Stam, Stable Fluids, 1999 (semi-Lagrangian); Selle, Fedkiw, Kim, Liu & Rossignac, An Unconditionally Stable
// MacCormack Method, 2008. Deviation: what is carried already has this step's forces, what carries it has not.
// Compiled for several instruction sets, chosen when the program runs (Highway).
#include "engine/wind/cpu_advection.hpp"

#include <algorithm>

#include "engine/wind/cpu_borders.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/wind/cpu_advection.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef WINDLOOM_WIND_CPU_ADVECTION_ONCE
#define WINDLOOM_WIND_CPU_ADVECTION_ONCE
namespace windloom {

/// Where positions may go along one axis, in cells.
struct AdvectionAxis {
  bool periodic;
  float length;
  float low, high;  // bounds for carried values: the field, one cell wider at open borders
  bool openLow, openHigh;
};

/// One component of the advection: faces at array entry (i, k) + offset.
struct AdvectionJob {
  const CpuVelocity* velocity;
  AdvectionAxis x, z;
  float perX, perZ;  // m/s to cells a step
  bool xFaces;
  bool correctable;         // MacCormack: lowest and highest are wanted
  const CpuPlane* carried;  // q
  CpuPlane* predicted;      // q'
  CpuPlane* lowest;         // of the four entries around x', both q' where nothing is to be corrected
  CpuPlane* highest;
  CpuPlane* corrected;  // q*
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
using Mask = hn::Mask<FloatTag>;

struct Place {
  Floats x, z;  // cells
};

struct Corners {
  Floats a, b, c, d, tx, tz;
  [[nodiscard]] HWY_ATTR Floats value() const {
    const Floats low = hn::Add(a, hn::Mul(hn::Sub(b, a), tx)), high = hn::Add(c, hn::Mul(hn::Sub(d, c), tx));
    return hn::Add(low, hn::Mul(hn::Sub(high, low), tz));
  }
};

/// The four entries around each place, one by one: any cells anywhere.
HWY_ATTR Corners gatherCorners(const float* base, int stride, hn::Vec<IntTag> xCell, hn::Vec<IntTag> zCell) {
  const FloatTag d;
  const IntTag di;
  const auto index = hn::Add(hn::Mul(zCell, hn::Set(di, stride)), xCell);
  const float* above = base + stride;
  return {hn::GatherIndex(d, base, index),
          hn::GatherIndex(d, base + 1, index),
          hn::GatherIndex(d, above, index),
          hn::GatherIndex(d, above + 1, index),
          hn::Zero(d),
          hn::Zero(d)};
}

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// Two vectors of a row in a line, read at places 0 to 2 N - 1.
struct RowWindow {
  Floats first, second;
  HWY_ATTR HWY_INLINE explicit RowWindow(const float* at)
      : first(hn::LoadU(FloatTag(), at)), second(hn::LoadU(FloatTag(), at + hn::Lanes(FloatTag()))) {}
  [[nodiscard]] HWY_ATTR HWY_INLINE Floats read(hn::Vec<IntTag> place) const {
#if HWY_TARGET == HWY_AVX3
    return Floats{_mm512_permutex2var_ps(first.raw, place.raw, second.raw)};
#else
    const auto low = _mm256_permutevar8x32_ps(first.raw, place.raw),
               high = _mm256_permutevar8x32_ps(second.raw, place.raw);
    return Floats{_mm256_blendv_ps(low, high, _mm256_castsi256_ps(_mm256_slli_epi32(place.raw, 28)))};
#endif
  }
};

/// The same. Neighbouring faces mostly read neighbouring cells: then a few rows are loaded whole and picked from in
/// registers, several times faster than a gather, which costs by the entry.
HWY_ATTR HWY_INLINE Corners cornersOf(const float* base, int stride, hn::Vec<IntTag> xCell, hn::Vec<IntTag> zCell) {
  const FloatTag d;
  const IntTag di;
  constexpr int kWindow = 2 * static_cast<int>(HWY_MAX_BYTES / sizeof(float)), kBack = kWindow / 4;
  const int xFirst = hn::GetLane(xCell) - kBack, zFirst = hn::GetLane(zCell);
  const auto place = hn::Sub(xCell, hn::Set(di, xFirst));
  const auto within =
      hn::And(hn::Eq(hn::And(place, hn::Set(di, kWindow - 1)), place), hn::Lt(place, hn::Set(di, kWindow - 1)));
  const auto next = hn::Add(place, hn::Set(di, 1));
  const float* window = base + static_cast<std::ptrdiff_t>(zFirst) * stride + xFirst;
  if (hn::AllTrue(di, hn::And(within, hn::Eq(zCell, hn::Set(di, zFirst))))) {
    const RowWindow low(window), high(window + stride);
    return {low.read(place), low.read(next), high.read(place), high.read(next), hn::Zero(d), hn::Zero(d)};
  }
  // Four rows from the lowest serve all cells of air that moves less than a cell a step. They reach the plane's last
  // row at most: its last cells alone would be level.
  const int zLowest = hn::GetLane(hn::MinOfLanes(di, zCell));
  const auto row = hn::Sub(zCell, hn::Set(di, zLowest));
  if (!hn::AllTrue(di, hn::And(within, hn::Lt(row, hn::Set(di, 3))))) return gatherCorners(base, stride, xCell, zCell);
  const auto middle = hn::RebindMask(d, hn::Eq(row, hn::Set(di, 1))),
             upper = hn::RebindMask(d, hn::Gt(row, hn::Set(di, 1)));
  const float* lowest = base + static_cast<std::ptrdiff_t>(zLowest) * stride + xFirst;
  const RowWindow r0(lowest), r1(lowest + stride), r2(lowest + 2 * stride), r3(lowest + 3 * stride);
  const auto pick = [&](Floats a, Floats b, Floats c)
                        HWY_ATTR { return hn::IfThenElse(upper, c, hn::IfThenElse(middle, b, a)); };
  const Floats low1 = r1.read(place), low2 = r2.read(place), high1 = r1.read(next), high2 = r2.read(next);
  return {pick(r0.read(place), low1, low2),
          pick(r0.read(next), high1, high2),
          pick(low1, low2, r3.read(place)),
          pick(high1, high2, r3.read(next)),
          hn::Zero(d),
          hn::Zero(d)};
}
#else
HWY_ATTR Corners cornersOf(const float* base, int stride, hn::Vec<IntTag> xCell, hn::Vec<IntTag> zCell) {
  return gatherCorners(base, stride, xCell, zCell);
}
#endif

/// Reads one array at many places: bounds in array entries, so that one clamp does both the field's and the array's.
struct Sampler {
  const float* base;
  int stride;
  Floats xLow, xHigh, zLow, zHigh, xLast, zLast, offsetX, offsetZ, periodX, periodZ;
  bool wrapX, wrapZ;

  HWY_ATTR Sampler(const CpuPlane& plane, const AdvectionAxis& x, const AdvectionAxis& z, float shiftX, float shiftZ,
                   bool carried)
      : base(plane.row(0)), stride(plane.stride()), wrapX(x.periodic), wrapZ(z.periodic) {
    const FloatTag d;
    const auto bounds = [&](const AdvectionAxis& axis, float shift, int count, Floats& low, Floats& high,
                            Floats& last) HWY_ATTR {
      low = hn::Set(d, std::max((carried ? axis.low : 0.0f) - shift, -1.0f));
      high = hn::Set(d, std::min((carried ? axis.high : axis.length) - shift, static_cast<float>(count)));
      last = hn::Set(d, static_cast<float>(count - 1));
    };
    bounds(x, shiftX, plane.width(), xLow, xHigh, xLast);
    bounds(z, shiftZ, plane.height(), zLow, zHigh, zLast);
    offsetX = hn::Set(d, shiftX);
    offsetZ = hn::Set(d, shiftZ);
    periodX = hn::Set(d, x.length);
    periodZ = hn::Set(d, z.length);
  }

  [[nodiscard]] HWY_ATTR Corners at(Place place) const {
    if (wrapX) place.x = hn::Sub(place.x, hn::Mul(periodX, hn::Floor(hn::Div(place.x, periodX))));
    if (wrapZ) place.z = hn::Sub(place.z, hn::Mul(periodZ, hn::Floor(hn::Div(place.z, periodZ))));
    const Floats x = hn::Min(hn::Max(hn::Sub(place.x, offsetX), xLow), xHigh);
    const Floats z = hn::Min(hn::Max(hn::Sub(place.z, offsetZ), zLow), zHigh);
    const Floats xCell = hn::Min(hn::Floor(x), xLast), zCell = hn::Min(hn::Floor(z), zLast);
    const IntTag di;
    Corners corners = cornersOf(base, stride, hn::ConvertTo(di, xCell), hn::ConvertTo(di, zCell));
    corners.tx = hn::Sub(x, xCell);
    corners.tz = hn::Sub(z, zCell);
    return corners;
  }
};

/// Traces the air of one row of faces.
class RowTracer {
 public:
  HWY_ATTR explicit RowTracer(const AdvectionJob& job)
      : m_job(job),
        m_u(job.velocity->u, job.x, job.z, 0.0f, 0.5f, false),
        m_w(job.velocity->w, job.x, job.z, 0.5f, 0.0f, false) {}

  /// Where the air at the faces from (i, k) is after a step forwards (sign 1) or was before one (-1), by the midpoint
  /// rule.
  HWY_ATTR Place trace(int i, int k, float sign) const {
    const FloatTag d;
    const Floats perX = hn::Set(d, m_job.perX * sign), perZ = hn::Set(d, m_job.perZ * sign), half = hn::Set(d, 0.5f);
    const Place start = {hn::Iota(d, static_cast<float>(i) + (m_job.xFaces ? 0.0f : 0.5f)),
                         hn::Set(d, static_cast<float>(k) + (m_job.xFaces ? 0.5f : 0.0f))};
    const CpuPlane &u = m_job.velocity->u, &w = m_job.velocity->w;
    Floats ownX, ownZ;
    if (m_job.xFaces) {
      ownX = hn::LoadU(d, u.row(k) + i);
      ownZ = meanOfFour(w.row(k) + i - 1, w.row(k + 1) + i - 1);
    } else {
      ownX = meanOfFour(u.row(k - 1) + i, u.row(k) + i);
      ownZ = hn::LoadU(d, w.row(k) + i);
    }
    const Place middle = {hn::Add(start.x, hn::Mul(half, hn::Mul(ownX, perX))),
                          hn::Add(start.z, hn::Mul(half, hn::Mul(ownZ, perZ)))};
    return {hn::Add(start.x, hn::Mul(m_u.at(middle).value(), perX)),
            hn::Add(start.z, hn::Mul(m_w.at(middle).value(), perZ))};
  }

  /// Which places lie outside the field behind an open border.
  HWY_ATTR Mask left(Place place) const {
    const FloatTag d;
    const Floats infinity = hn::Set(d, 3e38f);
    const auto bound = [&](bool open, float value) HWY_ATTR { return open ? hn::Set(d, value) : infinity; };
    const Mask x = hn::Or(hn::Gt(hn::Neg(place.x), bound(m_job.x.openLow, 0.0f)),
                          hn::Gt(place.x, bound(m_job.x.openHigh, m_job.x.length)));
    const Mask z = hn::Or(hn::Gt(hn::Neg(place.z), bound(m_job.z.openLow, 0.0f)),
                          hn::Gt(place.z, bound(m_job.z.openHigh, m_job.z.length)));
    return hn::Or(x, z);
  }

 private:
  static HWY_ATTR Floats meanOfFour(const float* low, const float* high) {
    const FloatTag d;
    return hn::Mul(hn::Set(d, 0.25f), hn::Add(hn::Add(hn::LoadU(d, low), hn::LoadU(d, low + 1)),
                                              hn::Add(hn::LoadU(d, high), hn::LoadU(d, high + 1))));
  }
  const AdvectionJob& m_job;
  Sampler m_u, m_w;
};

HWY_ATTR Sampler carriedSampler(const AdvectionJob& job, const CpuPlane& plane) {
  return Sampler(plane, job.x, job.z, job.xFaces ? 0.0f : 0.5f, job.xFaces ? 0.5f : 0.0f, true);
}

HWY_ATTR void predictRows(const AdvectionJob& job, int begin, int end) {
  const FloatTag d;
  const RowTracer tracer(job);
  const Sampler carried = carriedSampler(job, *job.carried);
  for (int k = begin; k < end; ++k) {
    for (int i = 0; i < job.carried->width(); i += static_cast<int>(hn::Lanes(d))) {
      const Place back = tracer.trace(i, k, -1);
      const Corners from = carried.at(back);
      const Floats value = from.value();
      hn::StoreU(value, d, job.predicted->row(k) + i);
      if (!job.correctable) continue;
      const Mask fixed = tracer.left(back);
      const Floats lowest = hn::Min(hn::Min(from.a, from.b), hn::Min(from.c, from.d));
      const Floats highest = hn::Max(hn::Max(from.a, from.b), hn::Max(from.c, from.d));
      hn::StoreU(hn::IfThenElse(fixed, value, lowest), d, job.lowest->row(k) + i);
      hn::StoreU(hn::IfThenElse(fixed, value, highest), d, job.highest->row(k) + i);
    }
  }
}

HWY_ATTR void correctRows(const AdvectionJob& job, int begin, int end) {
  const FloatTag d;
  const RowTracer tracer(job);
  const Sampler predicted = carriedSampler(job, *job.predicted);
  const Floats half = hn::Set(d, 0.5f);
  for (int k = begin; k < end; ++k) {
    for (int i = 0; i < job.carried->width(); i += static_cast<int>(hn::Lanes(d))) {
      const Place forth = tracer.trace(i, k, 1);
      const Floats returned = predicted.at(forth).value();
      const Floats first = hn::LoadU(d, job.predicted->row(k) + i), q = hn::LoadU(d, job.carried->row(k) + i);
      const Floats corrected = hn::Add(first, hn::Mul(half, hn::Sub(q, returned)));
      const Floats limited =
          hn::Min(hn::Max(corrected, hn::LoadU(d, job.lowest->row(k) + i)), hn::LoadU(d, job.highest->row(k) + i));
      hn::StoreU(hn::IfThenElse(tracer.left(forth), first, limited), d, job.corrected->row(k) + i);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace windloom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace windloom {
namespace {

HWY_EXPORT(predictRows);
HWY_EXPORT(correctRows);

AdvectionAxis axisOf(int cells, Border low, Border high) {
  const float length = static_cast<float>(cells);
  const bool openLow = low == Border::Open, openHigh = high == Border::Open;
  return {low == Border::Periodic, length, openLow ? -1.0f : 0.0f, openHigh ? length + 1 : length, openLow, openHigh};
}

AdvectionJob jobOf(CpuFields& f, bool xFaces) {
  AdvectionJob job{};
  job.velocity = &f.velocity;
  job.x = axisOf(f.width(), f.grid.xMin, f.grid.xMax);
  job.z = axisOf(f.height(), f.grid.zMin, f.grid.zMax);
  job.perX = f.dt / f.grid.hx;
  job.perZ = f.dt / f.grid.hz;
  job.xFaces = xFaces;
  job.correctable = f.solver.advection == Advection::MacCormack;
  const auto part = [&](CpuVelocity& field) { return xFaces ? &field.u : &field.w; };
  job.carried = part(f.forced);
  job.predicted = part(f.moved);
  job.lowest = part(f.lowest);
  job.highest = part(f.highest);
  job.corrected = part(f.corrected);
  return job;
}

}  // namespace

void advect(CpuFields& f, ThreadPool& pool) {
  const AdvectionJob onX = jobOf(f, true), onZ = jobOf(f, false);
  forRows(pool, f.width(), f.height() + 1, [&](int, int begin, int end) {
    HWY_DYNAMIC_DISPATCH(predictRows)(onX, begin, std::min(end, f.height()));
    HWY_DYNAMIC_DISPATCH(predictRows)(onZ, begin, end);
  });
  if (!onX.correctable) return;
  fillGhosts(f, f.moved, OpenGhost::Ambient);
  forRows(pool, f.width(), f.height() + 1, [&](int, int begin, int end) {
    HWY_DYNAMIC_DISPATCH(correctRows)(onX, begin, std::min(end, f.height()));
    HWY_DYNAMIC_DISPATCH(correctRows)(onZ, begin, end);
  });
  std::swap(f.moved, f.corrected);
}

}  // namespace windloom
#endif
