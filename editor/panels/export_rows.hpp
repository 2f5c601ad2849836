#pragma once
// The export's choices row by row.

#include "editor/panels/export_request.hpp"

namespace windloom::editor {

/// The engine; choosing one proposes its formats.
void drawPresetRow(ExportChoices& choices);
/// When, how long, how fine.
void drawRecordingRows(ExportChoices& choices, const Project& project);
/// What the files hold. Rows that mean nothing to the chosen formats are left out.
void drawContentRows(ExportChoices& choices, const BakeRequest& request);

}  // namespace windloom::editor
