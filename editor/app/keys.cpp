#include "editor/app/keys.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace windloom::editor {

namespace {

Key offset(Key first, int by) {
  return static_cast<Key>(static_cast<int>(first) + by);
}

Key byCharacter(char c) {
  if (c >= 'a' && c <= 'z') return offset(Key::A, c - 'a');
  if (c >= 'A' && c <= 'Z') return offset(Key::A, c - 'A');
  if (c >= '0' && c <= '9') return offset(Key::Digit0, c - '0');
  switch (c) {
    case '[':
      return Key::BracketLeft;
    case ']':
      return Key::BracketRight;
    case ',':
      return Key::Comma;
    case '.':
      return Key::Period;
    case '/':
      return Key::Slash;
    case '\\':
      return Key::Backslash;
    case ';':
      return Key::Semicolon;
    case '\'':
      return Key::Apostrophe;
    case '-':
      return Key::Minus;
    case '=':
      return Key::Equal;
    case '`':
      return Key::Grave;
    default:
      return Key::None;
  }
}

Key special(int key) {
  switch (key) {
    case GLFW_KEY_KP_DIVIDE:
      return Key::NumpadSlash;
    case GLFW_KEY_KP_MULTIPLY:
      return Key::NumpadStar;
    case GLFW_KEY_KP_SUBTRACT:
      return Key::NumpadMinus;
    case GLFW_KEY_KP_ADD:
      return Key::NumpadPlus;
    case GLFW_KEY_KP_DECIMAL:
      return Key::NumpadPeriod;
    case GLFW_KEY_KP_ENTER:
      return Key::NumpadEnter;
    case GLFW_KEY_SPACE:
      return Key::Space;
    case GLFW_KEY_ENTER:
      return Key::Enter;
    case GLFW_KEY_ESCAPE:
      return Key::Escape;
    case GLFW_KEY_TAB:
      return Key::Tab;
    case GLFW_KEY_BACKSPACE:
      return Key::Backspace;
    case GLFW_KEY_DELETE:
      return Key::Delete;
    case GLFW_KEY_INSERT:
      return Key::Insert;
    case GLFW_KEY_HOME:
      return Key::Home;
    case GLFW_KEY_END:
      return Key::End;
    case GLFW_KEY_PAGE_UP:
      return Key::PageUp;
    case GLFW_KEY_PAGE_DOWN:
      return Key::PageDown;
    case GLFW_KEY_LEFT:
      return Key::Left;
    case GLFW_KEY_RIGHT:
      return Key::Right;
    case GLFW_KEY_UP:
      return Key::Up;
    case GLFW_KEY_DOWN:
      return Key::Down;
    default:
      return Key::None;
  }
}

}  // namespace

Key translateKey(int glfwKey, int scancode) {
  if (glfwKey >= GLFW_KEY_F1 && glfwKey <= GLFW_KEY_F12) return offset(Key::F1, glfwKey - GLFW_KEY_F1);
  if (glfwKey >= GLFW_KEY_KP_0 && glfwKey <= GLFW_KEY_KP_9) return offset(Key::Numpad0, glfwKey - GLFW_KEY_KP_0);
  if (const Key key = special(glfwKey); key != Key::None) return key;
  const char* printed = glfwGetKeyName(glfwKey, scancode);
  if (printed && printed[0] != 0 && printed[1] == 0)
    if (const Key key = byCharacter(printed[0]); key != Key::None) return key;
  // GLFW's printable keys are numbered by the character that a US layout has at that place.
  return glfwKey > 32 && glfwKey < 127 ? byCharacter(static_cast<char>(glfwKey)) : Key::None;
}

Modifiers translateModifiers(int glfwModifiers) {
#ifdef __APPLE__
  constexpr int kCommand = GLFW_MOD_SUPER;
#else
  constexpr int kCommand = GLFW_MOD_CONTROL;
#endif
  return {.ctrl = (glfwModifiers & kCommand) != 0,
          .shift = (glfwModifiers & GLFW_MOD_SHIFT) != 0,
          .alt = (glfwModifiers & GLFW_MOD_ALT) != 0};
}

}  // namespace windloom::editor
