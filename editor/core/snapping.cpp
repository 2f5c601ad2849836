#include "editor/core/snapping.hpp"

#include <cmath>

namespace windloom::editor {

glm::vec2 snapToGrid(const SnapSettings& snap, glm::vec2 place, Modifiers held) {
  if (snap.grid == held.ctrl || !(snap.gridM > 0.0f)) return place;
  return glm::round(place / snap.gridM) * snap.gridM;
}

glm::vec2 snapEnd(const SnapSettings& snap, glm::vec2 start, glm::vec2 place, Modifiers held) {
  if (snap.grid != held.ctrl) return snapToGrid(snap, place, held);
  const glm::vec2 way = place - start;
  const float length = glm::length(way);
  if (!snap.angle || length < 1e-6f || !(snap.angleDeg > 0.0f)) return place;
  const float step = glm::radians(snap.angleDeg);
  const float angle = std::round(std::atan2(way.y, way.x) / step) * step;
  return start + length * glm::vec2(std::cos(angle), std::sin(angle));
}

float snapAngle(const SnapSettings& snap, float degrees, Modifiers held) {
  if (snap.angle == held.ctrl || !(snap.angleDeg > 0.0f)) return degrees;
  return std::round(degrees / snap.angleDeg) * snap.angleDeg;
}

}  // namespace windloom::editor
