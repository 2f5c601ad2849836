#include "editor/panels/live_publisher.hpp"

#include <chrono>
#include <utility>

#include "engine/core/log.hpp"
#include "engine/core/out_of_memory.hpp"

namespace windloom::editor {
namespace {

constexpr auto kTryAgain = std::chrono::seconds(3);

}  // namespace

LivePublisher::LivePublisher(std::string name) : m_name(std::move(name)), m_worker([this] { work(); }) {}

LivePublisher::~LivePublisher() {
  {
    const std::lock_guard lock(m_mutex);
    m_end = true;
  }
  m_wake.notify_all();
  m_worker.join();
}

void LivePublisher::publish(std::shared_ptr<const FieldSnapshot> field, LiveEdges edges) {
  {
    const std::lock_guard lock(m_mutex);
    m_waiting = std::move(field);
    m_edges = edges;
  }
  m_wake.notify_all();
}

LivePublisher::State LivePublisher::state() const {
  const std::lock_guard lock(m_mutex);
  return m_state;
}

void LivePublisher::makeLink() {
  Result<std::unique_ptr<LiveLink>> link = orOutOfMemory("the live link", [this] { return LiveLink::create(m_name); });
  const std::string problem = link ? std::string() : link.error().text();
  if (link) m_link = std::move(*link);
  const std::lock_guard lock(m_mutex);
  if (!problem.empty() && problem != m_state.problem) logWarning("Live link: " + problem);
  m_state.problem = problem;
  m_state.open = m_link != nullptr;
}

void LivePublisher::work() {
  for (;;) {
    if (!m_link) makeLink();
    std::unique_lock lock(m_mutex);
    if (m_link)
      m_wake.wait(lock, [this] { return m_end || m_waiting; });
    else
      m_wake.wait_for(lock, kTryAgain, [this] { return m_end; });
    if (m_end) break;
    const auto field = std::exchange(m_waiting, nullptr);
    const LiveEdges edges = m_edges;
    lock.unlock();
    if (!m_link || !field) continue;
    const Status sent = orOutOfMemory("the live link", [&]() -> Status {
      m_link->publish(field->grid, field->cells, field->time, edges);
      return Done{};
    });
    lock.lock();
    m_state.published += sent.ok();
    if (sent) continue;
    m_link.reset();  // made again a little later
    m_state.open = false;
    m_state.problem = sent.error().text();
  }
  m_link.reset();
}

}  // namespace windloom::editor
