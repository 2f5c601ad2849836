#pragma once
// Copy and paste as the text of a project that holds only what was copied, so that it can be mailed.

#include "editor/core/workspace.hpp"

namespace windloom::editor {

/// Puts the selection on the clipboard.
void copySelection(Workspace& workspace);
/// Adds what the clipboard's text holds (any project's text will do) with its middle under the pointer, and selects
/// it. Text that is no project is refused with a message.
void pasteAtPointer(Workspace& workspace);

}  // namespace windloom::editor
