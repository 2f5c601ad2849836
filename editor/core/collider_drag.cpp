// Dragging the handles of a collider.
#include <algorithm>
#include <cmath>

#include "editor/core/shape_drag.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

constexpr float kMinRadiusM = 0.01f;

class ColliderDrag : public ShapeDrag {
 public:
  using ShapeDrag::ShapeDrag;

 private:
  std::optional<Edit> make(const ToolContext& context) override {
    const Collider* before = findCollider(context.document.committed(), m_grip.object);
    if (!before) return std::nullopt;
    Collider collider = *before;
    const auto typed = m_number.value();
    if (m_grip.kind == GripKind::Radius) {
      collider.radius = std::max(kMinRadiusM, typed ? *typed : distance(context));
      m_text = "radius " + fixed(static_cast<double>(collider.radius), 2) + " m";
    } else {
      const glm::vec2 way = m_place - m_grip.pivot;
      const float angle = glm::degrees(std::atan2(way.y, way.x));
      collider.rotation = std::remainder(typed ? *typed : snapAngle(context.settings.snap, angle, m_held), 360.0f);
      m_text = fixed(static_cast<double>(collider.rotation), 1) + " deg";
    }
    if (collider == *before) return std::nullopt;
    return Edit{.label = "Shape collider", .steps = {Put<Collider>{std::move(collider)}}, .mergeKey = {}};
  }
};

}  // namespace

std::unique_ptr<Drag> makeColliderDrag(const Grip& grip) {
  return std::make_unique<ColliderDrag>(grip);
}

}  // namespace windloom::editor
