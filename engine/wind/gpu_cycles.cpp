#include "engine/wind/gpu_cycles.hpp"

#include <algorithm>

namespace windloom {
namespace {
constexpr double kComfortable = 0.6;  // of the wanted residual: below this a step needed no more
constexpr long kMemory =
    32;  // steps; long enough to bridge the beat of two colliding whirls, short enough to calm down
}  // namespace

void GpuCycles::forget(long nextStep) {
  m_known.clear();
  m_since = nextStep;
}

void GpuCycles::learn(long step, int cycles, double residual) {
  if (step < m_since) return;
  // One to spare where it was close. Without convergence one more may not be enough: the error of a sudden gust takes
  // about two.
  m_known.push_back({step, !(residual <= 1) ? cycles + 2 : residual > kComfortable ? cycles + 1 : cycles});
  while (!m_known.empty() && m_known.front().step + kMemory + kDelay < step) m_known.pop_front();
}

int GpuCycles::needed(long step) const {
  int needed = 0;
  for (const Known& known : m_known) {
    const long age = step - known.step;
    if (age >= kDelay && age < kDelay + kMemory) needed = std::max(needed, known.needed);
  }
  return needed;
}

bool GpuCycles::knows(long step) const {
  return needed(step) > 0;
}

int GpuCycles::plan(long step, int limit) const {
  return knows(step) ? std::clamp(needed(step), 1, std::max(limit, 1)) : limit;
}

}  // namespace windloom
