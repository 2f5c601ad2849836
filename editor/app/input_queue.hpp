#pragma once
// Window events in their order, handed out so that no press is lost on a slow frame: Dear ImGui 1.86 looks at
// the state of a button once a frame, so a click that begins and ends between two frames, or a drag that ends
// elsewhere, would be seen wrongly. A frame gets events only up to the first that would hide another.

#include <deque>
#include <vector>

namespace windloom::editor {

struct InputEvent {
  enum class Kind { MouseMove, MouseButton, Wheel, Key, Text, Focus };
  Kind kind = Kind::MouseMove;
  double x = 0, y = 0;  ///< window pixels; Wheel: notches
  int code = 0;         ///< button, GLFW key or code point
  int scancode = 0;     ///< Key
  int action = 0;       ///< GLFW_PRESS, GLFW_RELEASE, GLFW_REPEAT; Focus: 1 gained, 0 lost
  int modifiers = 0;    ///< GLFW_MOD_* at the event
};

class InputQueue {
 public:
  void push(const InputEvent& event) { m_waiting.push_back(event); }
  [[nodiscard]] bool empty() const { return m_waiting.empty(); }

  /// The events of the next frame; with `holdKeys` only those before the first key or text. With `typing`, where a text
  /// field has the keyboard, letters come in as many as there are: only their characters count, not their keys, and a
  /// frame for each would make a slow scene swallow a line by the letter.
  std::vector<InputEvent> takeFrame(bool holdKeys, bool typing);

 private:
  std::deque<InputEvent> m_waiting;
};

}  // namespace windloom::editor
