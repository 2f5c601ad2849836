// Choi & Sung, CWD-Sim, 2024: arrow-guided wind. Deviation: drives approach their speed exponentially instead of adding
// a force without bound. Compiled for several instruction sets, chosen when the program runs (Highway).
#include "engine/wind/cpu_arrows.hpp"

#include <algorithm>
#include <cmath>

#include "shaders/shared/wind_constants.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/wind/cpu_arrows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace windloom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
#include "engine/wind/cpu_math.hpp"

constexpr int kLanes = WIND_TILE;  // cells of a row that are worked on together
using FloatTag = hn::CappedTag<float, kLanes>;
using Floats = hn::Vec<FloatTag>;

/// Sums over the arrows for kLanes cells of a row.
struct RowSums {
  HWY_ALIGN float rate[kLanes], targetX[kLanes], targetZ[kLanes];     // drive speed
  HWY_ALIGN float forceX[kLanes], forceZ[kLanes];                     // drive force
  HWY_ALIGN float swirlRate[kLanes], swirlX[kLanes], swirlZ[kLanes];  // swirl
};

/// The cells of a row: centres (x, z), m, and velocities.
struct RowCells {
  HWY_ALIGN float x[kLanes], vx[kLanes], vz[kLanes];
  float z;
};

/// An arrow with what is the same for all cells.
struct Prepared {
  glm::vec2 from, along, to, direction;
  float inverseSquare;  // of the length; 0 for a disc
  float radiusSquare, doubleInverseRadius, sharpness, rate, strength, swirl, zLow, zHigh;
  bool speedDrive;
  explicit Prepared(const ArrowForce& a)
      : from(a.from),
        along(a.to - a.from),
        to(a.to),
        direction(a.direction),
        radiusSquare(a.radius * a.radius),
        doubleInverseRadius(2 / a.radius),
        sharpness(-2 / (a.radius * a.radius)),
        rate(std::min(std::abs(a.factor), 1.0f) / std::max(a.response, WIND_MIN_RESPONSE)),
        strength(a.strength),
        swirl(a.swirl),
        zLow(std::min(a.from.y, a.to.y) - a.radius),
        zHigh(std::max(a.from.y, a.to.y) + a.radius),
        speedDrive(a.drive == ARROW_DRIVE_SPEED) {
    const float square = glm::dot(along, along);
    inverseSquare = square > 0 ? 1 / square : 0.0f;
  }
};

HWY_ATTR HWY_INLINE void accumulate(FloatTag d, float* sum, Floats value) {
  hn::Store(hn::Add(hn::Load(d, sum), value), d, sum);
}
HWY_ATTR HWY_INLINE Floats dot(FloatTag d, Floats x, Floats z, glm::vec2 v) {
  return hn::Add(hn::Mul(x, hn::Set(d, v.x)), hn::Mul(z, hn::Set(d, v.y)));
}

HWY_ATTR void addDrive(const Prepared& a, const RowCells& cells, RowSums& sums) {
  const FloatTag d;
  const float sign = a.strength >= 0 ? 1.0f : -1.0f;
  const glm::vec2 direction = sign * a.direction;
  const Floats pz = hn::Set(d, cells.z - a.from.y), radiusSquare = hn::Set(d, a.radiusSquare);
  for (std::size_t n = 0; n < kLanes; n += hn::Lanes(d)) {
    const Floats px = hn::Sub(hn::Load(d, cells.x + n), hn::Set(d, a.from.x));
    const Floats part = hn::Mul(dot(d, px, pz, a.along), hn::Set(d, a.inverseSquare));
    const Floats t = hn::Min(hn::Max(part, hn::Zero(d)), hn::Set(d, 1.0f));
    const Floats ex = hn::Sub(px, hn::Mul(t, hn::Set(d, a.along.x))),
                 ez = hn::Sub(pz, hn::Mul(t, hn::Set(d, a.along.y)));
    const Floats d2 = hn::Add(hn::Mul(ex, ex), hn::Mul(ez, ez));
    const auto inside = hn::Lt(d2, radiusSquare);
    if (hn::AllFalse(d, inside)) continue;
    const Floats g =
        hn::IfThenElseZero(inside, expNegative(d, hn::Mul(hn::Min(d2, radiusSquare), hn::Set(d, a.sharpness))));
    if (a.speedDrive) {
      const Floats s = dot(d, hn::Load(d, cells.vx + n), hn::Load(d, cells.vz + n), direction);
      const Floats rate = hn::Mul(g, hn::Set(d, a.rate));
      const Floats pull = hn::Mul(rate, hn::Max(s, hn::Set(d, sign * a.strength)));
      accumulate(d, sums.rate + n, rate);
      accumulate(d, sums.targetX + n, hn::Mul(pull, hn::Set(d, direction.x)));
      accumulate(d, sums.targetZ + n, hn::Mul(pull, hn::Set(d, direction.y)));
    } else {
      accumulate(d, sums.forceX + n, hn::Mul(g, hn::Set(d, a.strength * a.direction.x)));
      accumulate(d, sums.forceZ + n, hn::Mul(g, hn::Set(d, a.strength * a.direction.y)));
    }
  }
}

