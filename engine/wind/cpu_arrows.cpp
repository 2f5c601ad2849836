// Choi & Sung, CWD-Sim, 2024: arrow-guided wind. Deviation: drives approach their speed exponentially instead of adding
// a force without bound. Compiled for several instruction sets, chosen when the program runs (Highway).
#include "engine/wind/cpu_arrows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "shaders/shared/wind_constants.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/wind/cpu_arrows.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace windloom {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
#include "engine/wind/cpu_math.hpp"

constexpr int kSide = WIND_TILE;  // cells of a strip along x, and the most along z
using FloatTag = hn::CappedTag<float, kSide>;
using Floats = hn::Vec<FloatTag>;

/// Sums over the arrows for the cells of a strip, row by row.
struct StripSums {
  using Plane = float[kSide][kSide];
  HWY_ALIGN Plane rate, targetX, targetZ;     // drive speed
  HWY_ALIGN Plane forceX, forceZ;             // drive force
  HWY_ALIGN Plane swirlRate, swirlX, swirlZ;  // swirl
};

/// kSide cells along x, `rows` along z.
struct Strip {
  glm::vec2 low, cell;  // m: centre of the first cell, size of a cell
  float rowsPerMetre;
  int rows;
  HWY_ALIGN float speedX[kSide][kSide], speedZ[kSide][kSide];  // 0 beyond the last row
};

// Rows worked on together: one row's chain of results would leave the processor waiting. With 32 registers 8 took 0.9
// of the time that 4 took, and 4 took 0.85 of that of 2.
constexpr int kGroup = HWY_TARGET <= HWY_AVX3 ? 8 : 4;
static_assert(kSide % kGroup == 0);
using Group = std::array<Floats, kGroup>;

/// What an arrow is to the rows of a strip: the groups it may reach, and places in radii from its start or end.
struct RowReach {
  int first, last;                        // rows [first, last)
  HWY_ALIGN float z[kSide], part[kSide];  // radii; what z adds to the part of the way

  HWY_ATTR RowReach(const PreparedArrow& a, const Strip& strip, float originZ) {
    const FloatTag d;
    const auto row = [&](float reached) {
      const float place = (reached - strip.low.y) * strip.rowsPerMetre;
      return static_cast<int>(std::min(std::max(place, -2.0f), kSide + 2.0f));
    };
    first = std::max(0, row(a.zLow) - 1) / kGroup * kGroup;
    last = std::min(strip.rows, row(a.zHigh) + 2);
    const Floats scale = hn::Set(d, strip.cell.y * a.inverseRadius);
    const Floats start = hn::Set(d, (strip.low.y - originZ) * a.inverseRadius);
    const Floats partPerZ = hn::Set(d, a.partPer.y);
    for (std::size_t n = 0; n < kSide; n += hn::Lanes(d)) {
      const Floats place = hn::Add(hn::Mul(hn::Iota(d, static_cast<float>(n)), scale), start);
      hn::Store(place, d, z + n);
      hn::Store(hn::Mul(place, partPerZ), d, part + n);
    }
  }
};

/// The x of cells from n in radii from `originX`.
HWY_ATTR HWY_INLINE Floats placesX(const PreparedArrow& a, const Strip& strip, float originX, std::size_t n) {
  const FloatTag d;
  return hn::Add(hn::Mul(hn::Iota(d, static_cast<float>(n)), hn::Set(d, strip.cell.x * a.inverseRadius)),
                 hn::Set(d, (strip.low.x - originX) * a.inverseRadius));
}

