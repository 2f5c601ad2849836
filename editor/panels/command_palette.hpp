#pragma once
// Every action by typing a part of its name.

#include <string>

#include "editor/core/actions.hpp"

namespace windloom::editor {

class CommandPalette {
 public:
  void open() { m_open = m_justOpened = true; }
  [[nodiscard]] bool isOpen() const { return m_open; }
  void draw(ActionTable& actions);

 private:
  bool m_open = false, m_justOpened = false;
  std::string m_text;
  int m_row = 0;
};

}  // namespace windloom::editor
