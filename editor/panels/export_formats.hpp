#pragma once
// The list of formats with their sizes, and what to know about the chosen ones.

#include <span>
#include <string>

#include "editor/panels/export_request.hpp"

namespace windloom::editor {

/// `request` is what the choices make of the project, `header` what its writers will be told.
void drawFormats(ExportChoices& choices, const BakeHeader& header, const BakeRequest& request);
void drawFormatWarnings(std::span<const std::string> warnings);
/// How many there are, for where the list may be out of sight; what they say on hovering.
void drawWarningSign(std::span<const std::string> warnings);

}  // namespace windloom::editor