/// Coefficients of a polynomial whose eighth power is scale exp(-2 q), q = (distance / radius)^2 in [0, 1]: a minimax
/// fit to exp(-q / 4), 3e-7 off in that power, at a third of the work of an exponential for any argument.
struct Falloff {
  Floats c0, c1, c2, c3, c4;
  HWY_ATTR explicit Falloff(float eighthRoot)
      : c0(coefficient(eighthRoot)),
        c1(coefficient(-0.24999924f * eighthRoot)),
        c2(coefficient(0.0312439986f * eighthRoot)),
        c3(coefficient(-0.00258749537f * eighthRoot)),
        c4(coefficient(0.000143542071f * eighthRoot)) {}
  [[nodiscard]] HWY_ATTR HWY_INLINE Group at(const Group& q) const {
    Group p;
    for (int r = 0; r < kGroup; ++r) p[r] = hn::Add(hn::Mul(c4, q[r]), c3);
    for (int r = 0; r < kGroup; ++r) p[r] = hn::Add(hn::Mul(p[r], q[r]), c2);
    for (int r = 0; r < kGroup; ++r) p[r] = hn::Add(hn::Mul(p[r], q[r]), c1);
    for (int r = 0; r < kGroup; ++r) p[r] = hn::Add(hn::Mul(p[r], q[r]), c0);
    for (int r = 0; r < kGroup; ++r) p[r] = hn::Mul(p[r], p[r]);
    for (int r = 0; r < kGroup; ++r) p[r] = hn::Mul(p[r], p[r]);
    for (int r = 0; r < kGroup; ++r) p[r] = hn::Mul(p[r], p[r]);
    return p;
  }

 private:
  static HWY_ATTR HWY_INLINE Floats coefficient(float value) { return hn::Set(FloatTag(), value); }
};

HWY_ATTR HWY_INLINE void accumulate(FloatTag d, float* sum, Floats value) {
  hn::Store(hn::Add(hn::Load(d, sum), value), d, sum);
}

/// Calls body(row, offset in rows of sums, n, falloff) for the cells of the strip around the arrow's capsule.
template <class Body>
HWY_ATTR HWY_INLINE void eachReached(const PreparedArrow& a, const Strip& strip, float eighthRoot, const Body& body) {
  const FloatTag d;
  const RowReach reach(a, strip, a.from.y);
  const Falloff falloff(eighthRoot);
  const Floats alongX = hn::Set(d, a.along.x), alongZ = hn::Set(d, a.along.y), zero = hn::Zero(d), one = hn::Set(d, 1);
  for (std::size_t n = 0; n < kSide; n += hn::Lanes(d)) {
    const Floats px = placesX(a, strip, a.from.x, n), partX = hn::Mul(px, hn::Set(d, a.partPer.x));
    for (int row = reach.first; row < reach.last; row += kGroup) {
      Group q;
      for (int r = 0; r < kGroup; ++r) {
        const Floats pz = hn::Set(d, reach.z[row + r]);
        const Floats part = hn::Min(hn::Max(hn::Add(partX, hn::Set(d, reach.part[row + r])), zero), one);
        const Floats ex = hn::Sub(px, hn::Mul(part, alongX)), ez = hn::Sub(pz, hn::Mul(part, alongZ));
        q[r] = hn::Add(hn::Mul(ex, ex), hn::Mul(ez, ez));
      }
      const Group g = falloff.at(q);
      for (int r = 0; r < kGroup; ++r) body(row + r, n, hn::IfThenElseZero(hn::Lt(q[r], one), g[r]));
    }
  }
}

HWY_ATTR void addSpeedDrive(const PreparedArrow& a, const Strip& strip, StripSums& sums) {
  const FloatTag d;
  const Floats x = hn::Set(d, a.direction.x), z = hn::Set(d, a.direction.y), wanted = hn::Set(d, std::abs(a.strength));
  eachReached(a, strip, a.rateRoot, [&](int row, std::size_t n, Floats rate) HWY_ATTR {
    const Floats own =
        hn::Add(hn::Mul(hn::Load(d, strip.speedX[row] + n), x), hn::Mul(hn::Load(d, strip.speedZ[row] + n), z));
    const Floats pull = hn::Mul(rate, hn::Max(own, wanted));
    accumulate(d, sums.rate[row] + n, rate);
    accumulate(d, sums.targetX[row] + n, hn::Mul(pull, x));
    accumulate(d, sums.targetZ[row] + n, hn::Mul(pull, z));
  });
}

