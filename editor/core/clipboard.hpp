#pragma once
// Copy and paste as the text of a project that holds only what was copied, so that it can be mailed.

#include "editor/core/workspace.hpp"

namespace windloom::editor {

/// Puts the selection on the clipboard.
void copySelection(Workspace& workspace);
/// Adds what the clipboard's text holds (any project's text will do) with its middle under the pointer, and selects
/// it. Text that is no project is refused with a message. Files of what this editor copied in another project's folder
/// come along into this one's; what is missing all the same is told.
void pasteAtPointer(Workspace& workspace);

}  // namespace windloom::editor
