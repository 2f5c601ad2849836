// Dragging the handles of an obstacle's outline, and edits of a polygon's corners.
#include <algorithm>
#include <cmath>

#include "editor/core/axis_lock.hpp"
#include "editor/core/refusal.hpp"
#include "editor/core/shape_drag.hpp"
#include "engine/core/text.hpp"
#include "engine/model/outline.hpp"

namespace windloom::editor {
namespace {

constexpr float kMinSizeM = 0.05f;

/// Moves one side of a box; the opposite one stays where it is.
void moveSide(Obstacle& obstacle, int index, float length) {
  const int axis = index / 2;
  const float sign = index % 2 == 0 ? -1.0f : 1.0f;
  glm::vec2 shift(0.0f);
  shift[axis] = sign * 0.5f * (length - obstacle.size[axis]);
  obstacle.centre = toWorld(obstacle, shift);
  obstacle.size[axis] = length;
}

class OutlineDrag : public ShapeDrag {
 public:
  using ShapeDrag::ShapeDrag;

  bool onKey(ToolContext& context, const KeyPress& press) override {
    const bool enter = press.key == Key::Enter || press.key == Key::NumpadEnter;
    if (m_grip.kind == GripKind::Corner && !enter) return toggleLock(m_lock, press);
    return ShapeDrag::onKey(context, press);
  }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override {
    addLockLine(shapes, context.ground, m_lock, m_grip.place);
    ShapeDrag::shapes(context, shapes);
  }
  [[nodiscard]] std::string hint(const ToolContext& context) const override {
    if (m_grip.kind == GripKind::Corner) return "X or Z locks the axis, Ctrl snaps to the grid, Esc cancels";
    return ShapeDrag::hint(context);
  }

 private:
  std::optional<Edit> make(const ToolContext& context) override {
    const Obstacle* before = findObstacle(context.document.committed(), m_grip.object);
    const bool corner = m_grip.kind == GripKind::Corner;
    if (!before || (corner && m_grip.index >= static_cast<int>(before->points.size()))) return std::nullopt;
    Obstacle obstacle = *before;
    change(context, obstacle);
    if (obstacle == *before) return std::nullopt;
    Edit edit;
    edit.label = m_grip.kind == GripKind::Corner ? "Move corner" : "Shape obstacle";
    edit.steps.emplace_back(Put<Obstacle>{std::move(obstacle)});
    return edit;
  }

  void change(const ToolContext& context, Obstacle& obstacle) {
    const SnapSettings& snap = context.settings.snap;
    const glm::vec2 snapped = snapToGrid(snap, m_place, m_held);
    const auto typed = m_number.value();
    const auto metres = [&](float value) { return std::max(kMinSizeM, typed ? *typed : value); };
    const auto text = [](float value) { return fixed(static_cast<double>(value), 2) + " m"; };
    switch (m_grip.kind) {
      case GripKind::Radius:
        obstacle.radius = metres(glm::distance(snapped, obstacle.centre));
        m_text = "radius " + text(obstacle.radius);
        break;
      case GripKind::Side: {
        const float at = toOwn(obstacle, snapped)[m_grip.index / 2];
        const float half = 0.5f * obstacle.size[m_grip.index / 2];
        moveSide(obstacle, m_grip.index, metres(m_grip.index % 2 == 0 ? half - at : at + half));
        m_text = text(obstacle.size[m_grip.index / 2]);
        break;
      }
      case GripKind::Turn: {
        const glm::vec2 way = m_place - obstacle.centre;
        const float angle = glm::degrees(std::atan2(way.y, way.x));
        obstacle.rotation = std::remainder(typed ? *typed : snapAngle(snap, angle, m_held), 360.0f);
        m_text = fixed(static_cast<double>(obstacle.rotation), 1) + " deg";
        break;
      }
      case GripKind::Corner: {
        const glm::vec2 axis = axisOf(m_lock), from = m_grip.place;
        const glm::vec2 place = m_lock == AxisLock::None ? snapped : from + (snapped - from) * axis;
        obstacle.points[static_cast<std::size_t>(m_grip.index)] = toOwn(obstacle, place);
        m_text = text(place.x) + ", " + text(place.y);
        break;
      }
      default:
        break;
    }
  }

  AxisLock m_lock = AxisLock::None;
};

float toSide(glm::vec2 place, glm::vec2 a, glm::vec2 b, float& part) {
  const glm::vec2 ab = b - a;
  part = std::clamp(glm::dot(place - a, ab) / std::max(glm::dot(ab, ab), 1e-12f), 0.0f, 1.0f);
  return glm::distance(place, a + part * ab);
}

}  // namespace

std::unique_ptr<Drag> makeOutlineDrag(const Grip& grip) {
  return std::make_unique<OutlineDrag>(grip);
}

bool insertCornerAt(ToolContext& context, glm::vec2 pixel, std::string& message) {
  const auto place = context.groundAt(pixel);
  const std::vector<Hit> hits = context.hits(pixel);
  if (!place || hits.empty() || hits.front().kind != ObjectKind::Obstacle || hits.front().inside) return false;
  const Obstacle* found = findObstacle(context.document.committed(), hits.front().id);
  if (!found || found->shape != ObstacleShape::Polygon) return false;
  Obstacle obstacle = *found;
  const glm::vec2 own = toOwn(obstacle, *place);
  std::size_t side = 0;
  float nearest = 1e30f;
  glm::vec2 corner = own;
  for (std::size_t i = 0; i < obstacle.points.size(); ++i) {
    const glm::vec2 a = obstacle.points[i], b = obstacle.points[(i + 1) % obstacle.points.size()];
    float part = 0.0f;
    const float distance = toSide(own, a, b, part);
    if (distance >= nearest) continue;
    nearest = distance;
    side = i;
    corner = glm::mix(a, b, std::clamp(part, 0.05f, 0.95f));
  }
  obstacle.points.insert(obstacle.points.begin() + static_cast<std::ptrdiff_t>(side) + 1, corner);
  Edit edit;
  edit.label = "Insert corner";
  edit.steps.emplace_back(Put<Obstacle>{std::move(obstacle)});
  if (const Status status = context.document.apply(edit); !status) message = refusalText(status.error());
  context.selection.replace(hits.front().id);
  return true;
}

Edit removeCornerEdit(const Project& project, Id id, int corner) {
  Edit edit;
  edit.label = "Delete corner";
  const Obstacle* found = findObstacle(project, id);
  if (!found || corner < 0 || corner >= static_cast<int>(found->points.size())) return edit;
  Obstacle obstacle = *found;
  obstacle.points.erase(obstacle.points.begin() + corner);
  edit.steps.emplace_back(Put<Obstacle>{std::move(obstacle)});
  return edit;
}

}  // namespace windloom::editor