HWY_ATTR void addForceDrive(const PreparedArrow& a, const Strip& strip, StripSums& sums) {
  const FloatTag d;
  const float strength = std::abs(a.strength);
  const Floats x = hn::Set(d, strength * a.direction.x), z = hn::Set(d, strength * a.direction.y);
  eachReached(a, strip, 1.0f, [&](int row, std::size_t n, Floats g) HWY_ATTR {
    accumulate(d, sums.forceX[row] + n, hn::Mul(g, x));
    accumulate(d, sums.forceZ[row] + n, hn::Mul(g, z));
  });
}

HWY_ATTR void addSwirl(const PreparedArrow& a, const Strip& strip, StripSums& sums) {
  const FloatTag d;
  const RowReach reach(a, strip, a.to.y);
  const Falloff falloff(1.0f);
  const Floats sign = hn::Set(d, a.swirl >= 0 ? 1.0f : -1.0f), zero = hn::Zero(d), one = hn::Set(d, 1);
  const Floats peak = hn::Set(d, std::abs(a.swirl) * 2 * 1.6487213f);  // exp(1/2): greatest with `swirl`
  const Floats greatest = hn::Set(d, a.rate);
  for (std::size_t n = 0; n < kSide; n += hn::Lanes(d)) {
    const Floats ex = placesX(a, strip, a.to.x, n);
    for (int row = reach.first; row < reach.last; row += kGroup) {
      Group q;
      for (int r = 0; r < kGroup; ++r) {
        const Floats ez = hn::Set(d, reach.z[row + r]);
        q[r] = hn::Add(hn::Mul(ex, ex), hn::Mul(ez, ez));
      }
      const Group falling = falloff.at(q);
      for (int r = 0; r < kGroup; ++r) {
        const auto inside = hn::And(hn::Lt(q[r], one), hn::Gt(q[r], zero));
        const Floats distance = hn::Sqrt(hn::IfThenElse(inside, q[r], one)), g = hn::IfThenElseZero(inside, falling[r]);
        const Floats inverse = hn::Div(sign, distance);
        const Floats tx = hn::Neg(hn::Mul(hn::Set(d, reach.z[row + r]), inverse)), tz = hn::Mul(ex, inverse);
        const Floats own = hn::Add(hn::Mul(hn::Load(d, strip.speedX[row + r] + n), tx),
                                   hn::Mul(hn::Load(d, strip.speedZ[row + r] + n), tz));
        const Floats lacking = hn::Max(hn::Sub(hn::Mul(hn::Mul(distance, g), peak), own), zero);
        const Floats rate = hn::Mul(g, greatest), pull = hn::Mul(rate, lacking);
        accumulate(d, sums.swirlRate[row + r] + n, rate);
        accumulate(d, sums.swirlX[row + r] + n, hn::Mul(pull, tx));
        accumulate(d, sums.swirlZ[row + r] + n, hn::Mul(pull, tz));
      }
    }
  }
}

/// (1 - exp(-R dt)) / R: the time an exponential approach at rate R takes effect in a step.
HWY_ATTR HWY_INLINE Floats approach(FloatTag d, Floats rate, Floats dt) {
  const Floats turned = hn::Mul(rate, dt), one = hn::Set(d, 1.0f);
  const auto slow = hn::Lt(turned, hn::Set(d, 1e-4f));
  const Floats safe = hn::IfThenElse(slow, one, rate);
  return hn::IfThenElse(slow, dt, hn::Div(hn::Sub(one, expNegative(d, hn::Neg(turned))), safe));
}

HWY_ATTR void finishRow(const Strip& strip, const StripSums& sums, int row, float step, float* outX, float* outZ) {
  const FloatTag d;
  const Floats dt = hn::Set(d, step);
  for (std::size_t n = 0; n < kSide; n += hn::Lanes(d)) {
    const Floats rate = hn::Load(d, sums.rate[row] + n);
    const Floats pull = approach(d, rate, dt), turn = approach(d, hn::Load(d, sums.swirlRate[row] + n), dt);
    const auto increment = [&](const StripSums::Plane& target, const StripSums::Plane& own,
                               const StripSums::Plane& swirl, const StripSums::Plane& force) HWY_ATTR {
      const Floats speed = hn::Load(d, own[row] + n);
      const Floats drawn = hn::Mul(hn::Sub(hn::Load(d, target[row] + n), hn::Mul(rate, speed)), pull);
      return hn::Add(hn::Add(drawn, hn::Mul(hn::Load(d, swirl[row] + n), turn)),
                     hn::Mul(dt, hn::Load(d, force[row] + n)));
    };
    hn::StoreU(increment(sums.targetX, strip.speedX, sums.swirlX, sums.forceX), d, outX + n);
    hn::StoreU(increment(sums.targetZ, strip.speedZ, sums.swirlZ, sums.forceZ), d, outZ + n);
  }
}

