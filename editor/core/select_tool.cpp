#include "editor/core/select_tool.hpp"

#include <algorithm>

#include "editor/core/box_drag.hpp"
#include "editor/core/graph_edits.hpp"
#include "editor/core/move_drag.hpp"
#include "editor/core/refusal.hpp"
#include "editor/core/transform_drag.hpp"

namespace windloom::editor {
namespace {

/// The place of a handle on the ground; the grabbed place itself for arrows.
glm::vec2 handlePlace(const Project& project, const Hit& hit, glm::vec2 pressed) {
  if (const Point* point = findPoint(*project.graph, hit.id)) return point->position;
  if (const Obstacle* obstacle = findObstacle(project, hit.id)) return obstacle->centre;
  if (const Collider* collider = findCollider(project, hit.id)) return collider->position;
  if (const Surface* surface = findSurface(project, hit.id)) return surface->position;
  if (const Rotor* rotor = findRotor(project, hit.id)) return rotor->position;
  if (const Probe* probe = findProbe(project, hit.id)) return probe->position;
  return pressed;
}

/// The drag of a handle of a thing's own.
std::unique_ptr<Drag> dragOfObject(const Project& project, const Grip& grip) {
  switch (kindOf(project, grip.object).value_or(ObjectKind::Obstacle)) {
    case ObjectKind::Collider:
      return makeColliderDrag(grip);
    case ObjectKind::Surface:
      return makeSurfaceDrag(grip);
    case ObjectKind::Rotor:
      return makeRotorDrag(grip);
    default:
      return makeOutlineDrag(grip);
  }
}

}  // namespace

bool insertPointAt(ToolContext& context, glm::vec2 pixel, std::string& message) {
  const std::vector<Hit> hits = context.hits(pixel, onlyGraph());
  // A point right under the pointer is meant itself.
  if (hits.empty() || hits.front().kind != ObjectKind::Arrow) return false;
  const InsertResult inserted = insertPointEdit(context.document.committed(), hits.front().id, hits.front().along);
  const Status status = context.document.apply(inserted.edit);
  if (status) {
    context.selection.replace(inserted.point);
  } else {
    message = refusalText(status.error());
  }
  return true;
}

std::string SelectTool::id() const {
  switch (m_kind) {
    case SelectKind::Select:
      return "select";
    case SelectKind::Move:
      return "move";
    case SelectKind::Rotate:
      return "rotate";
    case SelectKind::Scale:
      return "scale";
  }
  return {};
}

std::string SelectTool::label() const {
  switch (m_kind) {
    case SelectKind::Select:
      return "Select";
    case SelectKind::Move:
      return "Move";
    case SelectKind::Rotate:
      return "Rotate";
    case SelectKind::Scale:
      return "Scale";
  }
  return {};
}

std::string SelectTool::hint(const ToolContext&) const {
  if (m_hot) return gripHint(*m_hot);
  switch (m_kind) {
    case SelectKind::Select:
      return "Click selects, Shift adds, Ctrl toggles, drag moves, drag on empty ground draws a box, "
             "Ctrl+click on an arrow inserts a point, Alt+drag copies";
    case SelectKind::Move:
      return "Drag moves the selection, then X or Z locks the axis, numbers + Enter set the distance";
    case SelectKind::Rotate:
      return "Drag turns the selection around its middle, numbers + Enter set the angle";
    case SelectKind::Scale:
      return "Drag away from the middle of the selection or towards it, then X or Z locks the axis";
  }
  return {};
}

PointerShape SelectTool::pointerShape() const {
  return m_kind == SelectKind::Select ? PointerShape::Arrow : PointerShape::Move;
}

void SelectTool::onClick(ToolContext& context, const PointerEvent& pointer) {
  const Modifiers held = pointer.modifiers;
  const std::optional<Grip> grip = held.any() ? std::nullopt : gripAt(context, m_kind, pointer.pixel);
  m_corner.reset();
  if (grip && grip->kind == GripKind::Corner) {
    m_corner = grip;
    return;
  }
  if (held.ctrl && !held.shift) {
    std::string message;
    const bool inserted =
        insertPointAt(context, pointer.pixel, message) || insertCornerAt(context, pointer.pixel, message);
    if (!message.empty()) say(std::move(message));
    if (inserted) return;
  }
  const std::vector<Hit> hits = context.hits(pointer.pixel);
  const SelectMode mode = selectMode(held);
  if (hits.empty()) {
    if (mode == SelectMode::Replace) context.selection.clear();
    m_lastClick.reset();
    return;
  }
  constexpr float kSamePlacePx = 4.0f;
  const bool again = m_lastClick && glm::distance(*m_lastClick, pointer.pixel) <= kSamePlacePx;
  m_lastClick = pointer.pixel;
  const Id id = again && mode == SelectMode::Replace ? cycleHit(hits, context.selection.active()) : hits.front().id;
  select(context.selection, std::span(&id, 1), mode);
}

std::unique_ptr<Drag> SelectTool::transform(ToolContext& context, const PointerEvent& press, const Hit* grabbed) {
  const auto place = context.groundAt(press.pixel);
  if (!place) return nullptr;
  const Project& project = context.document.committed();
  if (m_kind == SelectKind::Rotate || m_kind == SelectKind::Scale) {
    const auto pivot = pivotOf(project, context.selection.ids());
    if (!pivot) return nullptr;
    const TransformKind kind = m_kind == SelectKind::Rotate ? TransformKind::Rotate : TransformKind::Scale;
    return std::make_unique<TransformDrag>(context, kind, *pivot, *place);
  }
  const glm::vec2 anchor =
      grabbed ? handlePlace(project, *grabbed, *place) : pivotOf(project, context.selection.ids()).value_or(*place);
  return std::make_unique<MoveDrag>(context, *place, anchor,
                                    press.modifiers.alt ? MoveWhat::Copies : MoveWhat::Selection);
}

std::unique_ptr<Drag> SelectTool::dragGrip(ToolContext& context, const PointerEvent& press, const Grip& grip) {
  if (grip.object != 0) return dragOfObject(context.document.committed(), grip);
  const auto place = context.groundAt(press.pixel);
  const auto pivot = pivotOf(context.document.committed(), context.selection.ids());
  if (!place || !pivot) return nullptr;
  const AxisLock lock = grip.kind == GripKind::AxisX   ? AxisLock::X
                        : grip.kind == GripKind::AxisZ ? AxisLock::Z
                                                       : AxisLock::None;
  if (m_kind == SelectKind::Move) return std::make_unique<MoveDrag>(context, *place, *pivot, MoveWhat::Selection, lock);
  const TransformKind kind = m_kind == SelectKind::Rotate ? TransformKind::Rotate : TransformKind::Scale;
  return std::make_unique<TransformDrag>(context, kind, *pivot, *place, lock);
}

void SelectTool::onHover(ToolContext& context, const PointerEvent& pointer) {
  m_hot = pointer.modifiers.alt || pointer.modifiers.shift ? std::nullopt : gripAt(context, m_kind, pointer.pixel);
}

bool SelectTool::onKey(ToolContext& context, const KeyPress& press) {
  if (press.modifiers.any() || (press.key != Key::Delete && press.key != Key::X)) return false;
  const std::optional<Grip> corner = m_hot && m_hot->kind == GripKind::Corner ? m_hot : m_corner;
  if (!corner || context.selection.active() != corner->object) return false;
  // Undo may have changed the corners since: only the one that was meant goes.
  const std::vector<Grip> grips = gripsOf(context, m_kind);
  const auto same = std::ranges::find(grips, *corner);
  if (same == grips.end() || same->place != corner->place) return false;
  const Edit edit = removeCornerEdit(context.document.committed(), corner->object, corner->index);
  if (edit.steps.empty()) return false;
  m_hot.reset();
  m_corner.reset();
  commit(context, edit);
  return true;
}

void SelectTool::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  addGripShapes(context, m_kind, m_hot ? m_hot : m_corner, shapes);
}

