#pragma once
// Every step since the project was opened; a click goes back or forth to it.

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

void drawHistoryPanel(PanelContext& context);

}  // namespace windloom::editor
