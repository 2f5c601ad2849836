#pragma once
// When grass that colliders touch is stepped, so that every picture at a time shows what they did shortly before.

#include <optional>

namespace windloom {

/// Steps of one length: step i = 1..count ends at `start` + i * `seconds`.
struct TouchSteps {
  bool fromRest = false;  ///< all that grass remembers belongs to another time or meadow
  double start = 0;       ///< s of simulated time; may lie before 0, where colliders wait
  int count = 0;
  float seconds = 0;
};

inline constexpr double kTouchMemoryS = 4.0;          ///< after it, touched grass of the usual swing stands again
inline constexpr double kLongestTouchGapS = 0.5;      ///< a longer way ahead is a jump
inline constexpr double kTouchRunUpStepS = 1.0 / 30;  ///< of the steps that lead to a time after a jump

class TouchClock {
 public:
  /// The way from the last call to `time` (s) in steps of about `stepSeconds`. The first call, a way back and a long
  /// way ahead are jumps: they begin at rest kTouchMemoryS before `time`.
  TouchSteps advance(double time, double stepSeconds);
  /// The next call is a jump.
  void forget() { m_time.reset(); }

 private:
  std::optional<double> m_time;
};

}  // namespace windloom
