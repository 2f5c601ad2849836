#pragma once
// What the last solver step did: how much divergence it left, how fast the air is, where its time went.

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

void drawSolverPanel(PanelContext& context);

}  // namespace windloom::editor
