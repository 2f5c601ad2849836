// Dragging the handles of a collider.
#include <cmath>

#include "editor/core/grips.hpp"
#include "editor/core/number_entry.hpp"
#include "editor/core/snapping.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

constexpr float kMinRadiusM = 0.01f;

class ColliderDrag : public Drag {
 public:
  explicit ColliderDrag(const Grip& grip) : m_grip(grip), m_place(grip.place) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    m_pixel = pointer.pixel;
    m_held = pointer.modifiers;
    if (const auto place = context.groundAt(pointer.pixel)) m_place = *place;
    return make(context);
  }
  std::optional<Edit> end(ToolContext& context) override { return make(context); }
  bool onKey(ToolContext&, const KeyPress& press) override {
    if (press.key == Key::Enter || press.key == Key::NumpadEnter) {
      m_finished = true;
      return true;
    }
    return m_number.onKey(press);
  }
  [[nodiscard]] bool finished() const override { return m_finished; }
  void shapes(const ToolContext&, PreviewShapes& shapes) const override {
    shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f), m_number.empty() ? m_text : m_number.text()});
  }
  [[nodiscard]] std::string hint(const ToolContext&) const override {
    return "Type a value + Enter, Ctrl snaps, Esc cancels";
  }

 private:
  std::optional<Edit> make(const ToolContext& context) {
    const Collider* before = findCollider(context.document.committed(), m_grip.object);
    if (!before) return std::nullopt;
    Collider collider = *before;
    const auto typed = m_number.value();
    if (m_grip.kind == GripKind::Radius) {
      const glm::vec2 place = snapToGrid(context.settings.snap, m_place, m_held);
      collider.radius = std::max(kMinRadiusM, typed ? *typed : glm::distance(place, m_grip.pivot));
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

  Grip m_grip;
  glm::vec2 m_place, m_pixel{0.0f};
  Modifiers m_held;
  NumberEntry m_number;
  std::string m_text;
  bool m_finished = false;
};

}  // namespace

std::unique_ptr<Drag> makeColliderDrag(const Grip& grip) {
  return std::make_unique<ColliderDrag>(grip);
}

}  // namespace windloom::editor
