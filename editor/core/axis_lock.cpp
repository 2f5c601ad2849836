#include "editor/core/axis_lock.hpp"

namespace windloom::editor {

bool toggleLock(AxisLock& lock, const KeyPress& press) {
  if (press.modifiers.any() || (press.key != Key::X && press.key != Key::Z)) return false;
  const AxisLock wanted = press.key == Key::X ? AxisLock::X : AxisLock::Z;
  lock = lock == wanted ? AxisLock::None : wanted;
  return true;
}

glm::vec2 axisOf(AxisLock lock) {
  return lock == AxisLock::X ? glm::vec2(1.0f, 0.0f) : lock == AxisLock::Z ? glm::vec2(0.0f, 1.0f) : glm::vec2(0.0f);
}

void addLockLine(PreviewShapes& shapes, const Ground& ground, AxisLock lock, glm::vec2 place) {
  constexpr float kReach = 2000.0f;
  if (lock == AxisLock::None) return;
  const glm::vec3 middle = ground.lift(place);
  const glm::vec2 axis = axisOf(lock);
  const glm::vec3 way = kReach * glm::vec3(axis.x, 0.0f, axis.y);
  shapes.lines.push_back({middle - way, middle + way, lock == AxisLock::X ? ShapeRole::AxisX : ShapeRole::AxisZ});
}

}  // namespace windloom::editor
