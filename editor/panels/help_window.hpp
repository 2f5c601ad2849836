#pragma once
// All keys and mouse gestures, from the table of actions.

#include "editor/core/actions.hpp"

namespace windloom::editor {

/// Draws the window while `open`; its close button clears it.
void drawHelpWindow(const ActionTable& actions, bool& open);

}  // namespace windloom::editor
