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

std::optional<glm::vec2> pointerWay(const ToolContext& context, AxisLock lock, glm::vec2 pixel, glm::vec2 pressed,
                                    glm::vec2 anchor) {
  if (lock == AxisLock::None || !context.ground.height) {
    const auto place = context.groundAt(pixel);
    return place ? std::optional(*place - pressed) : std::nullopt;
  }
  const Ground level{nullptr, context.ground.at(anchor)};
  const auto start = context.view.toScreen(context.ground.lift(pressed));
  const auto from = start ? context.view.toGround(*start, level) : std::nullopt;
  const auto to = context.view.toGround(pixel, level);
  return from && to ? std::optional(*to - *from) : std::nullopt;
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
