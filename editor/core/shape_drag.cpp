#include "editor/core/shape_drag.hpp"

namespace windloom::editor {

std::optional<Edit> ShapeDrag::update(ToolContext& context, const PointerEvent& pointer) {
  m_pixel = pointer.pixel;
  m_held = pointer.modifiers;
  if (const auto place = context.groundAt(pointer.pixel)) m_place = *place;
  return make(context);
}

bool ShapeDrag::onKey(ToolContext&, const KeyPress& press) {
  if (press.key == Key::Enter || press.key == Key::NumpadEnter) {
    m_finished = true;
    return true;
  }
  return m_number.onKey(press);
}

void ShapeDrag::shapes(const ToolContext&, PreviewShapes& shapes) const {
  shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f), m_number.empty() ? m_text : m_number.text()});
}

float ShapeDrag::distance(const ToolContext& context) const {
  return glm::distance(snapToGrid(context.settings.snap, m_place, m_held), m_grip.pivot);
}

}  // namespace windloom::editor
