// Harlow & Welch, Numerical calculation of time-dependent viscous incompressible flow, 1965. Deviation: the last
// step's pressure is taken off the velocity first and only its change is solved for, which keeps rounding small.
// Compiled for several instruction sets, chosen when the program runs (Highway).
#include "engine/wind/cpu_projection_rows.hpp"

#include <algorithm>
#include <cmath>

#include "engine/wind/cpu_borders.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/wind/cpu_projection_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace windloom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

#include "engine/wind/cpu_sums.hpp"

HWY_ATTR float greatestOf(const float* values, int count) {
  const hn::ScalableTag<float> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  auto greatest = hn::Zero(d);
  int i = 0;
  for (; i + lanes <= count; i += lanes) greatest = hn::Max(greatest, hn::Abs(hn::LoadU(d, values + i)));
  float result = hn::GetLane(hn::MaxOfLanes(d, greatest));
  for (; i < count; ++i) result = std::max(result, std::abs(values[i]));
  return result;
}

/// Dissipation and speed limit; what isn't finite becomes the ambient wind. Returns how many such there were.
HWY_ATTR int settleRow(const CpuFields& f, const float* HWY_RESTRICT in, int count, float ambient,
                       float* HWY_RESTRICT out) {
  const float keep = 1 / (1 + f.solver.dissipation * f.dt), limit = f.solver.maxSpeed;
  int bad = 0;
  for (int i = 0; i < count; ++i) {
    const float q = ambient + (in[i] - ambient) * keep;
    const bool healthy = std::abs(q) <= kLargestHealthy;
    const float low = q < -limit ? -limit : q;
    const float cut = low > limit ? limit : low;
    out[i] = healthy ? cut : ambient;
    bad += healthy ? 0 : 1;
  }
  return bad;
}

HWY_ATTR void zeroRuns(const CpuRuns& runs, int k, float* row) {
  for (const CpuRun& run : runsOf(runs, k)) std::fill(row + run.begin, row + run.end, 0.0f);
}

/// out = in - scale (high - low), or in where that isn't finite.
HWY_ATTR void takeOff(const float* HWY_RESTRICT in, const float* HWY_RESTRICT low, const float* HWY_RESTRICT high,
                      float scale, int begin, int end, float* HWY_RESTRICT out) {
  for (int i = begin; i < end; ++i) {
    const float value = in[i] - (high[i] - low[i]) * scale;
    out[i] = std::abs(value) <= kLargestHealthy ? value : in[i];
  }
}

HWY_ATTR inline float takenOff(float in, float part) {
  const float value = in - part;
  return std::abs(value) <= kLargestHealthy ? value : in;
}

/// A pressure: `factor` times a plane.
struct Pressed {
  const CpuPlane& plane;
  float factor;
};

/// x-faces of row k: in - gradient of the pressure.
HWY_ATTR void gradientX(const CpuFields& f, Pressed phi, int k, const float* in, float* out) {
  const WindGrid& g = f.grid;
  const float scale = phi.factor / g.hx;
  const float* p = phi.plane.row(k);
  const int last = g.width - 1;
  takeOff(in, p - 1, p, scale, 1, g.width, out);
  const bool periodic = g.periodicX();
  out[0] = takenOff(in[0], periodic ? scale * (p[0] - p[last]) : g.xMin == Border::Open ? 2 * scale * p[0] : 0.0f);
  out[g.width] = periodic ? out[0] : takenOff(in[g.width], g.xMax == Border::Open ? -2 * scale * p[last] : 0.0f);
  zeroRuns(f.blockedX, k, out);
}

