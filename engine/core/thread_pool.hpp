#pragma once
// A fixed set of worker threads for data-parallel loops.

#include <functional>
#include <memory>

namespace windloom {

class ThreadPool {
 public:
  /// `threads` workers counting the calling thread; 0 takes one per hardware thread ($WINDLOOM_THREADS
  /// overrides that).
  explicit ThreadPool(int threads = 0);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int threads() const;

  /// Calls `body(chunk)` once for each chunk in [0, chunks), spread over the workers, and returns when
  /// all are done. What a chunk holds must be decided by the caller independently of the number of
  /// threads: then results are the same bytes for any number. Where `body` throws (memory ended) no more chunks begin and
  /// the first exception is thrown here. It must not call parallelFor of the same pool. One caller at a time.
  void parallelFor(int chunks, const std::function<void(int)>& body);

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace windloom
