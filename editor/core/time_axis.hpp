#pragma once
// A stretch of time on the screen: zoom, pan, ticks. The same for the ruler, the curves and the plots.

#include <string>
#include <vector>

namespace windloom::editor {

struct TimeAxis {
  double from = 0;      ///< s at the left end
  double seconds = 24;  ///< shown

  [[nodiscard]] double to() const { return from + seconds; }
  /// Share of the width, 0 at the left end.
  [[nodiscard]] double part(double time) const { return (time - from) / seconds; }
  [[nodiscard]] double timeAt(double part) const { return from + part * seconds; }
};

/// `factor` > 1 shows more time; `fixed` (s) stays where it is on the screen.
TimeAxis zoomed(TimeAxis axis, double factor, double fixed);
/// Never before 0 by more than a twentieth of what is shown.
TimeAxis panned(TimeAxis axis, double seconds);
/// From `from` to `to` with some room around.
TimeAxis framed(double from, double to);
/// Scrolls on by whole screens when `time` has left it.
TimeAxis following(TimeAxis axis, double time);

struct Tick {
  double value = 0;
  std::string text;
};
/// A distance of 1, 2 or 5 times a power of ten, at least `least`.
double tickStep(double least);
/// Ticks from `from` to `to`, `step` apart, with as many digits as they need.
std::vector<Tick> ticksBetween(double from, double to, double step);

/// The top of a scale from 0 that doesn't jump about: it grows at once, by whole steps, and shrinks only after the
/// values have been small for some time.
class SteadyTop {
 public:
  explicit SteadyTop(double least = 1) : m_least(least), m_top(least) {}
  /// `greatest` value shown now, at wall time `seconds`.
  double update(double greatest, double seconds);

 private:
  double m_least, m_top, m_smallSince = -1;
};

}  // namespace windloom::editor
