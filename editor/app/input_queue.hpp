#pragma once
// Window events in their order, handed out so that no press is lost on a slow frame: Dear ImGui 1.86 looks at
// the state of a button once a frame, so a click that begins and ends between two frames, or a drag that ends
// elsewhere, would be seen wrongly. A frame gets events only up to the first that would hide another.

#include <array>
#include <deque>
#include <vector>

struct GLFWwindow;

namespace windloom::editor {

struct InputEvent {
  enum class Kind { MouseMove, MouseButton, Wheel, Key, Text, Focus };
  Kind kind = Kind::MouseMove;
  double x = 0, y = 0;     ///< window pixels; Wheel: notches
  int code = 0;            ///< button, GLFW key or code point
  int scancode = 0;        ///< Key
  int action = 0;          ///< GLFW_PRESS, GLFW_RELEASE, GLFW_REPEAT; Focus: 1 gained, 0 lost
  int modifiers = 0;       ///< GLFW_MOD_* at the event
};

class InputQueue {
 public:
  void push(const InputEvent& event) { m_waiting.push_back(event); }
  [[nodiscard]] bool empty() const { return m_waiting.empty(); }

  /// The events of the next frame; with `holdKeys` only those before the first key or text.
  std::vector<InputEvent> takeFrame(bool holdKeys);

 private:
  std::deque<InputEvent> m_waiting;
};

/// Passes a frame's events to Dear ImGui's GLFW backend. Call `before` ahead of ImGui_ImplGlfw_NewFrame and
/// `after` behind it, since that one overwrites the mouse with its state of now.
class InputFeeder {
 public:
  void before(GLFWwindow* window, const std::vector<InputEvent>& events);
  void after() const;

 private:
  double m_x = -1e9, m_y = -1e9;
  std::array<bool, 5> m_down{};
};

}  // namespace windloom::editor
