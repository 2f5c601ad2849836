#pragma once
// A live link on a thread of its own, so that neither making it nor averaging a large field down costs a frame.

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "engine/bake/live_link.hpp"
#include "engine/session/field_readout.hpp"

namespace windloom::editor {

class LivePublisher {
 public:
  /// Makes the link, again and again until it can: another program may let go of the name.
  explicit LivePublisher(std::string name);
  /// Ends the link.
  ~LivePublisher();
  LivePublisher(const LivePublisher&) = delete;
  LivePublisher& operator=(const LivePublisher&) = delete;

  /// Publishes it soon, instead of one that still waits.
  void publish(std::shared_ptr<const FieldSnapshot> field, LiveEdges edges);

  struct State {
    bool open = false;
    std::string problem;      ///< why there is no link; empty: it is there, or is being made
    long long published = 0;  ///< fields
  };
  [[nodiscard]] State state() const;

 private:
  void work();
  void makeLink();

  std::string m_name;
  std::unique_ptr<LiveLink> m_link;  // the worker's
  mutable std::mutex m_mutex;        // for what follows
  std::condition_variable m_wake;
  bool m_end = false;
  std::shared_ptr<const FieldSnapshot> m_waiting;
  LiveEdges m_edges;
  State m_state;
  std::thread m_worker;
};

}  // namespace windloom::editor
