#include "engine/bake/write_behind.hpp"

#include <algorithm>
#include <exception>

#include "engine/core/out_of_memory.hpp"

namespace windloom {
namespace {

// Of one lane; more would only be more memory.
constexpr std::size_t kWaitingJobs = 4;

}  // namespace

WriteBehind::WriteBehind(std::size_t writers) {
  const std::size_t lanes =
      std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, std::max<std::size_t>(writers, 1));
  try {
    while (m_lanes.size() < lanes) {
      Lane& lane = m_lanes.emplace_back();
      lane.thread = std::thread([this, &lane] { work(lane); });
    }
  } catch (const std::exception&) {
    // The system gives no more threads, or memory has ended: those that are there will do, or this one.
    if (!m_lanes.empty() && !m_lanes.back().thread.joinable()) m_lanes.pop_back();
  }
}

WriteBehind::~WriteBehind() {
  {
    const std::lock_guard lock(m_mutex);
    for (Lane& lane : m_lanes) lane.jobs.clear();
    m_ended = true;
  }
  m_changed.notify_all();
  for (Lane& lane : m_lanes) lane.thread.join();
}

Status WriteBehind::failure() const {
  return m_error ? Status(*m_error) : Status(Done{});
}

Status WriteBehind::add(std::size_t index, FrameWriter& writer, int frame, const Cells& cells) {
  if (m_lanes.empty()) {
    if (Status added = writer.add(frame, *cells); !added && !m_error) m_error = added.error();
    return failure();
  }
  Lane& lane = m_lanes[index % m_lanes.size()];
  std::unique_lock lock(m_mutex);
  m_changed.wait(lock, [&] { return m_error || lane.jobs.size() < kWaitingJobs; });
  if (!m_error) lane.jobs.push_back({&writer, frame, cells});
  m_changed.notify_all();
  return failure();
}

Status WriteBehind::finish() {
  std::unique_lock lock(m_mutex);
  m_changed.wait(lock, [&] {
    return std::ranges::all_of(m_lanes, [&](const Lane& lane) { return !lane.busy && (m_error || lane.jobs.empty()); });
  });
  return failure();
}

void WriteBehind::work(Lane& lane) {
  std::unique_lock lock(m_mutex);
  while (true) {
    m_changed.wait(lock, [&] { return m_ended || (!lane.jobs.empty() && !m_error); });
    if (m_ended) return;
    const Job job = std::move(lane.jobs.front());
    lane.jobs.pop_front();
    lane.busy = true;
    lock.unlock();
    const Status added = orOutOfMemory("writing a frame", [&] { return job.writer->add(job.frame, *job.cells); });
    lock.lock();
    lane.busy = false;
    if (!added && !m_error) m_error = added.error();
    m_changed.notify_all();
  }
}

}  // namespace windloom
