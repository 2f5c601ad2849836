#pragma once
// Snapping of places and angles.

#include <glm/glm.hpp>

#include "editor/core/tool.hpp"

namespace windloom::editor {

/// The nearest grid crossing where the grid is on; Ctrl held turns the grid on or off for the moment.
glm::vec2 snapToGrid(const SnapSettings& snap, glm::vec2 place, Modifiers held);
/// The same for the end of a line from `start`: grid first, else its angle in steps.
glm::vec2 snapEnd(const SnapSettings& snap, glm::vec2 start, glm::vec2 place, Modifiers held);
float snapAngle(const SnapSettings& snap, float degrees, Modifiers held);

}  // namespace windloom::editor
