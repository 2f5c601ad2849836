#include "editor/core/box_drag.hpp"

namespace windloom::editor {

SelectMode selectMode(Modifiers held) {
  return held.ctrl ? SelectMode::Toggle : held.shift ? SelectMode::Add : SelectMode::Replace;
}

BoxDrag::BoxDrag(const ToolContext& context, const PointerEvent& press)
    : m_before(context.selection), m_mode(selectMode(press.modifiers)), m_from(press.pixel), m_to(press.pixel) {}

std::optional<Edit> BoxDrag::update(ToolContext& context, const PointerEvent& pointer) {
  m_to = pointer.pixel;
  context.selection = m_before;
  select(context.selection,
         pickBox(context.document.project(), context.view, context.ground, m_from, m_to, context.windSeconds), m_mode);
  return std::nullopt;
}

void BoxDrag::shapes(const ToolContext&, PreviewShapes& shapes) const {
  shapes.rectangles.push_back({glm::min(m_from, m_to), glm::max(m_from, m_to)});
}

std::string BoxDrag::hint(const ToolContext& context) const {
  return "Box select: " + std::to_string(context.selection.size()) + " selected. Shift adds, Ctrl toggles, Esc cancels";
}

}  // namespace windloom::editor
