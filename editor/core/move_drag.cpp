#include "editor/core/move_drag.hpp"

#include <algorithm>

#include "editor/core/object_edits.hpp"
#include "editor/core/snapping.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {

MoveDrag::MoveDrag(const ToolContext& context, glm::vec2 pressed, glm::vec2 anchor, MoveWhat what, AxisLock lock)
    : m_pressed(pressed), m_anchor(anchor), m_what(what), m_lock(lock) {
  const auto selected = context.selection.ids();
  if (what == MoveWhat::Copies) {
    m_ids.assign(selected.begin(), selected.end());
  } else {
    m_ids = movableIds(context.document.committed(), selected);
    for (const Id id : m_ids) {
      const Point* point = findPoint(*context.document.committed().graph, id);
      if (point && point->position == anchor) m_anchorPoint = id;
    }
  }
}

/// A point that stays where it is.
const Point* MoveDrag::pointUnder(const ToolContext& context, glm::vec2 pixel) const {
  if (!context.settings.snap.points || m_anchorPoint == 0) return nullptr;
  PickOptions options = onlyPoints();
  options.radiusPx = context.settings.hitRadiusPx;
  const Project& project = context.document.committed();
  for (const Hit& hit : pick(project, context.view, context.ground, pixel, options)) {
    if (std::find(m_ids.begin(), m_ids.end(), hit.id) == m_ids.end()) return findPoint(*project.graph, hit.id);
  }
  return nullptr;
}

glm::vec2 MoveDrag::deltaFor(const ToolContext& context, const PointerEvent& pointer) {
  const glm::vec2 way = axisOf(m_lock);
  m_snapped = 0;
  if (const auto distance = m_number.value()) {
    if (m_lock != AxisLock::None) return *distance * way;
    const float length = glm::length(m_free);
    return *distance * (length > 1e-4f ? m_free / length : glm::vec2(1.0f, 0.0f));
  }
  if (const Point* target = m_lock == AxisLock::None ? pointUnder(context, pointer.pixel) : nullptr) {
    m_snapped = target->id;
    return target->position - m_anchor;
  }
  const glm::vec2 snapped = snapEnd(context.settings.snap, m_anchor, m_anchor + m_free, pointer.modifiers) - m_anchor;
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
  if (const auto way = pointerWay(context, m_lock, pointer.pixel, m_pressed, m_anchor)) m_free = *way;
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
  return toggleLock(m_lock, press) || m_number.onKey(press);
}

void MoveDrag::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  addLockLine(shapes, context.ground, m_lock, m_anchor);
  if (m_snapped != 0) shapes.dots.push_back({context.ground.lift(m_anchor + m_delta), ShapeRole::Snap});
  shapes.lines.push_back({context.ground.lift(m_anchor), context.ground.lift(m_anchor + m_delta), ShapeRole::Guide});
  const double length = static_cast<double>(glm::length(m_delta));
  std::string text = m_number.empty() ? fixed(length, 2) + " m" : m_number.text() + " m";
  text += "  (" + fixed(static_cast<double>(m_delta.x), 2) + ", " + fixed(static_cast<double>(m_delta.y), 2) + ")";
  shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f), std::move(text)});
}

std::string MoveDrag::hint(const ToolContext&) const {
  if (m_snapped != 0) return "On a point: release, then Ctrl+J merges the two";
  return "X or Z locks the axis, type a distance + Enter, Ctrl snaps to the grid, Esc cancels";
}

}  // namespace windloom::editor
