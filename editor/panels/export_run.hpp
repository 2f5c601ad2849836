#pragma once
// An export beside the window: a thread with a simulation of its own, on the GPU where there is a real one.

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "engine/bake/bake.hpp"

namespace windloom::editor {

class ExportRun {
 public:
  ExportRun() = default;
  /// Cancels what runs and waits for it.
  ~ExportRun();
  ExportRun(const ExportRun&) = delete;
  ExportRun& operator=(const ExportRun&) = delete;

  struct Job {
    Project project;  ///< a value: edits meanwhile don't reach it
    BakeRequest request;
    std::optional<double> warmUp;  ///< s: the wind begins that long before the first frame, else at the start
  };
  /// Nothing may run.
  void start(Job job);
  void cancel() { m_cancel = true; }
  [[nodiscard]] bool running() const { return m_worker.joinable(); }

  struct Progress {
    BakePhase phase = BakePhase::Recording;
    double part = 0;                    ///< of the phase, 0..1
    std::optional<double> leftSeconds;  ///< of the recording, which takes nearly all of the time
    bool cancelling = false, onGpu = false;
  };
  [[nodiscard]] Progress progress() const;

  struct Outcome {
    enum class Kind { Done, Cancelled, Failed } kind = Kind::Done;
    std::string text;
    std::filesystem::path folder;
  };
  /// Once, after it ended.
  std::optional<Outcome> poll();

 private:
  void work(const Job& job);

  std::thread m_worker;
  std::atomic<bool> m_cancel = false, m_ended = false, m_onGpu = false;
  std::atomic<double> m_part = 0;
  std::atomic<BakePhase> m_phase = BakePhase::Recording;
  std::chrono::steady_clock::time_point m_startedAt;
  Outcome m_outcome;  // the worker's until m_ended
};

}  // namespace windloom::editor
