#pragma once
// The line at the bottom: hint or message on the left, how the machine is doing on the right.

#include <string>

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

class StatusBar {
 public:
  void draw(PanelContext& context);

 private:
  std::uint64_t m_messageNumber = 0;
  double m_messageAt = -1e9;
  std::string m_tool;  // the one in hand when the message came
};

}  // namespace windloom::editor
