#include "editor/core/place_tools.hpp"

#include <algorithm>

#include "editor/core/object_edits.hpp"
#include "editor/core/snapping.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

constexpr float kMinObstacleM = 0.05f;

bool toggleShape(ToolContext& context, const KeyPress& press) {
  if (press.key != Key::C || press.modifiers.any()) return false;
  ObstacleShape& shape = context.settings.newObstacle.shape;
  shape = shape == ObstacleShape::Circle ? ObstacleShape::Box : ObstacleShape::Circle;
  return true;
}

class ObstacleDrag : public Drag {
 public:
  explicit ObstacleDrag(glm::vec2 centre) : m_centre(centre), m_place(centre) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    m_pixel = pointer.pixel;
    if (const auto place = context.groundAt(pointer.pixel)) {
      m_place = snapToGrid(context.settings.snap, *place, pointer.modifiers);
    }
    return make(context);
  }
  std::optional<Edit> end(ToolContext& context) override { return make(context); }
  void applied(ToolContext& context) override { context.selection.replace(m_id); }
  bool onKey(ToolContext& context, const KeyPress& press) override { return toggleShape(context, press); }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override {
    shapes.lines.push_back({context.ground.lift(m_centre), context.ground.lift(m_place), ShapeRole::Guide});
    const glm::vec2 half = glm::abs(m_place - m_centre);
    const auto metres = [](float value) { return fixed(static_cast<double>(value), 2); };
    const bool circle = context.settings.newObstacle.shape == ObstacleShape::Circle;
    shapes.labels.push_back(
        {m_pixel + glm::vec2(16.0f, 16.0f), circle ? "radius " + metres(glm::length(half)) + " m"
                                                   : metres(2.0f * half.x) + " x " + metres(2.0f * half.y) + " m"});
  }
  [[nodiscard]] std::string hint(const ToolContext&) const override {
    return "Release to set the size. C: circle or box, Ctrl snaps to the grid, Esc cancels";
  }

 private:
  std::optional<Edit> make(const ToolContext& context) {
    Obstacle obstacle = context.settings.newObstacle;
    const glm::vec2 half = glm::abs(m_place - m_centre);
    obstacle.centre = m_centre;
    if (obstacle.shape == ObstacleShape::Circle) {
      obstacle.radius = glm::length(half);
      if (obstacle.radius < kMinObstacleM) return std::nullopt;
    } else {
      obstacle.size = 2.0f * half;
      obstacle.rotation = 0.0f;
      if (std::min(obstacle.size.x, obstacle.size.y) < kMinObstacleM) return std::nullopt;
    }
    AddResult added = addObstacleEdit(context.document.committed(), std::move(obstacle));
    m_id = added.id;
    return std::move(added.edit);
  }

  glm::vec2 m_centre, m_place;
  glm::vec2 m_pixel{0.0f};
  Id m_id = 0;
};

class ProbeDrag : public Drag {
 public:
  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    if (const auto place = context.groundAt(pointer.pixel)) {
      m_place = snapToGrid(context.settings.snap, *place, pointer.modifiers);
    }
    return make(context);
  }
  std::optional<Edit> end(ToolContext& context) override { return make(context); }
  void applied(ToolContext& context) override { context.selection.replace(m_id); }
  [[nodiscard]] std::string hint(const ToolContext&) const override { return "Release to set the probe down"; }

 private:
  std::optional<Edit> make(const ToolContext& context) {
    if (!m_place) return std::nullopt;
    Probe probe = context.settings.newProbe;
    probe.position = *m_place;
    AddResult added = addProbeEdit(context.document.committed(), std::move(probe));
    m_id = added.id;
    return std::move(added.edit);
  }

  std::optional<glm::vec2> m_place;
  Id m_id = 0;
};

class DeleteDrag : public Drag {
 public:
  explicit DeleteDrag(glm::vec2 pressed) : m_last(pressed) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    // A fast sweep must not jump over a handle.
    const float step = std::max(1.0f, 0.5f * context.settings.hitRadiusPx);
    const int steps = std::clamp(static_cast<int>(glm::distance(m_last, pointer.pixel) / step) + 1, 1, 200);
    for (int i = 0; i <= steps; ++i) {
      const glm::vec2 pixel = glm::mix(m_last, pointer.pixel, static_cast<float>(i) / static_cast<float>(steps));
      for (const Hit& hit : context.hits(pixel)) {
        if (hit.inside || std::find(m_ids.begin(), m_ids.end(), hit.id) != m_ids.end()) continue;
        m_ids.push_back(hit.id);
        break;
      }
    }
    m_last = pointer.pixel;
    return end(context);
  }
  std::optional<Edit> end(ToolContext& context) override {
    if (m_ids.empty()) return std::nullopt;
    return deleteEdit(context.document.committed(), m_ids);
  }
  void applied(ToolContext& context) override { context.selection.repair(context.document.project()); }
  [[nodiscard]] std::string hint(const ToolContext&) const override { return "Sweep over what to delete, Esc cancels"; }

 private:
  glm::vec2 m_last;
  std::vector<Id> m_ids;
};

}  // namespace

std::string ObstacleTool::hint(const ToolContext& context) const {
  const bool circle = context.settings.newObstacle.shape == ObstacleShape::Circle;
  return std::string("Drag a ") + (circle ? "circle" : "box") +
         " from its centre outwards. C: " + (circle ? "box" : "circle");
}

std::unique_ptr<Drag> ObstacleTool::beginDrag(ToolContext& context, const PointerEvent& press) {
  const auto place = context.groundAt(press.pixel);
  if (!place) return nullptr;
  return std::make_unique<ObstacleDrag>(snapToGrid(context.settings.snap, *place, press.modifiers));
}

bool ObstacleTool::onKey(ToolContext& context, const KeyPress& press) {
  return toggleShape(context, press);
}

std::string ProbeTool::hint(const ToolContext&) const {
  return "Click where the wind is to be watched";
}

void ProbeTool::onClick(ToolContext& context, const PointerEvent& pointer) {
  ProbeDrag drag;
  const auto edit = drag.update(context, pointer);
  if (edit && commit(context, *edit)) drag.applied(context);
}

std::unique_ptr<Drag> ProbeTool::beginDrag(ToolContext&, const PointerEvent&) {
  return std::make_unique<ProbeDrag>();
}

std::string DeleteTool::hint(const ToolContext&) const {
  return "Click deletes, a drag deletes all that it sweeps over";
}

void DeleteTool::onClick(ToolContext& context, const PointerEvent& pointer) {
  const std::vector<Hit> hits = context.hits(pointer.pixel);
  if (hits.empty()) return;
  commit(context, deleteEdit(context.document.committed(), std::span(&hits.front().id, 1)));
  context.selection.repair(context.document.project());
}

std::unique_ptr<Drag> DeleteTool::beginDrag(ToolContext&, const PointerEvent& press) {
  return std::make_unique<DeleteDrag>(press.pixel);
}

}  // namespace windloom::editor
