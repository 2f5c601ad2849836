#pragma once
// What the last frame drew of shell grass.

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

/// A table of its counts, and how far the shells are off from the blades that they stand for. All 0 where there is no
/// live view.
void drawShellCounts(PanelContext& context);

}  // namespace windloom::editor
