#pragma once
// Play, pause, step, restart, the clock, and what each root's signal does around now.

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

void drawTimelinePanel(PanelContext& context);

}  // namespace windloom::editor
