#include "engine/core/thread_pool.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/core/contract.hpp"

namespace windloom {

struct ThreadPool::State {
  std::mutex mutex;
  std::condition_variable wake;
  std::condition_variable finished;
  const std::function<void(int)>* body = nullptr;
  std::atomic<int> next{0};
  std::exception_ptr failure;  // the first of a body
  int chunks = 0;
  int busy = 0;
  unsigned generation = 0;
  bool stopping = false;
  std::vector<std::thread> workers;

  void drain() {
    try {
      for (int chunk = next.fetch_add(1); chunk < chunks; chunk = next.fetch_add(1)) (*body)(chunk);
    } catch (...) {
      next = chunks;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  }

  void run() {
    unsigned seen = 0;
    std::unique_lock lock(mutex);
    for (;;) {
      wake.wait(lock, [&] { return stopping || generation != seen; });
      if (stopping) return;
      seen = generation;
      lock.unlock();
      drain();
      lock.lock();
      if (--busy == 0) finished.notify_one();
    }
  }
};

namespace {
int chooseThreads(int asked) {
  if (asked > 0) return asked;
  if (const char* text = std::getenv("WINDLOOM_THREADS")) {
    if (const int n = std::atoi(text); n > 0) return std::min(n, 256);
  }
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}
}  // namespace

ThreadPool::ThreadPool(int threads) : m_state(std::make_unique<State>()) {
  try {
    for (int i = 1, n = chooseThreads(threads); i < n; ++i)
      m_state->workers.emplace_back([s = m_state.get()] { s->run(); });
  } catch (const std::exception&) {
    // The system gives no more threads, or memory has ended: those that are there will do.
  }
}

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(m_state->mutex);
    m_state->stopping = true;
  }
  m_state->wake.notify_all();
  for (std::thread& worker : m_state->workers) worker.join();
}

int ThreadPool::threads() const {
  return static_cast<int>(m_state->workers.size()) + 1;
}

void ThreadPool::parallelFor(int chunks, const std::function<void(int)>& body) {
  State& s = *m_state;
  if (s.workers.empty() || chunks <= 1) {
    for (int chunk = 0; chunk < chunks; ++chunk) body(chunk);
    return;
  }
  {
    const std::lock_guard lock(s.mutex);
    WL_REQUIRE(s.body == nullptr, "parallelFor of one pool is not re-entrant");
    s.body = &body;
    s.chunks = chunks;
    s.next = 0;
    s.busy = static_cast<int>(s.workers.size());
    ++s.generation;
  }
  s.wake.notify_all();
  s.drain();
  std::unique_lock lock(s.mutex);
  s.finished.wait(lock, [&] { return s.busy == 0; });
  s.body = nullptr;
  if (s.failure) std::rethrow_exception(std::exchange(s.failure, nullptr));
}

}  // namespace windloom
