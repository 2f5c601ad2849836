#pragma once
// What probes felt over simulated time. Going back in time cuts off what comes after, so that a trace always belongs to
// one run; where samples are missing there is a gap.

#include <deque>
#include <map>
#include <optional>
#include <span>

#include "engine/model/project.hpp"

namespace windloom::editor {

struct TraceSample {
  double time = 0;  ///< simulated s
  glm::vec2 wind{0.0f};
};

class ProbeTraces {
 public:
  /// Samples further apart than this have a gap between them, s.
  static constexpr double kGapS = 0.25;
  static constexpr std::size_t kMostSamples = 4096;  ///< of one probe, the newest: at 30 a second over two minutes

  /// Keeps traces of these probes only. One that moved starts again.
  void follow(std::span<const Probe> probes);
  /// A sample at the place of a probe; probes elsewhere don't take it. One that isn't later than the last cuts off what
  /// it replaces.
  void add(double time, glm::vec2 place, glm::vec2 wind);
  /// Time is now at `now`: later samples are of another run.
  void cutAfter(double now);
  void clear();

  /// By ascending time; empty for a probe that felt nothing yet.
  [[nodiscard]] const std::deque<TraceSample>& samples(Id probe) const;
  /// The wind at a time, between samples where there is no gap; nothing outside.
  [[nodiscard]] std::optional<glm::vec2> at(Id probe, double time) const;

 private:
  struct Trace {
    glm::vec2 place{0.0f};
    std::deque<TraceSample> samples;
  };
  std::map<Id, Trace> m_traces;
};

/// Degrees that the air goes to, 0..360, from +X towards +Z; nothing where it stands still.
std::optional<float> headingDeg(glm::vec2 wind);

}  // namespace windloom::editor