/// z-faces of row k in [0, height]: in - gradient of the pressure.
HWY_ATTR void gradientZ(const CpuFields& f, Pressed phi, int k, const float* in, float* out) {
  const WindGrid& g = f.grid;
  const float scale = phi.factor / g.hz;
  if ((k > 0 && k < g.height) || g.periodicZ()) {
    takeOff(in, phi.plane.row(k > 0 ? k - 1 : g.height - 1), phi.plane.row(k < g.height ? k : 0), scale, 0, g.width,
            out);
  } else {
    const Border border = k == 0 ? g.zMin : g.zMax;
    const float outward = border == Border::Open ? (k == 0 ? 2 * scale : -2 * scale) : 0.0f;
    const float* p = phi.plane.row(k == 0 ? 0 : g.height - 1);
    for (int i = 0; i < g.width; ++i) out[i] = takenOff(in[i], outward * p[i]);
  }
  zeroRuns(f.blockedZ, k, out);
}

HWY_ATTR void fluxRow(const WindGrid& g, const float* HWY_RESTRICT u, const float* HWY_RESTRICT low,
                      const float* HWY_RESTRICT high, float* HWY_RESTRICT out) {
  const float hx = g.hx, hz = g.hz;
  for (int i = 0, width = g.width; i < width; ++i) out[i] = (u[i + 1] - u[i]) * hz + (high[i] - low[i]) * hx;
}

HWY_ATTR void meanRow(const float* HWY_RESTRICT a, const float* HWY_RESTRICT b, int count, float* HWY_RESTRICT out) {
  for (int i = 0; i < count; ++i) out[i] = 0.5f * (a[i] + b[i]);
}

/// Rows in a task's own memory.
class Scratch {
 public:
  Scratch(int stride, int rows) : m_stride(stride) {
    thread_local std::vector<float> memory;
    memory.resize(static_cast<std::size_t>(stride) * static_cast<std::size_t>(rows));
    m_memory = memory.data() + CpuPlane::kMargin;
  }
  [[nodiscard]] float* row(int n) const { return m_memory + static_cast<std::ptrdiff_t>(n) * m_stride; }

 private:
  std::ptrdiff_t m_stride;
  float* m_memory;
};

/// Notes how many faces of a row weren't finite, and the first of them.
void noteNonFinite(const CpuFields& f, const float* in, int count, int k, int bad, CpuHealth& health) {
  int i = 0;
  while (i < count - 1 && std::abs(in[i]) <= kLargestHealthy) ++i;
  health.add({bad, {std::min(i, f.width() - 1), std::min(k, f.height() - 1)}});
}

HWY_ATTR void settleRowX(const CpuFields& f, int k, float* out, RowFindings& findings) {
  const float* in = f.moved.u.row(k);
  const int bad = settleRow(f, in, f.width() + 1, f.ambient.x, out);
  if (bad > 0) noteNonFinite(f, in, f.width() + 1, k, bad, findings.health);
  if (f.grid.periodicX()) out[f.width()] = out[0];
  zeroRuns(f.blockedX, k, out);
}

/// `counts`: whether the row is this task's own, not the first of the next one's.
HWY_ATTR void settleRowZ(const CpuFields& f, int k, bool counts, float* out, RowFindings& findings) {
  const float* in = f.moved.w.row(k == f.height() && f.grid.periodicZ() ? 0 : k);
  const int bad = settleRow(f, in, f.width(), f.ambient.y, out);
  if (bad > 0 && counts) noteNonFinite(f, in, f.width(), k, bad, findings.health);
  zeroRuns(f.blockedZ, k, out);
}

