#pragma once
// A number typed during a drag: digits, a point, a minus, backspace.

#include <optional>
#include <string>

#include "editor/core/shortcut.hpp"

namespace windloom::editor {

class NumberEntry {
 public:
  /// True where the key was taken.
  bool onKey(const KeyPress& press);
  /// Nothing until a digit was typed.
  [[nodiscard]] std::optional<float> value() const;
  [[nodiscard]] const std::string& text() const { return m_text; }
  [[nodiscard]] bool empty() const { return m_text.empty(); }

 private:
  std::string m_text;
};

}  // namespace windloom::editor
