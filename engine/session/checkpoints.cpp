#include "engine/session/checkpoints.hpp"

#include <algorithm>
#include <iterator>

#include "engine/core/log.hpp"

namespace windloom {

void Checkpoints::offer(long step, double seconds, const std::function<Result<std::unique_ptr<WindState>>()>& save) {
  const bool due = step % m_every == 0 || step == m_pinned;
  if (m_full || step <= 0 || !due || m_entries.contains(step)) return;
  Result<std::unique_ptr<WindState>> state = save();
  if (!state) {
    logWarning("Going back in time begins at the start: " + state.error().text());
    m_full = true;
    return;
  }
  m_bytes += (*state)->bytes();
  m_entries[step] = {seconds, std::move(*state)};
  while (m_bytes > m_limits.bytes && !m_entries.empty()) thinOut();
}

void Checkpoints::thinOut() {
  if (m_entries.size() == 1) {
    clear();
    m_full = true;
    return;
  }
  m_every *= 2;
  std::erase_if(m_entries, [&](const auto& entry) {
    if (entry.first % m_every == 0 || entry.first == m_pinned) return false;
    m_bytes -= entry.second.state->bytes();
    return true;
  });
}

const std::pair<const long, Checkpoints::Entry>* Checkpoints::newestUpTo(long step) const {
  const auto after = m_entries.upper_bound(step);
  return after == m_entries.begin() ? nullptr : &*std::prev(after);
}

void Checkpoints::clear() {
  m_entries.clear();
  m_bytes = 0;
  m_every = m_limits.everySteps;
  m_full = false;
}

}  // namespace windloom
