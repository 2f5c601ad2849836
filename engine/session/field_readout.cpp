#include "engine/session/field_readout.hpp"

#include <epoxy/gl.h>

#include <atomic>
#include <cstring>

#include "engine/core/contract.hpp"
#include "engine/core/log.hpp"
#include "engine/session/simulation.hpp"

namespace windloom {
namespace {

// The answer comes two or three frames late; more on their way would only be more memory.
constexpr int kSlots = 3;

std::size_t cellsOf(glm::ivec2 resolution) {
  return static_cast<std::size_t>(resolution.x) * static_cast<std::size_t>(resolution.y);
}

}  // namespace

void FieldReadout::dropRing() {
  m_inFlight.clear();
  m_ring = {};
  m_ringResolution = glm::ivec2(0);
}

bool FieldReadout::fitRing(glm::ivec2 resolution) {
  if (resolution == m_ringResolution) return !m_failed;
  dropRing();
  m_ringResolution = resolution;
  Result<gpu::ReadbackRing> ring =
      gpu::ReadbackRing::create("field read-out", cellsOf(resolution) * sizeof(glm::vec2), kSlots);
  m_failed = !ring;
  if (m_failed)
    logError(ring.error().text());
  else
    m_ring = std::move(*ring);
  return !m_failed;
}

void FieldReadout::ask(Simulation& simulation) {
  if (simulation.steps() == m_askedStep) return;
  WindSolver& solver = simulation.solver();
  const GridMapping& grid = solver.grid();
  if (solver.backend() == Backend::Cpu) {
    dropRing();
    next(simulation.time(), grid).cells = simulation.velocity();
  } else {
    if (!fitRing(grid.resolution)) return;
    if (!m_ring.request(solver.velocityTexture(), GL_RG, GL_FLOAT, m_tag + 1)) return;
    m_inFlight.push_back({++m_tag, simulation.time(), grid});
  }
  m_askedStep = simulation.steps();
}

/// What takes the place of the newest; its cells still hold something older.
FieldSnapshot& FieldReadout::next(double time, const GridMapping& grid) {
  const long number = m_newest->number + 1;
  if (m_newest.use_count() > 1) m_newest = std::make_shared<FieldSnapshot>();
  // Another thread may just have let go of it: what it read comes before what is written now.
  std::atomic_thread_fence(std::memory_order_acquire);
  m_newest->number = number;
  m_newest->time = time;
  m_newest->grid = grid;
  return *m_newest;
}

std::shared_ptr<const FieldSnapshot> FieldReadout::newest() {
  while (!m_inFlight.empty()) {
    const auto arrived = m_ring.takeOldest(gpu::ReadbackRing::Wait::No);
    if (!arrived) break;
    const Request request = m_inFlight.front();
    m_inFlight.pop_front();
    WL_REQUIRE(request.tag == arrived->tag, "answers come in the order of requests");
    std::vector<glm::vec2>& cells = next(request.time, request.grid).cells;
    cells.resize(cellsOf(request.grid.resolution));
    std::memcpy(cells.data(), arrived->bytes.data(), arrived->bytes.size());
  }
  return m_newest;
}

}  // namespace windloom
