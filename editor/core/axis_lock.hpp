#pragma once
// X and Z lock a drag to an axis of the ground.

#include "editor/core/tool.hpp"

namespace windloom::editor {

enum class AxisLock { None, X, Z };

/// X or Z without modifiers: sets the lock, or takes it off where it is that one. False: another key.
bool toggleLock(AxisLock& lock, const KeyPress& press);
/// Unit vector of the axis; zero for none.
glm::vec2 axisOf(AxisLock lock);
/// The way over the ground from `pressed` to under the pointer. Locked over hills it is measured on the level plane of
/// `anchor`: on their slopes, and from ridge to ridge, the ground under the pointer tells little about one axis.
/// Nothing where there is no ground.
std::optional<glm::vec2> pointerWay(const ToolContext& context, AxisLock lock, glm::vec2 pixel, glm::vec2 pressed,
                                    glm::vec2 anchor);
/// A long line through `place`; nothing for none.
void addLockLine(PreviewShapes& shapes, const Ground& ground, AxisLock lock, glm::vec2 place);

}  // namespace windloom::editor
