#pragma once
// How the CPU backend spreads rows over threads. What a task holds never depends on the number of threads, and sums are
// added up in the order of tasks, so the results don't either.

#include <algorithm>

#include "engine/core/thread_pool.hpp"

#if defined(__SSE__) || defined(_M_X64)
#include <immintrin.h>
#endif

namespace windloom {

/// While it lives, this thread's arithmetic takes numbers too small for a normal float as 0. Air that calms down
/// ends there, and such numbers cost a hundred times as much. Processors without the switch just stay slow.
class FlushTinyNumbers {
 public:
#if defined(__SSE__) || defined(_M_X64)
  FlushTinyNumbers() : m_before(_mm_getcsr()) {
    _mm_setcsr(m_before | 0x8040u);
  }  // flush to zero, denormals are zero
  ~FlushTinyNumbers() {
    _mm_setcsr(m_before);
  }

 private:
  unsigned m_before;
#elif defined(__aarch64__) && defined(__GNUC__)
  FlushTinyNumbers() : m_before(__builtin_aarch64_get_fpcr64()) {
    __builtin_aarch64_set_fpcr64(m_before | (1ull << 24));
  }
  ~FlushTinyNumbers() {
    __builtin_aarch64_set_fpcr64(m_before);
  }

 private:
  unsigned long long m_before;
#else
  FlushTinyNumbers() = default;
#endif

 public:
  FlushTinyNumbers(const FlushTinyNumbers&) = delete;
  FlushTinyNumbers& operator=(const FlushTinyNumbers&) = delete;
};

/// Rows of a field that a task works on.
inline constexpr int kRowsPerTask = 16;

inline int tasksFor(int rows, int rowsPerTask = kRowsPerTask) {
  return (rows + rowsPerTask - 1) / rowsPerTask;
}

/// Calls body(task, rowBegin, rowEnd) for all rows, `width` values long each. Little work stays on this thread: waking
/// another one takes some ten microseconds.
template <class Body>
void forRows(ThreadPool& pool, int width, int rows, const Body& body, int rowsPerTask = kRowsPerTask) {
  constexpr long kWorthAThread = 20'000;  // values; below it one thread was faster on two cores
  const int tasks = tasksFor(rows, rowsPerTask);
  const auto run = [&](int task) {
    const FlushTinyNumbers flush;
    body(task, task * rowsPerTask, std::min(rows, (task + 1) * rowsPerTask));
  };
  if (static_cast<long>(width) * rows < kWorthAThread) {
    for (int task = 0; task < tasks; ++task) run(task);
  } else {
    pool.parallelFor(tasks, run);
  }
}

}  // namespace windloom