HWY_ATTR void addSwirl(const Prepared& a, const RowCells& cells, RowSums& sums) {
  const FloatTag d;
  const float sign = a.swirl >= 0 ? 1.0f : -1.0f;
  const Floats ez = hn::Set(d, cells.z - a.to.y), radiusSquare = hn::Set(d, a.radiusSquare);
  for (std::size_t n = 0; n < kLanes; n += hn::Lanes(d)) {
    const Floats ex = hn::Sub(hn::Load(d, cells.x + n), hn::Set(d, a.to.x));
    const Floats d2 = hn::Add(hn::Mul(ex, ex), hn::Mul(ez, ez));
    const auto inside = hn::And(hn::Lt(d2, radiusSquare), hn::Gt(d2, hn::Zero(d)));
    if (hn::AllFalse(d, inside)) continue;
    const Floats safe = hn::IfThenElse(inside, d2, radiusSquare);
    const Floats distance = hn::Sqrt(safe), g = expNegative(d, hn::Mul(safe, hn::Set(d, a.sharpness)));
    const float peak = sign * a.swirl * a.doubleInverseRadius * 1.6487213f;  // exp(1/2): greatest with `swirl`
    const Floats profile = hn::Mul(hn::Mul(distance, g), hn::Set(d, peak));
    const Floats inverse = hn::Div(hn::Set(d, sign), distance);
    const Floats tx = hn::Neg(hn::Mul(ez, inverse)), tz = hn::Mul(ex, inverse);
    const Floats along = hn::Add(hn::Mul(hn::Load(d, cells.vx + n), tx), hn::Mul(hn::Load(d, cells.vz + n), tz));
    const Floats rate = hn::IfThenElseZero(inside, hn::Mul(g, hn::Set(d, a.rate)));
    const Floats m = hn::Mul(rate, hn::Max(hn::Sub(profile, along), hn::Zero(d)));
    accumulate(d, sums.swirlRate + n, rate);
    accumulate(d, sums.swirlX + n, hn::Mul(m, tx));
    accumulate(d, sums.swirlZ + n, hn::Mul(m, tz));
  }
}

/// (1 - exp(-R dt)) / R: the time an exponential approach at rate R takes effect in a step.
HWY_ATTR HWY_INLINE Floats approach(FloatTag d, Floats rate, Floats dt) {
  const Floats turned = hn::Mul(rate, dt), one = hn::Set(d, 1.0f);
  const auto slow = hn::Lt(turned, hn::Set(d, 1e-4f));
  const Floats safe = hn::IfThenElse(slow, one, rate);
  return hn::IfThenElse(slow, dt, hn::Div(hn::Sub(one, expNegative(d, hn::Neg(turned))), safe));
}