std::unique_ptr<Drag> SelectTool::beginDrag(ToolContext& context, const PointerEvent& press) {
  m_lastClick.reset();
  m_corner.reset();
  if (!press.modifiers.alt && !press.modifiers.shift) {
    if (const auto grip = gripAt(context, m_kind, press.pixel)) return dragGrip(context, press, *grip);
  }
  const std::vector<Hit> hits = context.hits(press.pixel);
  if (hits.empty()) {
    const bool grabsAnywhere = m_kind != SelectKind::Select && !context.selection.empty() && !press.modifiers.any();
    if (grabsAnywhere) return transform(context, press, nullptr);
    return std::make_unique<BoxDrag>(context, press);
  }
  // Of several things at one place the selected one is meant, but with the select tool no handle hides behind a line
  // or an outline.
  const auto selected = std::find_if(hits.begin(), hits.end(), [&](const Hit& hit) {
    return context.selection.contains(hit.id) &&
           (m_kind != SelectKind::Select || hit.isHandle() || !hits.front().isHandle());
  });
  const Hit grabbed = selected != hits.end() ? *selected : hits.front();
  if (selected == hits.end()) {
    select(context.selection, std::span(&grabbed.id, 1), press.modifiers.shift ? SelectMode::Add : SelectMode::Replace);
  }
  return transform(context, press, &grabbed);
}

}  // namespace windloom::editor
