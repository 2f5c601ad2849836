#pragma once
// How many V-cycles the GPU backend records for a step. The GPU skips those it doesn't need, but even skipped
// dispatches cost time, so the number follows what recent steps needed. It only looks at steps that are at least kDelay
// back, whether or not newer ones are known: the same run records the same cycles, however fast the GPU answers.

#include <deque>

namespace windloom {

class GpuCycles {
 public:
  /// Steps between a step and the first one that knows how it went.
  static constexpr long kDelay = 4;

  /// Everything known so far doesn't tell about what comes: a restart, a field from outside, other solids.
  void forget(long nextStep);

  /// What step `step` needed: it stopped after `cycles`, with a residual of so many times the wanted one.
  void learn(long step, int cycles, double residual);

  /// Whether anything is known that tells about `step`.
  [[nodiscard]] bool knows(long step) const;

  /// Cycles to record for `step`, at most `limit`.
  [[nodiscard]] int plan(long step, int limit) const;

 private:
  [[nodiscard]] int needed(long step) const;  // 0: not known
  struct Known {
    long step;
    int needed;
  };
  std::deque<Known> m_known;
  long m_since = 1;  // the first step that counts
};

}  // namespace windloom
