#include "editor/core/shortcut.hpp"

#include <array>
#include <cctype>

namespace windloom::editor {
namespace {

struct KeyName {
  Key key;
  std::string_view name;
};

// Letters, digits and function keys are named by rule; here are the others. A second name for a key is
// understood, the first is written.
constexpr auto kNames = std::to_array<KeyName>({
    {Key::Space, "Space"},
    {Key::Enter, "Enter"},
    {Key::Enter, "Return"},
    {Key::Escape, "Esc"},
    {Key::Escape, "Escape"},
    {Key::Tab, "Tab"},
    {Key::Backspace, "Backspace"},
    {Key::Delete, "Del"},
    {Key::Delete, "Delete"},
    {Key::Insert, "Insert"},
    {Key::Home, "Home"},
    {Key::End, "End"},
    {Key::PageUp, "Page Up"},
    {Key::PageDown, "Page Down"},
    {Key::PageUp, "PageUp"},
    {Key::PageDown, "PageDown"},
    {Key::Left, "Left"},
    {Key::Right, "Right"},
    {Key::Up, "Up"},
    {Key::Down, "Down"},
    {Key::BracketLeft, "["},
    {Key::BracketRight, "]"},
    {Key::Comma, ","},
    {Key::Period, "."},
    {Key::Slash, "/"},
    {Key::Backslash, "\\"},
    {Key::Semicolon, ";"},
    {Key::Apostrophe, "'"},
    {Key::Minus, "-"},
    {Key::Equal, "="},
    {Key::Grave, "`"},
    {Key::NumpadSlash, "Numpad /"},
    {Key::NumpadStar, "Numpad *"},
    {Key::NumpadMinus, "Numpad -"},
    {Key::NumpadPlus, "Numpad Plus"},
    {Key::NumpadPeriod, "Numpad ."},
    {Key::NumpadEnter, "Numpad Enter"},
});

constexpr Key offset(Key first, int by) {
  return static_cast<Key>(static_cast<int>(first) + by);
}
constexpr bool between(Key key, Key first, Key last) {
  return key >= first && key <= last;
}
constexpr int from(Key key, Key first) {
  return static_cast<int>(key) - static_cast<int>(first);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

Key parseKey(std::string_view text) {
  const std::string name = lower(text);
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z') return offset(Key::A, name[0] - 'a');
  if (name.size() == 1 && name[0] >= '0' && name[0] <= '9') return offset(Key::Digit0, name[0] - '0');
  for (int i = 1; i <= 12; ++i) {
    if (name == std::string("f").append(std::to_string(i))) return offset(Key::F1, i - 1);
  }
  if (name.size() == 8 && name.starts_with("numpad ") && name[7] >= '0' && name[7] <= '9') {
    return offset(Key::Numpad0, name[7] - '0');
  }
  for (const KeyName& entry : kNames) {
    if (lower(entry.name) == name) return entry.key;
  }
  return Key::None;
}

}  // namespace

std::string toText(Key key) {
  if (between(key, Key::A, Key::Z)) return std::string(1, static_cast<char>('A' + from(key, Key::A)));
  if (between(key, Key::Digit0, Key::Digit9)) return std::string(1, static_cast<char>('0' + from(key, Key::Digit0)));
  if (between(key, Key::F1, Key::F12)) return std::string("F").append(std::to_string(1 + from(key, Key::F1)));
  if (between(key, Key::Numpad0, Key::Numpad9))
    return std::string("Numpad ").append(std::to_string(from(key, Key::Numpad0)));
  for (const KeyName& entry : kNames) {
    if (entry.key == key) return std::string(entry.name);
  }
  return {};
}

std::string toText(const Shortcut& shortcut) {
  if (shortcut.key == Key::None) return {};
  std::string text;
  if (shortcut.modifiers.ctrl) text += "Ctrl+";
  if (shortcut.modifiers.alt) text += "Alt+";
  if (shortcut.modifiers.shift) text += "Shift+";
  return text + toText(shortcut.key);
}

std::optional<Shortcut> parseShortcut(std::string_view text) {
  Shortcut shortcut;
  text = trimmed(text);
  for (;;) {
    const std::size_t plus = text.find('+');
    if (plus == std::string_view::npos) break;
    const std::string modifier = lower(trimmed(text.substr(0, plus)));
    bool* flag = modifier == "ctrl" || modifier == "control" || modifier == "cmd" ? &shortcut.modifiers.ctrl
                 : modifier == "shift"                                            ? &shortcut.modifiers.shift
                 : modifier == "alt"                                              ? &shortcut.modifiers.alt
                                                                                  : nullptr;
    if (!flag || *flag) return std::nullopt;
    *flag = true;
    text = trimmed(text.substr(plus + 1));
  }
  shortcut.key = parseKey(text);
  if (shortcut.key == Key::None) return std::nullopt;
  return shortcut;
}

std::optional<int> digitOf(Key key) {
  if (between(key, Key::Digit0, Key::Digit9)) return from(key, Key::Digit0);
  if (between(key, Key::Numpad0, Key::Numpad9)) return from(key, Key::Numpad0);
  return std::nullopt;
}

}  // namespace windloom::editor
