// Smooth keys: Fritsch and Butland, "A Method for Constructing Local Monotone Piecewise Cubic Interpolants" 1984:
// the slope at a key is a weighted harmonic mean of those of the two chords beside it, and 0 at an extremum, so that
// the curve never leaves the values of its keys. Deviation: beside a straight line the slope is the line's, as far as
// the curve stays monotone (at most 3 times its own chord), so that there is no kink; beside a held value it is 0.
#include "engine/model/signal_curve.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

/// A key of any round of the curve.
struct Knot {
  double time, value;
  Easing easing;
};

/// The keys, and those of the rounds before and after where the curve loops.
class Knots {
 public:
  Knots(const Signal& signal, double period) : m_keys(signal.keys), m_period(period) {}

  [[nodiscard]] bool has(std::ptrdiff_t i) const { return m_period > 0 || (i >= 0 && i < count()); }
  [[nodiscard]] Knot at(std::ptrdiff_t i) const {
    const std::ptrdiff_t round = i >= 0 ? i / count() : (i + 1) / count() - 1;
    const SignalKey& key = m_keys[static_cast<std::size_t>(i - round * count())];
    return {static_cast<double>(key.time) + static_cast<double>(round) * m_period, static_cast<double>(key.value),
            key.easing};
  }

 private:
  [[nodiscard]] std::ptrdiff_t count() const { return static_cast<std::ptrdiff_t>(m_keys.size()); }
  const std::vector<SignalKey>& m_keys;
  double m_period;
};

double chord(const Knot& a, const Knot& b) {
  return b.time > a.time ? (b.value - a.value) / (b.time - a.time) : 0.0;
}

/// Slope of a smooth course where it meets the neighbouring one: `own` and `other` are the chords' slopes and lengths.
double slopeAt(double own, double ownLength, double other, double otherLength, Easing otherEasing) {
  if (otherEasing == Easing::Hold || own * other <= 0) return 0;
  if (otherEasing == Easing::Linear) return std::copysign(std::min(std::abs(other), 3 * std::abs(own)), own);
  const double weightOwn = 2 * otherLength + ownLength, weightOther = 2 * ownLength + otherLength;
  return (weightOwn + weightOther) / (weightOwn / own + weightOther / other);
}

/// The course `step` knots on from knot `i`, whose own chord has this slope and length. Keys at 0 and at the period
/// are one knot: the next course lies behind them.
double slopeBeside(const Knots& knots, std::ptrdiff_t i, std::ptrdiff_t step, double own, double ownLength) {
  if (!knots.has(i + step)) return 0;
  if (knots.at(i + step).time == knots.at(i).time) i += step;
  if (!knots.has(i + step)) return 0;
  const Knot first = knots.at(std::min(i, i + step)), second = knots.at(std::max(i, i + step));
  return slopeAt(own, ownLength, chord(first, second), second.time - first.time, first.easing);
}

double smoothBetween(const Knots& knots, std::ptrdiff_t i, double t) {
  const Knot a = knots.at(i), b = knots.at(i + 1);
  const double length = b.time - a.time, own = chord(a, b);
  const double slopeA = slopeBeside(knots, i, -1, own, length), slopeB = slopeBeside(knots, i + 1, 1, own, length);
  const double x = (t - a.time) / length, y = 1 - x;
  const double value =
      a.value * (1 + 2 * x) * y * y + b.value * (3 - 2 * x) * x * x + length * x * y * (slopeA * y - slopeB * x);
  return std::clamp(value, std::min(a.value, b.value), std::max(a.value, b.value));  // rounding
}

double between(const Knots& knots, std::ptrdiff_t i, double t) {
  const Knot a = knots.at(i), b = knots.at(i + 1);
  if (b.time <= a.time) return b.value;
  switch (a.easing) {
    case Easing::Linear:
      break;
    case Easing::Smooth:
      return smoothBetween(knots, i, t);
    case Easing::Hold:
      return a.value;
  }
  return std::lerp(a.value, b.value, (t - a.time) / (b.time - a.time));
}

}  // namespace

double curvePeriod(const Signal& signal) {
  if (!signal.loop || signal.keys.empty()) return 0;
  return std::max<double>(signal.period, signal.keys.back().time);
}

double curveAt(const Signal& signal, double t) {
  const std::vector<SignalKey>& keys = signal.keys;
  if (keys.empty()) return 1;
  const double period = curvePeriod(signal);
  if (period > 0) t -= std::floor(t / period) * period;
  const auto timeOf = [](const SignalKey& key) { return static_cast<double>(key.time); };
  const auto after = std::ranges::upper_bound(keys, t, {}, timeOf);
  const Knots knots(signal, period);
  const std::ptrdiff_t before = after - keys.begin() - 1;
  if (!knots.has(before)) return static_cast<double>(keys.front().value);
  if (!knots.has(before + 1)) return static_cast<double>(keys.back().value);
  return between(knots, before, t);
}

}  // namespace windloom
