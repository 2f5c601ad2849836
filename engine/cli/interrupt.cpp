#include "engine/cli/interrupt.hpp"

#include <csignal>

namespace windloom::cli {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

void onSignal(int) {
  g_interrupted = 1;
}

}  // namespace

void noteInterrupts() {
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
  return g_interrupted != 0;
}

}  // namespace windloom::cli