HWY_ATTR RowFindings predictTask(CpuFields& f, CpuPlane& flux, int begin, int end) {
  RowFindings findings;
  const Scratch scratch(f.moved.u.stride(), 6);
  float *u = scratch.row(0), *came = scratch.row(1);
  const int width = f.width(), height = f.height();
  const Pressed expected{f.expected, 1};
  const auto settled = [&](int k) { return scratch.row(2 + (k & 1)); };
  const auto predicted = [&](int k) { return scratch.row(4 + (k & 1)); };
  settleRowZ(f, begin, true, settled(begin), findings);
  gradientZ(f, expected, begin, settled(begin), predicted(begin));
  for (int k = begin; k < end; ++k) {
    settleRowX(f, k, u, findings);
    settleRowZ(f, k + 1, k + 1 < end || k + 1 == height, settled(k + 1), findings);
    fluxRow(f.grid, u, settled(k), settled(k + 1), came);
    findings.fluxSquares += productOf(came, came, width);
    findings.greatestFlux = std::max(findings.greatestFlux, static_cast<double>(greatestOf(came, width)));
    findings.speedSquares += productOf(u, u, width) + productOf(settled(k), settled(k), width);
    gradientX(f, expected, k, u, f.velocity.u.row(k));
    gradientZ(f, expected, k + 1, settled(k + 1), predicted(k + 1));
    fluxRow(f.grid, f.velocity.u.row(k), predicted(k), predicted(k + 1), flux.row(k));
    findings.predictedSquares += productOf(flux.row(k), flux.row(k), width);
    std::copy_n(predicted(k), width, f.velocity.w.row(k));
  }
  if (end == height) std::copy_n(predicted(end), width, f.velocity.w.row(end));
  return findings;
}

/// phi = expected + d; what the next step may expect: as much more again as it was more than the last one.
HWY_ATTR void addPressure(const float* HWY_RESTRICT d, float factor, int count, bool hasLast,
                          float* HWY_RESTRICT expected, float* HWY_RESTRICT phi) {
  for (int i = 0; i < count; ++i) {
    const float sum = expected[i] + factor * d[i];
    const float now = std::abs(sum) <= kLargestHealthy ? sum : 0.0f;
    expected[i] = hasLast ? 2 * now - phi[i] : now;
    phi[i] = now;
  }
}

HWY_ATTR RowFindings finishTask(CpuFields& f, const CpuPlane& plane, float factor, int begin, int end) {
  const Pressed correction{plane, factor};
  RowFindings findings;
  const Scratch scratch(f.moved.u.stride(), 3);
  float* flux = scratch.row(0);
  const int width = f.width();
  const auto w = [&](int k) { return scratch.row(1 + (k & 1)); };
  gradientZ(f, correction, begin, f.velocity.w.row(begin), w(begin));
  for (int k = begin; k < end; ++k) {
    float* u = f.moved.u.row(k);
    gradientX(f, correction, k, f.velocity.u.row(k), u);
    gradientZ(f, correction, k + 1, f.velocity.w.row(k + 1), w(k + 1));
    std::copy_n(w(k), width, f.moved.w.row(k));
    addPressure(plane.row(k), factor, width, f.hasPhi, f.expected.row(k), f.phi.row(k));
    fluxRow(f.grid, u, w(k), w(k + 1), flux);
    findings.fluxSquares += productOf(flux, flux, width);
    findings.greatestFlux = std::max(findings.greatestFlux, static_cast<double>(greatestOf(flux, width)));
    float *x = f.speedX.row(k), *z = f.speedZ.row(k);
    meanRow(u, u + 1, width, x);
    meanRow(w(k), w(k + 1), width, z);
    findings.cellSquares += productOf(x, x, width) + productOf(z, z, width);
    findings.greatestCellX = std::max(findings.greatestCellX, greatestOf(x, width));
    findings.greatestCellZ = std::max(findings.greatestCellZ, greatestOf(z, width));
    for (int i = 0; i < width; ++i) flux[i] = x[i] * x[i] + z[i] * z[i];
    findings.greatestCellSquare = std::max(findings.greatestCellSquare, greatestOf(flux, width));
  }
  if (end == f.height()) std::copy_n(w(end), width, f.moved.w.row(end));
  return findings;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace windloom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace windloom {

HWY_EXPORT(predictTask);
HWY_EXPORT(finishTask);

RowFindings predictRowsOf(CpuFields& fields, CpuPlane& flux, int begin, int end) {
  return HWY_DYNAMIC_DISPATCH(predictTask)(fields, flux, begin, end);
}

RowFindings finishRowsOf(CpuFields& fields, const CpuPlane& correction, float factor, int begin, int end) {
  return HWY_DYNAMIC_DISPATCH(finishTask)(fields, correction, factor, begin, end);
}

}  // namespace windloom
#endif
