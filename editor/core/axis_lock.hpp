#pragma once
// X and Z lock a drag to an axis of the ground.

#include "editor/core/tool.hpp"

namespace windloom::editor {

enum class AxisLock { None, X, Z };

/// X or Z without modifiers: sets the lock, or takes it off where it is that one. False: another key.
bool toggleLock(AxisLock& lock, const KeyPress& press);
/// Unit vector of the axis; zero for none.
glm::vec2 axisOf(AxisLock lock);
/// A long line through `place`; nothing for none.
void addLockLine(PreviewShapes& shapes, const Ground& ground, AxisLock lock, glm::vec2 place);

}  // namespace windloom::editor
