#pragma once
// Menu bar and toolbar, both made from the table of actions.

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

/// Draws the bar at the top of the current window, which must have ImGuiWindowFlags_MenuBar.
void drawMenuBar(Workspace& workspace);

/// One row of buttons.
void drawToolbar(PanelContext& context);

}  // namespace windloom::editor
