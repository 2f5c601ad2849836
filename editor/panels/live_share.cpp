#include "editor/panels/live_share.hpp"

#include <algorithm>

#include "engine/core/log.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

// Another program may let go of the name; asking costs some hundredths of a second while it doesn't.
constexpr double kTryAgainS = 10;

}  // namespace

void LiveShare::setOn(bool on) {
  m_on = on;
  m_problem.clear();
  m_triedAt = -1e9;
  m_rate = 0;
  if (!on) m_link.reset();
}

void LiveShare::setName(const std::string& name) {
  if (name == m_name) return;
  m_name = name;
  m_link.reset();
  setOn(m_on);
}

void LiveShare::open(double seconds) {
  if (seconds - m_triedAt < kTryAgainS) return;
  m_triedAt = seconds;
  Result<std::unique_ptr<LiveLink>> link = LiveLink::create(m_name);
  if (!link) {
    const std::string problem = link.error().text();
    if (problem != m_problem) logWarning("Live link: " + problem);
    m_problem = problem;
    return;
  }
  m_problem.clear();
  m_link = std::move(*link);
  m_field = 0;
  m_counted = 0;
  m_countedFrom = seconds;
}

void LiveShare::update(Session* session, LiveEdges edges, double seconds) {
  if (!m_on) return;
  if (!m_link) open(seconds);
  if (!m_link || !session) return;
  // A little early is in time: frames don't come to the millisecond.
  if (seconds - m_publishedAt >= 1 / kFieldsASecond - 0.004) {
    session->askField();
    const FieldSnapshot& field = session->field();
    if (field.number != m_field) publish(field, edges, seconds);
  }
  if (seconds - m_countedFrom < 1) return;
  m_rate = m_counted / (seconds - m_countedFrom);
  m_counted = 0;
  m_countedFrom = seconds;
}

void LiveShare::publish(const FieldSnapshot& field, LiveEdges edges, double seconds) {
  m_link->publish(field.grid, field.cells, field.time, edges);
  m_field = field.number;
  m_publishedAt = seconds;
  m_resolution = glm::min(field.grid.resolution, glm::ivec2(LiveLink::kMaxSide));
  ++m_counted;
}

std::string LiveShare::state() const {
  if (!m_on || !m_problem.empty()) return m_on ? m_problem : std::string();
  if (m_field == 0) return "waiting for the wind";
  const std::string size = std::to_string(m_resolution.x) + " x " + std::to_string(m_resolution.y);
  return "sharing " + size + ", " + (m_rate < 0.5 ? "the wind is held" : fixed(m_rate, 0) + " fields a second");
}

void LiveShare::read(const Preferences& preferences) {
  setName(preferences.text("live.name", m_name));
  setOn(preferences.number("live.on", 0) != 0);
}

void LiveShare::keep(Preferences& preferences) const {
  preferences.texts["live.name"] = m_name;
  preferences.numbers["live.on"] = m_on ? 1 : 0;
}

}  // namespace windloom::editor
