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

inline constexpr double kTouchMemoryS = 4.0;      ///< after it, touched grass of the usual swing stands again
inline constexpr double kLongestTouchGapS = 0.5;  ///< a longer way ahead is a jump

enum class RunUp {
  Full,   ///< after a jump kTouchMemoryS, in steps as when playing: shows what playing shows
  Quick,  ///< a part of it in longer steps, where it must not take long
};

class TouchClock {
 public:
  /// The way from the last call to `time` (s) in steps of about `stepSeconds`. The first call, a way back and a long
  /// way ahead are jumps, and so is a full run-up after a quick one: they begin at rest before `time`, `memorySeconds`
  /// for a full run-up.
  TouchSteps advance(double time, double stepSeconds, RunUp runUp = RunUp::Full, double memorySeconds = kTouchMemoryS);
  [[nodiscard]] bool standsAt(double time) const { return m_time == time; }
  /// The next call is a jump.
  void forget() { m_time.reset(); }

 private:
  std::optional<double> m_time;
  double m_quickUntil = 0;  // s: until then a quick run-up is still seen
};

}  // namespace windloom
