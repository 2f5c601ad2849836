#include "editor/core/time_axis.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

constexpr double kLeastSeconds = 0.2, kMostSeconds = 7200;
constexpr double kBefore = 0.05;     // of the shown time may lie before 0
constexpr double kShrinkAfterS = 3;  // wall time
constexpr double kSmallPart = 0.4;   // of the top: a scale that is twice as large as needed
constexpr std::size_t kMostTicks = 1000;

TimeAxis kept(TimeAxis axis) {
  axis.seconds = std::clamp(axis.seconds, kLeastSeconds, kMostSeconds);
  axis.from = std::clamp(axis.from, -kBefore * axis.seconds, 1e6);
  return axis;
}

}  // namespace

TimeAxis zoomed(TimeAxis axis, double factor, double fixed) {
  const double part = axis.part(fixed);
  axis.seconds = std::clamp(axis.seconds * factor, kLeastSeconds, kMostSeconds);
  axis.from = fixed - part * axis.seconds;
  return kept(axis);
}

TimeAxis panned(TimeAxis axis, double seconds) {
  axis.from += seconds;
  return kept(axis);
}

TimeAxis framed(double from, double to) {
  const double room = std::max(0.05 * (to - from), 0.02);
  return kept({from - room, to - from + 2 * room});
}

TimeAxis following(TimeAxis axis, double time) {
  if (time > axis.to()) axis.from = time - 0.1 * axis.seconds;
  if (time < axis.from) axis.from = time - 0.1 * axis.seconds;
  return kept(axis);
}

double tickStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(least, 1e-9))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::vector<Tick> ticksBetween(double from, double to, double step) {
  std::vector<Tick> ticks;
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  for (double i = std::ceil(from / step - 1e-9); i * step <= to + 1e-9 * step && ticks.size() < kMostTicks; ++i)
    ticks.push_back({i * step, fixed(i == 0 ? 0.0 : i * step, decimals)});
  return ticks;
}

double SteadyTop::update(double greatest, double seconds) {
  const double wanted = std::max(m_least, greatest * 1.05);
  const auto stepped = [&](double value) {
    const double step = tickStep(value / 5);
    return std::ceil(value / step - 1e-9) * step;
  };
  if (wanted > m_top) m_top = stepped(wanted);
  if (wanted > kSmallPart * m_top || m_top <= m_least) {
    m_smallSince = -1;
  } else if (m_smallSince < 0) {
    m_smallSince = seconds;
  } else if (seconds - m_smallSince > kShrinkAfterS) {
    m_top = std::max(m_least, stepped(wanted));
    m_smallSince = -1;
  }
  return m_top;
}

}  // namespace windloom::editor
