#include "editor/core/obstacle_tool.hpp"

#include <algorithm>

#include "editor/core/centre_drag.hpp"
#include "editor/core/object_edits.hpp"
#include "editor/core/snapping.hpp"
#include "engine/core/text.hpp"
#include "engine/model/outline.hpp"

namespace windloom::editor {
namespace {

constexpr float kMinObstacleM = 0.05f;

bool toggleShape(ToolContext& context, const KeyPress& press) {
  if (press.key != Key::C || press.modifiers.any()) return false;
  ObstacleShape& shape = context.settings.newObstacle.shape;
  shape = shape == ObstacleShape::Box ? ObstacleShape::Circle : ObstacleShape::Box;
  return true;
}

class ObstacleDrag : public CentreDrag {
 public:
  using CentreDrag::CentreDrag;
  bool onKey(ToolContext& context, const KeyPress& press) override { return toggleShape(context, press); }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override {
    shapes.lines.push_back({context.ground.lift(m_centre), context.ground.lift(m_place), ShapeRole::Guide});
    const glm::vec2 half = glm::abs(m_place - m_centre);
    const auto metres = [](float value) { return fixed(static_cast<double>(value), 2); };
    const bool circle = context.settings.newObstacle.shape != ObstacleShape::Box;
    shapes.labels.push_back(
        {m_pixel + glm::vec2(16.0f, 16.0f), circle ? "radius " + metres(glm::length(half)) + " m"
                                                   : metres(2.0f * half.x) + " x " + metres(2.0f * half.y) + " m"});
  }
  [[nodiscard]] std::string hint(const ToolContext&) const override {
    return "Release to set the size. C: circle or box, Ctrl snaps to the grid, Esc cancels";
  }

 private:
  std::optional<Edit> make(const ToolContext& context) override {
    Obstacle obstacle = context.settings.newObstacle;
    const glm::vec2 half = glm::abs(m_place - m_centre);
    obstacle.centre = m_centre;
    if (obstacle.shape != ObstacleShape::Box) {
      obstacle.shape = ObstacleShape::Circle;
      obstacle.radius = glm::length(half);
      if (obstacle.radius < kMinObstacleM) return std::nullopt;
    } else {
      obstacle.size = 2.0f * half;
      obstacle.rotation = 0.0f;
      if (std::min(obstacle.size.x, obstacle.size.y) < kMinObstacleM) return std::nullopt;
    }
    AddResult added = addObstacleEdit(context.document.committed(), std::move(obstacle));
    m_made = added.id;
    return std::move(added.edit);
  }
};

}  // namespace

Obstacle polygonOf(const std::vector<glm::vec2>& corners, Obstacle model) {
  model.shape = ObstacleShape::Polygon;
  model.centre = centroidOf(corners);
  model.rotation = 0.0f;
  model.points.clear();
  for (const glm::vec2 corner : corners) model.points.push_back(corner - model.centre);
  return model;
}

std::string ObstacleTool::hint(const ToolContext& context) const {
  if (!m_corners.empty())
    return "Click for the next corner; Enter, right click or the first corner closes, Backspace takes one back, Esc "
           "cancels";
  const bool circle = context.settings.newObstacle.shape != ObstacleShape::Box;
  return std::string("Drag a ") + (circle ? "circle" : "box") +
         " from its centre outwards (C: " + (circle ? "box" : "circle") + "), or click the corners of a polygon";
}

std::optional<glm::vec2> ObstacleTool::cornerAt(const ToolContext& context, const PointerEvent& pointer) const {
  const auto place = context.groundAt(pointer.pixel);
  if (!place) return std::nullopt;
  if (m_corners.empty()) return snapToGrid(context.settings.snap, *place, pointer.modifiers);
  return snapEnd(context.settings.snap, m_corners.back(), *place, pointer.modifiers);
}

bool ObstacleTool::onFirstCorner(const ToolContext& context, glm::vec2 pixel) const {
  if (m_corners.size() < kMinCorners) return false;
  const auto first = context.view.groundToScreen(m_corners.front(), context.ground);
  return first && glm::distance(*first, pixel) <= context.settings.hitRadiusPx;
}

void ObstacleTool::onClick(ToolContext& context, const PointerEvent& pointer) {
  if (onFirstCorner(context, pointer.pixel)) return finish(context);
  const auto corner = cornerAt(context, pointer);
  if (!corner) return;
  if (!m_corners.empty() && glm::distance(m_corners.back(), *corner) < kMinObstacleM) {
    // The same place again: a double click closes.
    if (pointer.clicks > 1) finish(context);
    return;
  }
  if (m_corners.size() == kMaxCorners) return say("A polygon has at most " + std::to_string(kMaxCorners) + " corners");
  m_corners.push_back(*corner);
  m_hover.reset();
}

std::unique_ptr<Drag> ObstacleTool::beginDrag(ToolContext& context, const PointerEvent& press) {
  if (!m_corners.empty()) {
    // A press that slips still sets the next corner.
    onClick(context, press);
    return nullptr;
  }
  const auto place = context.groundAt(press.pixel);
  if (!place) return nullptr;
  return std::make_unique<ObstacleDrag>(snapToGrid(context.settings.snap, *place, press.modifiers));
}

void ObstacleTool::onHover(ToolContext& context, const PointerEvent& pointer) {
  m_pixel = pointer.pixel;
  m_closes = onFirstCorner(context, pointer.pixel);
  m_hover = m_corners.empty() ? std::nullopt : cornerAt(context, pointer);
}

bool ObstacleTool::onKey(ToolContext& context, const KeyPress& press) {
  if (m_corners.empty()) return toggleShape(context, press);
  if (press.key == Key::Enter || press.key == Key::NumpadEnter) {
    finish(context);
    return true;
  }
  if (press.key != Key::Backspace) return false;
  m_corners.pop_back();
  return true;
}

void ObstacleTool::finish(ToolContext& context) {
  const std::vector<glm::vec2> corners = std::exchange(m_corners, {});
  m_hover.reset();
  if (corners.size() < kMinCorners) return say("A polygon needs three corners or more");
  AddResult added = addObstacleEdit(context.document.committed(), polygonOf(corners, context.settings.newObstacle));
  if (commit(context, added.edit)) context.selection.replace(added.id);
}

void ObstacleTool::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  if (m_corners.empty()) return;
  std::vector<glm::vec2> corners = m_corners;
  if (m_hover && !m_closes) corners.push_back(*m_hover);
  const bool open = corners.size() < kMinCorners;
  const ShapeRole role = open || !polygonProblem(corners) ? ShapeRole::Preview : ShapeRole::Refused;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i)
    shapes.lines.push_back({context.ground.lift(corners[i]), context.ground.lift(corners[i + 1]), role, true});
  // How it would be closed now.
  if (!open)
    shapes.lines.push_back({context.ground.lift(corners.back()), context.ground.lift(corners.front()),
                            role == ShapeRole::Refused ? role : ShapeRole::Guide});
  for (const glm::vec2 corner : m_corners) shapes.dots.push_back({context.ground.lift(corner), ShapeRole::Preview});
  if (m_closes) shapes.dots.push_back({context.ground.lift(m_corners.front()), ShapeRole::Snap});
  if (m_hover && !m_closes)
    shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f),
                             fixed(static_cast<double>(glm::distance(m_corners.back(), *m_hover)), 2) + " m"});
}

}  // namespace windloom::editor