HWY_ATTR void finishRow(const RowCells& cells, const RowSums& sums, float step, int count, float* outX, float* outZ) {
  const FloatTag d;
  const Floats dt = hn::Set(d, step);
  HWY_ALIGN float x[kLanes], z[kLanes];
  for (std::size_t n = 0; n < kLanes; n += hn::Lanes(d)) {
    const Floats rate = hn::Load(d, sums.rate + n);
    const Floats pull = approach(d, rate, dt), turn = approach(d, hn::Load(d, sums.swirlRate + n), dt);
    const auto increment = [&](const float* target, const float* own, const float* swirl, const float* force) HWY_ATTR {
      const Floats drawn = hn::Mul(hn::Sub(hn::Load(d, target + n), hn::Mul(rate, hn::Load(d, own + n))), pull);
      return hn::Add(hn::Add(drawn, hn::Mul(hn::Load(d, swirl + n), turn)), hn::Mul(dt, hn::Load(d, force + n)));
    };
    hn::Store(increment(sums.targetX, cells.vx, sums.swirlX, sums.forceX), d, x + n);
    hn::Store(increment(sums.targetZ, cells.vz, sums.swirlZ, sums.forceZ), d, z + n);
  }
  std::copy_n(x, count, outX);
  std::copy_n(z, count, outZ);
}

struct RowStrip {
  int i, k, count;  // cells [i, i + count) of row k, count at most kLanes
};

HWY_ATTR void arrowRow(const CpuFields& f, RowStrip strip, std::span<const Prepared> arrows, float* outX, float* outZ) {
  RowCells cells{};
  const glm::vec2 low = f.grid.mapping.minCorner, size = f.grid.mapping.cellSize;
  cells.z = low.y + (static_cast<float>(strip.k) + 0.5f) * size.y;
  for (int n = 0; n < kLanes; ++n) cells.x[n] = low.x + (static_cast<float>(strip.i + n) + 0.5f) * size.x;
  std::copy_n(f.speedX.row(strip.k) + strip.i, strip.count, cells.vx);
  std::copy_n(f.speedZ.row(strip.k) + strip.i, strip.count, cells.vz);
  RowSums sums{};
  for (const Prepared& a : arrows) {
    if (cells.z <= a.zLow || cells.z >= a.zHigh) continue;
    if (a.strength != 0) addDrive(a, cells, sums);
    if (a.swirl != 0) addSwirl(a, cells, sums);
  }
  finishRow(cells, sums, f.dt, strip.count, outX, outZ);
}

HWY_ATTR void arrowBlock(const CpuFields& f, CellBlock block, std::span<const ArrowForce> arrows,
                         std::span<const std::uint32_t> indices, float* incrementX, float* incrementZ, int stride) {
  thread_local std::vector<Prepared> prepared;
  prepared.clear();
  for (const std::uint32_t n : indices) prepared.emplace_back(arrows[n]);
  for (int k = block.kBegin; k < block.kEnd; ++k) {
    float* outX = incrementX + static_cast<std::ptrdiff_t>(k - block.kBegin) * stride;
    float* outZ = incrementZ + static_cast<std::ptrdiff_t>(k - block.kBegin) * stride;
    for (int i = block.iBegin; i < block.iEnd; i += kLanes) {
      arrowRow(f, {i, k, std::min(kLanes, block.iEnd - i)}, prepared, outX + (i - block.iBegin),
               outZ + (i - block.iBegin));
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace windloom
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace windloom {

HWY_EXPORT(arrowBlock);

void arrowIncrements(const CpuFields& fields, CellBlock block, std::span<const ArrowForce> arrows,
                     std::span<const std::uint32_t> indices, float* incrementX, float* incrementZ, int stride) {
  if (!indices.empty()) {
    HWY_DYNAMIC_DISPATCH(arrowBlock)(fields, block, arrows, indices, incrementX, incrementZ, stride);
    return;
  }
  for (int k = 0; k < block.kEnd - block.kBegin; ++k) {
    std::fill_n(incrementX + static_cast<std::ptrdiff_t>(k) * stride, block.iEnd - block.iBegin, 0.0f);
    std::fill_n(incrementZ + static_cast<std::ptrdiff_t>(k) * stride, block.iEnd - block.iBegin, 0.0f);
  }
}

}  // namespace windloom
#endif
