#pragma once
// Turns the simulated time of frames into steps of grass that remembers.

#include <optional>

namespace windloom {

struct DynamicsStep {
  float seconds = 0.0f;  ///< 0: time stands still
  bool jumped = false;   ///< what is remembered belongs to another time: begin at rest
};

/// Longest way that grass swings on through, s; longer ones are jumps.
inline constexpr double kLongestDynamicsStep = 0.5;

class DynamicsClock {
 public:
  /// The way from the last call to `time` (s). The first call, a way back and a long way ahead are jumps.
  DynamicsStep advance(double time);
  /// The next call is a jump.
  void forget() { m_time.reset(); }

 private:
  std::optional<double> m_time;
};

}  // namespace windloom
