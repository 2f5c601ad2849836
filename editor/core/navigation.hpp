#pragma once
// Mouse and keys that move the camera: MMB or Alt+LMB orbits, Shift+MMB or Alt+MMB pans, wheel zooms to the
// cursor, Alt+RMB drags the zoom, RMB held looks around and WASD QE fly.

#include <set>

#include "editor/core/camera_control.hpp"
#include "editor/core/tool.hpp"

namespace windloom::editor {

class Navigator {
 public:
  /// True where the press starts a camera gesture.
  bool press(const PointerEvent& pointer);
  bool move(EditorCamera& camera, const PointerEvent& pointer, glm::vec2 viewport, const Ground& ground);
  bool release(const PointerEvent& pointer);
  /// While flying the wheel changes the speed, otherwise it zooms to the pixel.
  void wheel(EditorCamera& camera, float notches, glm::vec2 pixel, glm::vec2 viewport, const Ground& ground);
  /// Keys held while flying; true where they were used.
  bool key(Key key, bool down);
  /// Moves a flying camera on; call once a frame.
  void tick(EditorCamera& camera, double seconds, Modifiers held);
  void cancel();

  [[nodiscard]] bool active() const { return m_gesture != Gesture::None; }
  [[nodiscard]] bool flying() const { return m_gesture == Gesture::Fly; }
  [[nodiscard]] float speedMps() const { return m_speedMps; }

 private:
  enum class Gesture { None, Orbit, Pan, Zoom, Fly };
  Gesture m_gesture = Gesture::None;
  PointerButton m_button = PointerButton::Middle;
  glm::vec2 m_last{0.0f}, m_start{0.0f};
  float m_speedMps = 12.0f;
  std::set<Key> m_held;
};

}  // namespace windloom::editor
