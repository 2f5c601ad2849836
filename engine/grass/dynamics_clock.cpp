#include "engine/grass/dynamics_clock.hpp"

namespace windloom {

DynamicsStep DynamicsClock::advance(double time) {
  const double way = m_time ? time - *m_time : -1.0;
  m_time = time;
  if (way < 0.0 || way > kLongestDynamicsStep) return {0.0f, true};
  return {static_cast<float>(way), false};
}

}  // namespace windloom
