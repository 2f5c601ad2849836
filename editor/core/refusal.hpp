#pragma once
// Why an edit was refused, in words for the status bar: places of the project file become things.

#include <string>

#include "engine/core/result.hpp"

namespace windloom::editor {

/// "/graph/arrows/3" and "has no length: ..." become "The arrow has no length: ...". More problems than one are
/// counted at the end.
std::string refusalText(const Error& error);

}  // namespace windloom::editor
