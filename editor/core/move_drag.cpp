#include "editor/core/move_drag.hpp"

#include "editor/core/object_edits.hpp"
#include "editor/core/snapping.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {

MoveDrag::MoveDrag(const ToolContext& context, glm::vec2 pressed, glm::vec2 anchor, MoveWhat what)
    : m_pressed(pressed), m_anchor(anchor), m_what(what) {
  const auto selected = context.selection.ids();
  if (what == MoveWhat::Copies) {
    m_ids.assign(selected.begin(), selected.end());
  } else {
    m_ids = movableIds(context.document.committed(), selected);
  }
}

glm::vec2 MoveDrag::deltaFor(const ToolContext& context, const PointerEvent& pointer) const {
  const glm::vec2 way = m_lock == AxisLock::X   ? glm::vec2(1.0f, 0.0f)
                        : m_lock == AxisLock::Z ? glm::vec2(0.0f, 1.0f)
                                                : glm::vec2(0.0f);
  if (const auto distance = m_number.value()) {
    if (m_lock != AxisLock::None) return *distance * way;
    const float length = glm::length(m_free);
    return *distance * (length > 1e-4f ? m_free / length : glm::vec2(1.0f, 0.0f));
  }
  const glm::vec2 snapped = snapToGrid(context.settings.snap, m_anchor + m_free, pointer.modifiers) - m_anchor;
  return m_lock == AxisLock::None ? snapped : snapped * way;
}

std::optional<Edit> MoveDrag::make(const ToolContext& context) {
  const Project& project = context.document.committed();
  if (m_delta == glm::vec2(0.0f)) return std::nullopt;
  if (m_what == MoveWhat::Copies) {
    DuplicateResult copies = duplicateEdit(project, m_ids, m_delta);
    m_copies = std::move(copies.ids);
    return std::move(copies.edit);
  }
  return moveEdit(project, m_ids, m_delta);
}

std::optional<Edit> MoveDrag::update(ToolContext& context, const PointerEvent& pointer) {
  // Over the sky there is no place to move to: it stays where it was.
  if (const auto place = context.groundAt(pointer.pixel)) m_free = *place - m_pressed;
  m_pixel = pointer.pixel;
  m_delta = deltaFor(context, pointer);
  return make(context);
}

std::optional<Edit> MoveDrag::end(ToolContext& context) {
  return make(context);
}

void MoveDrag::applied(ToolContext& context) {
  if (m_what == MoveWhat::Copies) context.selection.replace(m_copies);
}

bool MoveDrag::onKey(ToolContext&, const KeyPress& press) {
  if (press.key == Key::Enter || press.key == Key::NumpadEnter) {
    m_finished = true;
    return true;
  }
  if (!press.modifiers.any() && (press.key == Key::X || press.key == Key::Z)) {
    const AxisLock lock = press.key == Key::X ? AxisLock::X : AxisLock::Z;
    m_lock = m_lock == lock ? AxisLock::None : lock;
    return true;
  }
  return m_number.onKey(press);
}

void MoveDrag::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  constexpr float kReach = 2000.0f;
  if (m_lock != AxisLock::None) {
    const bool x = m_lock == AxisLock::X;
    const glm::vec3 middle = context.ground.lift(m_anchor);
    const glm::vec3 way = x ? glm::vec3(kReach, 0.0f, 0.0f) : glm::vec3(0.0f, 0.0f, kReach);
    shapes.lines.push_back({middle - way, middle + way, x ? ShapeRole::AxisX : ShapeRole::AxisZ});
  }
  shapes.lines.push_back({context.ground.lift(m_anchor), context.ground.lift(m_anchor + m_delta), ShapeRole::Guide});
  const double length = static_cast<double>(glm::length(m_delta));
  std::string text = m_number.empty() ? fixed(length, 2) + " m" : m_number.text() + " m";
  text += "  (" + fixed(static_cast<double>(m_delta.x), 2) + ", " + fixed(static_cast<double>(m_delta.y), 2) + ")";
  shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f), std::move(text)});
}

std::string MoveDrag::hint(const ToolContext&) const {
  return "X or Z locks the axis, type a distance + Enter, Ctrl snaps to the grid, Esc cancels";
}

}  // namespace windloom::editor
