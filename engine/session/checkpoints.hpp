#pragma once
// States of a run, kept so that going back in time needn't begin at the start.

#include <cstddef>
#include <functional>
#include <map>
#include <memory>

#include "engine/core/result.hpp"
#include "engine/wind/wind_solver.hpp"

namespace windloom {

struct CheckpointLimits {
  std::size_t bytes = 256u << 20;  ///< of all states together
  long everySteps = 60;            ///< from one to the next, until they don't fit: then twice as far, and so on
};

class Checkpoints {
 public:
  explicit Checkpoints(CheckpointLimits limits = {}) : m_limits(limits), m_every(limits.everySteps) {}

  struct Entry {
    double seconds = 0;
    std::unique_ptr<WindState> state;
  };

  /// Keeps a state of step `step` > 0 where one is due; `save` is asked for it only then. Where it fails or doesn't fit
  /// nothing is kept.
  void offer(long step, double seconds, const std::function<Result<std::unique_ptr<WindState>>()>& save);
  /// A step whose state stays however many there are, such as the start of a loop; 0: none.
  void pin(long step) { m_pinned = step; }

  /// The newest one of `step` or before; null: none. Valid until the next offer() or clear().
  [[nodiscard]] const std::pair<const long, Entry>* newestUpTo(long step) const;
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }
  [[nodiscard]] std::size_t count() const { return m_entries.size(); }
  [[nodiscard]] long everySteps() const { return m_every; }

  /// Another run: none of these states belongs to it.
  void clear();
  /// The same, with another distance.
  void clear(long everySteps) {
    m_limits.everySteps = everySteps;
    clear();
  }

 private:
  void thinOut();

  CheckpointLimits m_limits;
  std::map<long, Entry> m_entries;
  std::size_t m_bytes = 0;
  long m_every, m_pinned = 0;
  bool m_full = false;  // not even a few fit, or saving failed
};

}  // namespace windloom
