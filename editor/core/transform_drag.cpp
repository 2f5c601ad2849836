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

TransformDrag::TransformDrag(const ToolContext& context, TransformKind kind, glm::vec2 pivot, glm::vec2 pressed)
    : m_kind(kind),
      m_pivot(pivot),
      m_pressed(pressed),
      m_place(pressed),
      m_ids(context.selection.ids().begin(), context.selection.ids().end()) {}

std::optional<Edit> TransformDrag::make(const ToolContext& context) const {
  if (m_degrees == 0.0f && m_scale == 1.0f) return std::nullopt;
  return transformEdit(context.document.committed(), m_ids, m_pivot, m_degrees, m_scale);
}

std::optional<Edit> TransformDrag::update(ToolContext& context, const PointerEvent& pointer) {
  if (const auto place = context.groundAt(pointer.pixel)) m_place = *place;
  m_pixel = pointer.pixel;
  const glm::vec2 before = m_pressed - m_pivot, now = m_place - m_pivot;
  const auto typed = m_number.value();
  if (m_kind == TransformKind::Rotate) {
    const float turned = std::remainder(angleOf(now) - angleOf(before), 360.0f);
    m_degrees = typed ? *typed : snapAngle(context.settings.snap, turned, pointer.modifiers);
  } else {
    const float ratio = glm::length(now) / std::max(glm::length(before), 1e-3f);
    m_scale = std::clamp(typed ? *typed : ratio, kMinScale, kMaxScale);
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
  return m_number.onKey(press);
}

void TransformDrag::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  shapes.dots.push_back({context.ground.lift(m_pivot), ShapeRole::Guide});
  shapes.lines.push_back({context.ground.lift(m_pivot), context.ground.lift(m_place), ShapeRole::Guide});
  const double value = static_cast<double>(m_kind == TransformKind::Rotate ? m_degrees : m_scale);
  std::string text = m_number.empty() ? fixed(value, m_kind == TransformKind::Rotate ? 1 : 3) : m_number.text();
  text += m_kind == TransformKind::Rotate ? " deg" : " x";
  shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f), std::move(text)});
}

std::string TransformDrag::hint(const ToolContext&) const {
  return m_kind == TransformKind::Rotate ? "Type an angle in degrees + Enter, Ctrl snaps the angle, Esc cancels"
                                         : "Type a factor + Enter, Esc cancels";
}

}  // namespace windloom::editor
