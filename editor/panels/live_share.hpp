#pragma once
// The wind as it blows in the editor, shared with a game on the same machine while both run
// (engine/bake/live_link.hpp).

#include <memory>
#include <string>

#include "editor/core/preferences.hpp"
#include "editor/panels/live_publisher.hpp"
#include "engine/session/session.hpp"

namespace windloom::editor {

class LiveShare {
 public:
  static constexpr double kFieldsASecond = 30;  ///< at most

  [[nodiscard]] bool on() const { return m_on; }
  void setOn(bool on);
  /// What the game asks for. Sharing goes on under the new name.
  [[nodiscard]] const std::string& name() const { return m_name; }
  void setName(const std::string& name);

  /// Each frame after the session advanced (null: there is none), at `seconds` of real time. `edges`: where the
  /// project's field repeats. Never waits for the wind.
  void update(Session* session, LiveEdges edges, double seconds);

  [[nodiscard]] bool failed() const { return m_on && !m_link.problem.empty(); }
  /// "sharing 256 x 256, 30 fields a second", or what went wrong; empty while off.
  [[nodiscard]] std::string state() const;

  void read(const Preferences& preferences);
  void keep(Preferences& preferences) const;

 private:
  void measureRate(double seconds);

  bool m_on = false;
  std::string m_name = "windloom";
  std::unique_ptr<LivePublisher> m_publisher;
  LivePublisher::State m_link;
  double m_sentAt = -1e9;
  long m_sent = 0;  // number of the field that was sent last
  glm::ivec2 m_resolution{0};
  // Fields of about a second.
  long long m_countedTo = 0;
  double m_countedFrom = 0, m_rate = 0;
};

}  // namespace windloom::editor
