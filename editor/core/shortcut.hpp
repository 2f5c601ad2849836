#pragma once
// Keys, modifiers and shortcuts without a window system. The app translates its key codes to Key.

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace windloom::editor {

// clang-format off
enum class Key {
  None,
  A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
  Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
  F1, F2, F3, F4, F5, F6, F7, F8, F9, F10, F11, F12,
  Numpad0, Numpad1, Numpad2, Numpad3, Numpad4, Numpad5, Numpad6, Numpad7, Numpad8, Numpad9,
  NumpadSlash, NumpadStar, NumpadMinus, NumpadPlus, NumpadPeriod, NumpadEnter,
  Space, Enter, Escape, Tab, Backspace, Delete, Insert, Home, End, PageUp, PageDown, Left, Right, Up, Down,
  BracketLeft, BracketRight, Comma, Period, Slash, Backslash, Semicolon, Apostrophe, Minus, Equal, Grave,
  Count
};
// clang-format on

struct Modifiers {
  bool ctrl = false;  ///< on a Mac, Command
  bool shift = false;
  bool alt = false;
  [[nodiscard]] bool any() const { return ctrl || shift || alt; }
  auto operator<=>(const Modifiers&) const = default;
};

struct Shortcut {
  Key key = Key::None;
  Modifiers modifiers;
  auto operator<=>(const Shortcut&) const = default;
};

/// "Ctrl+Shift+Z", "[", "Numpad 7", "Space". Empty for Key::None.
std::string toText(const Shortcut& shortcut);
std::string toText(Key key);
/// Case does not matter, modifiers in any order, spaces around '+' allowed. Nothing for anything else.
std::optional<Shortcut> parseShortcut(std::string_view text);

/// A key going down (or repeating) with the modifiers held.
struct KeyPress {
  Key key = Key::None;
  Modifiers modifiers;
  bool repeat = false;
};

/// 0..9 for digit keys of both blocks, nothing for others.
std::optional<int> digitOf(Key key);

}  // namespace windloom::editor
