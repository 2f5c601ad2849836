// Dragging the handles of a surface or a rotor.
#include <algorithm>
#include <cmath>

#include "editor/core/shape_drag.hpp"
#include "editor/core/surface_shape.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

std::string metres(float value) {
  return fixed(static_cast<double>(value), 2) + " m";
}

class SurfaceDrag : public ShapeDrag {
 public:
  using ShapeDrag::ShapeDrag;

 private:
  std::optional<Edit> make(const ToolContext& context) override {
    const Surface* before = findSurface(context.document.committed(), m_grip.object);
    if (!before) return std::nullopt;
    Surface surface = *before;
    if (m_grip.kind == GripKind::Radius) {
      resize(surface, distance(context) / std::max(1e-4f, boxOf(*before).high.x));
    } else {
      const glm::vec2 way = m_place - m_grip.pivot;
      const float angle = snapAngle(context.settings.snap, glm::degrees(std::atan2(way.y, way.x)), m_held);
      surface.rotation = std::remainder(m_number.value().value_or(angle), 360.0f);
      m_text = fixed(static_cast<double>(surface.rotation), 1) + " deg";
    }
    if (surface == *before) return std::nullopt;
    return Edit{.label = "Shape surface", .steps = {Put<Surface>{std::move(surface)}}, .mergeKey = {}};
  }

  void resize(Surface& surface, float factor) {
    constexpr float kMinSizeM = 0.05f, kMinScale = 0.0001f;
    const auto typed = m_number.value();
    if (surface.shape == SurfaceShape::Mesh) {
      surface.scale = std::max(kMinScale, typed ? *typed : surface.scale * factor);
      m_text = fixed(static_cast<double>(surface.scale), 3) + " x";
    } else {
      surface.size = std::max(kMinSizeM, typed ? *typed : surface.size * factor);
      m_text = "size " + metres(surface.size);
    }
  }
};

class RotorDrag : public ShapeDrag {
 public:
  using ShapeDrag::ShapeDrag;

 private:
  std::optional<Edit> make(const ToolContext& context) override {
    constexpr float kMinRadiusM = 0.1f;
    const Rotor* before = findRotor(context.document.committed(), m_grip.object);
    if (!before) return std::nullopt;
    Rotor rotor = *before;
    rotor.radius = std::max(kMinRadiusM, m_number.value().value_or(distance(context)));
    m_text = "radius " + metres(rotor.radius);
    if (rotor == *before) return std::nullopt;
    return Edit{.label = "Shape rotor", .steps = {Put<Rotor>{std::move(rotor)}}, .mergeKey = {}};
  }
};

}  // namespace

std::unique_ptr<Drag> makeSurfaceDrag(const Grip& grip) {
  return std::make_unique<SurfaceDrag>(grip);
}

std::unique_ptr<Drag> makeRotorDrag(const Grip& grip) {
  return std::make_unique<RotorDrag>(grip);
}

}  // namespace windloom::editor
