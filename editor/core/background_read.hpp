#pragma once
// Reads one thing at a time beside the frame loop.

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom::editor {

template <class T>
class BackgroundRead {
 public:
  /// Told what is done next; false: give up.
  using Watch = std::function<bool(std::string_view doing)>;
  using Work = std::function<Result<T>(const Watch&)>;

  BackgroundRead() = default;
  ~BackgroundRead() {  // waits for what still reads
    cancel();
    for (Worker& worker : m_workers) worker.thread.join();
  }
  BackgroundRead(const BackgroundRead&) = delete;
  BackgroundRead& operator=(const BackgroundRead&) = delete;

  /// Begins `work` on a thread of its own; what was being read is given up. `file` goes into messages.
  void start(std::string doing, std::string file, Work work) {
    cancel();
    std::erase_if(m_workers, [](Worker& worker) {
      if (!worker.job->done) return false;
      worker.thread.join();
      return true;
    });
    auto job = std::make_shared<Job>();
    job->doing = std::move(doing);
    m_job = job;
    m_workers.push_back({std::thread([job, file = std::move(file), work = std::move(work)] {
                           const auto watch = [&](std::string_view next) {
                             const std::scoped_lock lock(job->mutex);
                             job->doing = next;
                             return !job->stop.load();
                           };
                           Result<T> result = workOrSay(work, watch, file);
                           const std::scoped_lock lock(job->mutex);
                           job->result = std::make_unique<Result<T>>(std::move(result));
                           job->done = true;
                         }),
                         job});
  }
  [[nodiscard]] bool running() const { return m_job != nullptr; }
  /// Empty where nothing runs.
  [[nodiscard]] std::string doing() const {
    if (!m_job) return {};
    const std::scoped_lock lock(m_job->mutex);
    return m_job->doing;
  }
  /// Nothing comes of it any more.
  void cancel() {
    if (m_job) m_job->stop = true;
    m_job.reset();
  }
  /// The result, once, when it is there.
  std::optional<Result<T>> poll() {
    if (!m_job) return std::nullopt;
    std::unique_ptr<Result<T>> result;
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
    std::unique_ptr<Result<T>> result;
  };
  struct Worker {
    std::thread thread;
    std::shared_ptr<Job> job;
  };

  /// A file within the limits may still ask for more memory than there is: no reason to lose the editor's work.
  static Result<T> workOrSay(const Work& work, const Watch& watch, const std::string& file) {
    try {
      return work(watch);
    } catch (const std::bad_alloc&) {
      return makeError(ErrorKind::Machine, file, {}, "can't be read: there is not enough memory");
    }
  }

  std::shared_ptr<Job> m_job;
  std::vector<Worker> m_workers;
};

}  // namespace windloom::editor
