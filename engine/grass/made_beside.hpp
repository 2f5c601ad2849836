#pragma once
// Something large that is made beside the frame from a project: blades, textures.

#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <string>

#include "engine/core/result.hpp"
#include "engine/model/project.hpp"

namespace windloom {

/// Whether a frame waits for what is made beside it.
enum class Placement { Wait, Later };

template <class Made>
class MadeBeside {
 public:
  /// `what` names it in a message. `make(project, cancelled)` runs on its own thread and may look at the flag.
  template <class Make>
  MadeBeside(const Project& from, std::string what, Make make) : project(from), m_what(std::move(what)) {
    m_made = std::async(std::launch::async, [this, make] { return make(project, &m_cancelled); });
  }
  ~MadeBeside() { m_cancelled = true; }  // the future's destructor waits
  MadeBeside(const MadeBeside&) = delete;
  MadeBeside& operator=(const MadeBeside&) = delete;

  [[nodiscard]] bool ready() const { return m_made.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }

  /// Waits; once only. Fails with Machine where there was no memory.
  Result<Made> take() {
    try {
      return m_made.get();
    } catch (const std::exception& failure) {
      return makeError(ErrorKind::Machine, m_what + " can't be made: " + failure.what());
    }
  }

  const Project project;

 private:
  std::string m_what;
  std::atomic<bool> m_cancelled = false;
  std::future<Made> m_made;
};

}  // namespace windloom
