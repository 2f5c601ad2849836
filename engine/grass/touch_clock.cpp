#include "engine/grass/touch_clock.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {

namespace {

// What a quick run-up leaves out: most of the trail is gone, what is touched now is right.
constexpr double kQuickMemoryS = 1.0, kQuickStepS = 1.0 / 30;

}  // namespace

TouchSteps TouchClock::advance(double time, double stepSeconds, RunUp runUp, double memorySeconds) {
  const double way = m_time ? time - *m_time : -1.0;
  m_time = time;
  TouchSteps steps;
  steps.fromRest = way < 0.0 || way > kLongestTouchGapS || (runUp == RunUp::Full && time < m_quickUntil);
  const bool quick = steps.fromRest && runUp == RunUp::Quick;
  if (steps.fromRest) m_quickUntil = quick ? time + memorySeconds : time;
  const double length = !steps.fromRest ? way : quick ? kQuickMemoryS : memorySeconds;
  if (length <= 0.0) return steps;
  steps.start = time - length;
  steps.count =
      std::max(1, static_cast<int>(std::lround(length / (quick ? kQuickStepS : std::max(stepSeconds, 1e-3)))));
  steps.seconds = static_cast<float>(length / steps.count);
  return steps;
}

}  // namespace windloom
