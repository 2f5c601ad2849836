#include "engine/render/touch_clock.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {

TouchSteps TouchClock::advance(double time, double stepSeconds) {
  const double way = m_time ? time - *m_time : -1.0;
  m_time = time;
  TouchSteps steps;
  steps.fromRest = way < 0.0 || way > kLongestTouchGapS;
  const double length = steps.fromRest ? kTouchMemoryS : way;
  const double wanted = steps.fromRest ? kTouchRunUpStepS : std::max(stepSeconds, 1e-3);
  if (length <= 0.0) return steps;
  steps.start = time - length;
  steps.count = std::max(1, static_cast<int>(std::lround(length / wanted)));
  steps.seconds = static_cast<float>(length / steps.count);
  return steps;
}

}  // namespace windloom
