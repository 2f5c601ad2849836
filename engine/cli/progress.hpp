#pragma once
// How far long work has come, on standard error: one line that is written over on a terminal, a line every quarter
// elsewhere, nothing for work that is done within a second.

#include <chrono>
#include <string>

namespace windloom::cli {

class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `part` in 0..1 of the phase called `phase`. Cheap enough to call at every step.
  void show(const std::string& phase, double part);

 private:
  std::chrono::steady_clock::time_point m_start, m_last;
  bool m_terminal;
  bool m_open = false;  // a line on the terminal without its end
  std::string m_phase;
  int m_quarter = 0;
};

}  // namespace windloom::cli
