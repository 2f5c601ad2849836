#include "engine/gpu/timer.hpp"

#include "engine/core/contract.hpp"
#include "engine/gpu/object_label.hpp"

namespace windloom::gpu {

GpuTimer::GpuTimer(int ring) : m_slots(static_cast<std::size_t>(ring)) {
  WL_REQUIRE(ring > 0, "a timer has a frame");
}

void GpuTimer::stamp(Slot& slot) {
  if (slot.used == slot.queries.size()) {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    labelObject(QueryKind::kLabel, name, "stage timer");
    slot.queries.emplace_back(name);
  }
  glQueryCounter(slot.queries[slot.used++].name(), GL_TIMESTAMP);
}

void GpuTimer::beginFrame() {
  WL_REQUIRE(m_open == nullptr, "frames of a timer don't nest");
  collect(Wait::No);
  Slot& slot = m_slots[m_next];
  if (slot.pending) return;  // every slot is in flight: this frame goes unmeasured
  slot.used = 0;
  slot.names.clear();
  m_open = &slot;
}

void GpuTimer::stage(std::string_view name) {
  if (m_open == nullptr) return;
  stamp(*m_open);
  m_open->names.emplace_back(name);
}

void GpuTimer::endFrame() {
  if (m_open == nullptr) return;
  stamp(*m_open);
  m_open->pending = true;
  m_open = nullptr;
  m_next = (m_next + 1) % m_slots.size();
}

void GpuTimer::collect(Wait wait) {
  while (m_slots[m_oldest].pending) {
    Slot& slot = m_slots[m_oldest];
    const GLuint last = slot.queries[slot.used - 1].name();
    GLint available = 0;
    if (wait == Wait::No) glGetQueryObjectiv(last, GL_QUERY_RESULT_AVAILABLE, &available);
    if (wait == Wait::No && available == 0) return;
    std::vector<GLuint64> stamps(slot.used);
    for (std::size_t i = 0; i < slot.used; ++i)
      glGetQueryObjectui64v(slot.queries[i].name(), GL_QUERY_RESULT, &stamps[i]);
    m_stages.clear();
    for (std::size_t i = 0; i < slot.names.size(); ++i) {
      m_stages.emplace_back(slot.names[i], static_cast<double>(stamps[i + 1] - stamps[i]) * 1e-6);
    }
    m_totalMs = static_cast<double>(stamps.back() - stamps.front()) * 1e-6;
    slot.pending = false;
    m_oldest = (m_oldest + 1) % m_slots.size();
  }
}

const std::vector<std::pair<std::string, double>>& GpuTimer::stages() {
  collect(Wait::No);
  return m_stages;
}

double GpuTimer::totalMs() {
  collect(Wait::No);
  return m_totalMs;
}

void GpuTimer::finish() {
  collect(Wait::Yes);
}

}  // namespace windloom::gpu
