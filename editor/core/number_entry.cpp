#include "editor/core/number_entry.hpp"

#include "engine/core/text.hpp"

namespace windloom::editor {

bool NumberEntry::onKey(const KeyPress& press) {
  constexpr std::size_t kMaxLength = 12;
  if (press.modifiers.ctrl || press.modifiers.alt) return false;
  if (press.key == Key::Backspace) {
    if (m_text.empty()) return false;
    m_text.pop_back();
    return true;
  }
  if (press.key == Key::Minus || press.key == Key::NumpadMinus) {
    if (m_text.starts_with('-')) {
      m_text.erase(0, 1);
    } else {
      m_text.insert(0, 1, '-');
    }
    return true;
  }
  if (m_text.size() >= kMaxLength) return digitOf(press.key).has_value();
  if (press.key == Key::Period || press.key == Key::NumpadPeriod || press.key == Key::Comma) {
    if (m_text.find('.') == std::string::npos) m_text += '.';
    return true;
  }
  if (const auto digit = digitOf(press.key)) {
    m_text += static_cast<char>('0' + *digit);
    return true;
  }
  return false;
}

std::optional<float> NumberEntry::value() const {
  const auto number = parseNumber(m_text);
  if (!number) return std::nullopt;
  return static_cast<float>(*number);
}

}  // namespace windloom::editor
