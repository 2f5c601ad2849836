#pragma once
// What the active tool makes new things with, at the top of the inspector.

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

/// Nothing for tools without options.
void drawToolOptions(PanelContext& context);

}  // namespace windloom::editor
