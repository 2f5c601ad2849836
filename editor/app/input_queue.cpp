#include "editor/app/input_queue.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace windloom::editor {

namespace {

constexpr int kLocks = GLFW_MOD_CAPS_LOCK | GLFW_MOD_NUM_LOCK;

/// Keys that edit text: they must not overtake the characters around them.
bool editsText(int key) {
  switch (key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
    case GLFW_KEY_TAB:
    case GLFW_KEY_ESCAPE:
    case GLFW_KEY_BACKSPACE:
    case GLFW_KEY_DELETE:
    case GLFW_KEY_LEFT:
    case GLFW_KEY_RIGHT:
    case GLFW_KEY_UP:
    case GLFW_KEY_DOWN:
    case GLFW_KEY_HOME:
    case GLFW_KEY_END:
      return true;
    default:
      return false;
  }
}

/// Keys that a text field knows by their characters alone, and Shift, which is in them.
bool onlyWrites(const InputEvent& event) {
  if (event.kind != InputEvent::Kind::Key || (event.modifiers & ~GLFW_MOD_SHIFT & ~kLocks) != 0) return false;
  return (event.code >= GLFW_KEY_SPACE && event.code <= GLFW_KEY_WORLD_2) || event.code == GLFW_KEY_LEFT_SHIFT ||
         event.code == GLFW_KEY_RIGHT_SHIFT;
}

/// What a frame already holds.
struct FrameContents {
  bool button = false, wheel = false, text = false, editKey = false, shortcut = false, focus = false;
  unsigned buttons = 0;
  std::vector<int> keys;

  [[nodiscard]] bool takes(const InputEvent& event, bool typing) const {
    if (focus) return false;
    if (typing && onlyWrites(event)) return !button && !editKey && !shortcut;
    switch (event.kind) {
      case InputEvent::Kind::MouseMove:
        return !button && !wheel && !text && keys.empty();
      case InputEvent::Kind::MouseButton:
        return !wheel && !text && keys.empty() && (buttons >> event.code & 1u) == 0;
      case InputEvent::Kind::Wheel:
        return !button;
      case InputEvent::Kind::Text:
        return !button && !editKey;
      case InputEvent::Kind::Key:
        if (button || std::find(keys.begin(), keys.end(), event.code) != keys.end()) return false;
        return !(editsText(event.code) && text) && !shortcut;
      case InputEvent::Kind::Focus:
        return true;
    }
    return true;
  }

  void add(const InputEvent& event, bool typing) {
    if (typing && onlyWrites(event)) return;
    switch (event.kind) {
      case InputEvent::Kind::MouseMove:
        break;
      case InputEvent::Kind::MouseButton:
        button = true;
        buttons |= 1u << event.code;
        break;
      case InputEvent::Kind::Wheel:
        wheel = true;
        break;
      case InputEvent::Kind::Text:
        text = true;
        break;
      case InputEvent::Kind::Key:
        keys.push_back(event.code);
        editKey = editKey || editsText(event.code);
        // Modifiers are read as a state: a shortcut must not meet the release of its Ctrl in the same frame.
        shortcut = shortcut || (event.action != GLFW_RELEASE && event.modifiers != 0);
        break;
      case InputEvent::Kind::Focus:
        focus = true;
        break;
    }
  }
};

}  // namespace

std::vector<InputEvent> InputQueue::takeFrame(bool holdKeys, bool typing) {
  std::vector<InputEvent> frame;
  FrameContents contents;
  while (!m_waiting.empty() && contents.takes(m_waiting.front(), typing)) {
    const InputEvent::Kind kind = m_waiting.front().kind;
    if (holdKeys && (kind == InputEvent::Kind::Key || kind == InputEvent::Kind::Text)) break;
    contents.add(m_waiting.front(), typing);
    frame.push_back(m_waiting.front());
    m_waiting.pop_front();
  }
  return frame;
}

}  // namespace windloom::editor