HWY_ATTR void arrowStrip(const Strip& strip, float dt, std::span<const PreparedArrow> arrows,
                         std::span<const std::uint32_t> indices, CellIncrements out) {
  constexpr std::size_t kAhead = 2;  // arrows of a tile lie anywhere in memory
  StripSums sums{};
  for (std::size_t n = 0; n < indices.size(); ++n) {
    if (n + kAhead < indices.size()) hwy::Prefetch(&arrows[indices[n + kAhead]]);
    const PreparedArrow& a = arrows[indices[n]];
    if (a.strength != 0) {
      if (a.speedDrive) {
        addSpeedDrive(a, strip, sums);
      } else {
        addForceDrive(a, strip, sums);
      }
    }
    if (a.swirl != 0) addSwirl(a, strip, sums);
  }
  for (int row = 0; row < strip.rows; ++row)
    finishRow(strip, sums, row, dt, out.x + row * out.stride, out.z + row * out.stride);
}

HWY_ATTR void arrowBlock(const CpuFields& f, CellBlock block, std::span<const PreparedArrow> arrows,
                         std::span<const std::uint32_t> indices, CellIncrements out) {
  const glm::vec2 low = f.grid.mapping.minCorner, size = f.grid.mapping.cellSize;
  for (int k = block.kBegin; k < block.kEnd; k += kSide) {
    for (int i = block.iBegin; i < block.iEnd; i += kSide) {
      Strip strip{low + (glm::vec2(i, k) + 0.5f) * size, size, 1 / size.y, std::min(kSide, block.kEnd - k), {}, {}};
      for (int row = 0; row < strip.rows; ++row) {
        std::copy_n(f.speedX.row(k + row) + i, kSide, strip.speedX[row]);
        std::copy_n(f.speedZ.row(k + row) + i, kSide, strip.speedZ[row]);
      }
      const std::ptrdiff_t at = (k - block.kBegin) * out.stride + (i - block.iBegin);
      arrowStrip(strip, f.dt, arrows, indices, {out.x + at, out.z + at, out.stride});
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

PreparedArrow::PreparedArrow(const ArrowForce& a)
    : from(a.from),
      to(a.to),
      along((a.to - a.from) / a.radius),
      partPer(0),
      direction(a.strength >= 0 ? a.direction : -a.direction),
      inverseRadius(1 / a.radius),
      rate(std::min(std::abs(a.factor), 1.0f) / std::max(a.response, WIND_MIN_RESPONSE)),
      rateRoot(std::sqrt(std::sqrt(std::sqrt(rate)))),
      strength(a.strength),
      swirl(a.swirl),
      zLow(std::min(a.from.y, a.to.y) - a.radius),
      zHigh(std::max(a.from.y, a.to.y) + a.radius),
      speedDrive(a.drive == ARROW_DRIVE_SPEED) {
  if (const float square = glm::dot(along, along); square > 0) partPer = along / square;
}

void arrowIncrements(const CpuFields& fields, CellBlock block, std::span<const PreparedArrow> arrows,
                     std::span<const std::uint32_t> indices, CellIncrements out) {
  if (!indices.empty()) {
    HWY_DYNAMIC_DISPATCH(arrowBlock)(fields, block, arrows, indices, out);
    return;
  }
  for (int k = 0; k < block.kEnd - block.kBegin; ++k) {
    std::fill_n(out.x + k * out.stride, block.iEnd - block.iBegin, 0.0f);
    std::fill_n(out.z + k * out.stride, block.iEnd - block.iBegin, 0.0f);
  }
}

}  // namespace windloom
#endif
