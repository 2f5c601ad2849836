#include "engine/wind/gpu_cycles.hpp"

#include <algorithm>

namespace windloom {
namespace {
constexpr long kMemory =
    32;  // steps; long enough to bridge the beat of two colliding whirls, short enough to calm down
}

void GpuCycles::forget(long nextStep) {
  m_known.clear();
  m_since = nextStep;
}

void GpuCycles::learn(long step, int cycles, bool converged) {
  if (step < m_since) return;
  // Without convergence one more may not be enough: the error of a sudden gust takes about two.
  m_known.push_back({step, converged ? cycles : cycles + 2});
  while (!m_known.empty() && m_known.front().step + kMemory + kDelay < step) m_known.pop_front();
}

int GpuCycles::plan(long step, int limit) const {
  int needed = -1;
  for (const Known& known : m_known) {
    const long age = step - known.step;
    if (age >= kDelay && age < kDelay + kMemory) needed = std::max(needed, known.needed);
  }
  if (needed < 0) return limit;
  return std::clamp(needed + 1, 1, std::max(limit, 1));  // one to spare: a step may need more than any before it
}

}  // namespace windloom
