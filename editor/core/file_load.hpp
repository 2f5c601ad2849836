#pragma once
// Reading a file beside the frame loop.

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/core/out_of_memory.hpp"
#include "engine/core/result.hpp"
#include "engine/io/terrain_file.hpp"

namespace windloom::editor {

template <class Value>
class FileLoad {
 public:
  using Work = std::function<Result<Value>(const LoadWatch&)>;

  FileLoad() = default;
  /// Waits for what still reads.
  ~FileLoad() {
    cancel();
    for (Worker& worker : m_workers) worker.thread.join();
  }
  FileLoad(const FileLoad&) = delete;
  FileLoad& operator=(const FileLoad&) = delete;

  /// Begins `work` on a thread; what was under way is given up. `file` is for messages.
  void start(const std::filesystem::path& file, Work work) {
    cancel();
    std::erase_if(m_workers, [](Worker& worker) {
      if (!worker.job->done) return false;
      worker.thread.join();
      return true;
    });
    auto job = std::make_shared<Job>();
    job->doing = "Reading " + file.filename().string();
    m_job = job;
    m_workers.push_back({std::thread([job, file, work = std::move(work)] { run(*job, file, work); }), job});
  }
  [[nodiscard]] bool running() const { return m_job != nullptr; }
  /// "Reading hills.png"; empty where nothing runs.
  [[nodiscard]] std::string doing() const {
    if (!m_job) return {};
    const std::scoped_lock lock(m_job->mutex);
    return m_job->doing;
  }
  /// Nothing comes of it any more; the work is told so by its watch.
  void cancel() {
    if (m_job) m_job->stop = true;
    m_job.reset();
  }
  /// What the work gave, once, when it is there.
  std::optional<Result<Value>> poll() {
    if (!m_job) return std::nullopt;
    std::unique_ptr<Result<Value>> result;
    {
      const std::scoped_lock lock(m_job->mutex);
      result = std::move(m_job->result);
    }
    if (!result) return std::nullopt;
    m_job.reset();
    return std::move(*result);
  }

 private:
  struct Job {
    std::atomic<bool> stop = false, done = false;
    mutable std::mutex mutex;
    std::string doing;
    std::unique_ptr<Result<Value>> result;
  };
  struct Worker {
    std::thread thread;
    std::shared_ptr<Job> job;
  };

  static void run(Job& job, const std::filesystem::path& file, const Work& work) {
    const auto watch = [&](std::string_view doing) {
      const std::scoped_lock lock(job.mutex);
      job.doing = doing;
      return !job.stop.load();
    };
    Result<Value> loaded = orSay(file, work, watch);
    const std::scoped_lock lock(job.mutex);
    job.result = std::make_unique<Result<Value>>(std::move(loaded));
    job.done = true;
  }
  /// A file within the limits may still ask for more memory than there is: no reason to lose the editor's work.
  static Result<Value> orSay(const std::filesystem::path& file, const Work& work, const LoadWatch& watch) {
    return orOutOfMemory(file.string(), [&] { return work(watch); });
  }

  std::shared_ptr<Job> m_job;
  std::vector<Worker> m_workers;
};

}  // namespace windloom::editor
