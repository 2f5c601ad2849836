#pragma once
// Writers at work beside the simulation: each frame goes to every writer of its track, several writers at a time, while
// the next frames are still being computed.

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "engine/bake/frame_writer.hpp"

namespace windloom {

class WriteBehind {
 public:
  /// As many threads as the machine has, at most one for each writer.
  explicit WriteBehind(std::size_t writers);
  /// Drops what wasn't written yet.
  ~WriteBehind();
  WriteBehind(const WriteBehind&) = delete;
  WriteBehind& operator=(const WriteBehind&) = delete;

  using Cells = std::shared_ptr<const std::vector<glm::vec2>>;
  /// Hands frames to writer number `index` in the order of the calls; a writer is never called by two threads. Waits
  /// where too many frames are waiting already. Fails with what any writer failed with so far.
  Status add(std::size_t index, FrameWriter& writer, int frame, const Cells& cells);
  /// Waits until all is written. Fails with the first failure of a writer.
  Status finish();

 private:
  struct Job {
    FrameWriter* writer;
    int frame;
    Cells cells;
  };
  struct Lane {
    std::deque<Job> jobs;
    bool busy = false;
    std::thread thread;
  };
  void work(Lane& lane);
  [[nodiscard]] Status failure() const;  // with m_mutex held

  std::mutex m_mutex;  // for all below
  std::condition_variable m_changed;
  std::deque<Lane> m_lanes;
  std::optional<Error> m_error;
  bool m_ended = false;
};

}  // namespace windloom
