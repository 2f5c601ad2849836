#include "engine/cli/progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace windloom::cli {
namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

Progress::Progress() : m_start(Clock::now()), m_last(m_start), m_terminal(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (m_open) std::fprintf(stderr, "\n");
}

void Progress::show(const std::string& phase, double part) {
  using namespace std::chrono_literals;
  const auto now = Clock::now();
  if (now - m_start < 1s) return;
  const int percent = static_cast<int>(part * 100.0);
  if (phase != m_phase) m_quarter = 0;
  if (m_terminal) {
    if (now - m_last < 100ms && phase == m_phase) return;
    std::fprintf(stderr, "\r%s %3d %%", phase.c_str(), percent);
    std::fflush(stderr);
    m_open = true;
  } else if (percent / 25 > m_quarter) {
    m_quarter = percent / 25;
    std::fprintf(stderr, "%s %d %%\n", phase.c_str(), percent);
  }
  m_last = now;
  m_phase = phase;
}

}  // namespace windloom::cli
