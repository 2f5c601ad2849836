#include "editor/core/transform_drag.hpp"

#include <algorithm>
#include <cmath>

#include "editor/core/object_edits.hpp"
#include "editor/core/snapping.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {
constexpr float kMinScale = 0.01f, kMaxScale = 100.0f;

float angleOf(glm::vec2 way) {
  return glm::degrees(std::atan2(way.y, way.x));
}
}  // namespace

TransformDrag::TransformDrag(const ToolContext& context, TransformKind kind, glm::vec2 pivot, glm::vec2 pressed,
                             AxisLock lock)
    : m_kind(kind),
      m_pivot(pivot),
      m_pressed(pressed),
      m_place(pressed),
      m_ids(context.selection.ids().begin(), context.selection.ids().end()),
      m_lock(lock) {}

/// How much farther from the pivot the pointer is now; along the axis where one is locked and the press was off it.
float TransformDrag::ratio() const {
  const glm::vec2 before = m_pressed - m_pivot, now = m_place - m_pivot;
  const glm::vec2 axis = axisOf(m_lock);
  const float along = glm::dot(before, axis);
  if (std::abs(along) > 0.1f * glm::length(before) && std::abs(along) > 1e-3f) return glm::dot(now, axis) / along;
  return glm::length(now) / std::max(glm::length(before), 1e-3f);
}

std::optional<Edit> TransformDrag::make(const ToolContext& context) const {
  if (m_degrees == 0.0f && m_scale == glm::vec2(1.0f)) return std::nullopt;
  return transformEdit(context.document.committed(), m_ids, m_pivot, m_degrees, m_scale);
}

std::optional<Edit> TransformDrag::update(ToolContext& context, const PointerEvent& pointer) {
  if (const auto way = pointerWay(context, m_lock, pointer.pixel, m_pressed, m_pivot)) m_place = m_pressed + *way;
  m_pixel = pointer.pixel;
  const glm::vec2 before = m_pressed - m_pivot, now = m_place - m_pivot;
  const auto typed = m_number.value();
  if (m_kind == TransformKind::Rotate) {
    const float turned = std::remainder(angleOf(now) - angleOf(before), 360.0f);
    m_degrees = typed ? *typed : snapAngle(context.settings.snap, turned, pointer.modifiers);
  } else {
    const float factor = std::clamp(typed ? *typed : ratio(), kMinScale, kMaxScale);
    m_scale = {m_lock == AxisLock::Z ? 1.0f : factor, m_lock == AxisLock::X ? 1.0f : factor};
  }
  return make(context);
}

std::optional<Edit> TransformDrag::end(ToolContext& context) {
  return make(context);
}

bool TransformDrag::onKey(ToolContext&, const KeyPress& press) {
  if (press.key == Key::Enter || press.key == Key::NumpadEnter) {
    m_finished = true;
    return true;
  }
  // A turn on the ground has one axis only.
  return (m_kind == TransformKind::Scale && toggleLock(m_lock, press)) || m_number.onKey(press);
}

void TransformDrag::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  addLockLine(shapes, context.ground, m_lock, m_pivot);
  shapes.dots.push_back({context.ground.lift(m_pivot), ShapeRole::Guide});
  shapes.lines.push_back({context.ground.lift(m_pivot), context.ground.lift(m_place), ShapeRole::Guide});
  const double value = static_cast<double>(m_kind == TransformKind::Rotate ? m_degrees
                                           : m_lock == AxisLock::Z         ? m_scale.y
                                                                           : m_scale.x);
  std::string text = m_number.empty() ? fixed(value, m_kind == TransformKind::Rotate ? 1 : 3) : m_number.text();
  text += m_kind == TransformKind::Rotate ? " deg" : " x";
  shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f), std::move(text)});
}

std::string TransformDrag::hint(const ToolContext&) const {
  return m_kind == TransformKind::Rotate ? "Type an angle in degrees + Enter, Ctrl snaps the angle, Esc cancels"
                                         : "X or Z locks the axis, type a factor + Enter, Esc cancels";
}

}  // namespace windloom::editor
