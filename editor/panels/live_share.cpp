#include "editor/panels/live_share.hpp"

#include "engine/core/text.hpp"

namespace windloom::editor {

void LiveShare::setOn(bool on) {
  m_on = on;
  m_publisher.reset();
  m_link = {};
  m_sent = 0;
  m_countedTo = 0;
  m_rate = 0;
}

void LiveShare::setName(const std::string& name) {
  if (name == m_name) return;
  m_name = name;
  setOn(m_on);
}

void LiveShare::update(Session* session, LiveEdges edges, double seconds) {
  if (!m_on) return;
  if (!m_publisher) m_publisher = std::make_unique<LivePublisher>(m_name);
  m_link = m_publisher->state();
  measureRate(seconds);
  // A little early is in time: frames don't come to the millisecond.
  if (!session || !m_link.open || seconds - m_sentAt < 1 / kFieldsASecond - 0.004) return;
  session->askField();
  const std::shared_ptr<const FieldSnapshot> field = session->field();
  if (field->number == m_sent) return;
  m_sent = field->number;
  m_sentAt = seconds;
  m_resolution = glm::min(field->grid.resolution, glm::ivec2(LiveLink::kMaxSide));
  m_publisher->publish(field, edges);
}

void LiveShare::measureRate(double seconds) {
  if (seconds - m_countedFrom < 1) return;
  m_rate = double(m_link.published - m_countedTo) / (seconds - m_countedFrom);
  m_countedTo = m_link.published;
  m_countedFrom = seconds;
}

std::string LiveShare::state() const {
  if (!m_on || failed()) return m_link.problem;
  if (m_sent == 0) return "waiting for the wind";
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
