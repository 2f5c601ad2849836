#pragma once
// The list of formats with their sizes, and what to know about the chosen ones.

#include "editor/panels/export_request.hpp"

namespace windloom::editor {

/// `request` is what the choices make of the project, `header` what its writers will be told.
void drawFormats(ExportChoices& choices, const BakeHeader& header, const BakeRequest& request);
void drawFormatWarnings(const BakeHeader& header, const BakeRequest& request);

}  // namespace windloom::editor
