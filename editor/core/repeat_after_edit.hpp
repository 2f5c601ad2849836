#pragma once
// When work is to be done again after the project changed: some time after the last edit, so that a row of edits makes
// one.

#include <cstdint>
#include <optional>

namespace windloom::editor {

class RepeatAfterEdit {
 public:
  static constexpr double kQuietS = 2;

  /// The work was done with the project as it is after `edits` edits (Document::editCount).
  void doneAt(std::uint64_t edits) {
    m_done = edits;
    m_seen = edits;
  }
  void forget() { m_done.reset(); }

  /// Each frame, at `seconds` of a clock. True, once: there were edits since the work was done, the last one kQuietS
  /// ago.
  bool due(std::uint64_t edits, double seconds) {
    if (!m_done) return false;
    if (edits != m_seen) {
      m_seen = edits;
      m_since = seconds;
    }
    if (m_seen == *m_done || seconds - m_since < kQuietS) return false;
    m_done = m_seen;
    return true;
  }

 private:
  std::optional<std::uint64_t> m_done;
  std::uint64_t m_seen = 0;
  double m_since = 0;
};

}  // namespace windloom::editor
