#include "editor/core/brush_tool.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

constexpr float kStepFactor = 1.1f;
constexpr double kMinPieceS = 1.0 / 120;  // shorter ones would measure the pointer's speed too roughly

void changeRadius(BrushSettings& brush, float notches) {
  brush.radiusM = std::clamp(brush.radiusM * std::pow(kStepFactor, notches), kMinBrushM, kMaxBrushM);
}
void changeStrength(BrushSettings& brush, float notches) {
  brush.strength = std::clamp(brush.strength * std::pow(kStepFactor, notches), kMinBrushStrength, kMaxBrushStrength);
}

std::string brushText(const BrushSettings& brush) {
  return "radius " + fixed(static_cast<double>(brush.radiusM), 1) + " m, strength x" +
         fixed(static_cast<double>(brush.strength), 2);
}

bool onBrushKey(BrushSettings& brush, const KeyPress& press) {
  if (press.modifiers.ctrl || press.modifiers.alt) return false;
  if (press.key != Key::BracketLeft && press.key != Key::BracketRight) return false;
  const float notches = press.key == Key::BracketRight ? 1.0f : -1.0f;
  if (press.modifiers.shift) {
    changeStrength(brush, notches);
  } else {
    changeRadius(brush, notches);
  }
  return true;
}

class BrushDrag : public Drag {
 public:
  BrushDrag(glm::vec2 place, double seconds) : m_place(place), m_from(place), m_seconds(seconds) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    if (const auto place = context.groundAt(pointer.pixel)) m_place = *place;
    const double passed = context.seconds - m_seconds;
    if (passed < kMinPieceS) return std::nullopt;
    const BrushSettings& brush = context.settings.brush;
    m_speed = glm::distance(m_from, m_place) / static_cast<float>(passed) * brush.strength;
    if (context.strokes) context.strokes->add(m_from, m_place, m_speed, brush.radiusM);
    m_from = m_place;
    m_seconds = context.seconds;
    return std::nullopt;
  }
  std::optional<Edit> end(ToolContext&) override { return std::nullopt; }
  bool onKey(ToolContext& context, const KeyPress& press) override { return onBrushKey(context.settings.brush, press); }
  bool onWheel(ToolContext& context, float notches, Modifiers held) override {
    if (held.shift) {
      changeStrength(context.settings.brush, notches);
    } else {
      changeRadius(context.settings.brush, notches);
    }
    return true;
  }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override {
    shapes.discs.push_back({context.ground.lift(m_place), context.settings.brush.radiusM, ShapeRole::Snap, true});
  }
  [[nodiscard]] std::string hint(const ToolContext&) const override {
    return "Pushing the air with " + fixed(static_cast<double>(std::min(m_speed, kMaxBrushSpeedMps)), 1) +
           " m/s (wheel: radius, Shift+wheel: strength). It fades, and is no part of the project";
  }

 private:
  glm::vec2 m_place, m_from;
  double m_seconds;
  float m_speed = 0.0f;
};

}  // namespace

std::string BrushTool::hint(const ToolContext& context) const {
  return "Drag to push the air along (" + brushText(context.settings.brush) + "; [ ] radius, Shift+[ ] strength)";
}

std::unique_ptr<Drag> BrushTool::beginDrag(ToolContext& context, const PointerEvent& press) {
  const auto place = context.groundAt(press.pixel);
  if (!place) return nullptr;
  return std::make_unique<BrushDrag>(*place, press.seconds);
}

void BrushTool::onHover(ToolContext& context, const PointerEvent& pointer) {
  m_hover = context.groundAt(pointer.pixel);
}

bool BrushTool::onKey(ToolContext& context, const KeyPress& press) {
  return onBrushKey(context.settings.brush, press);
}

void BrushTool::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  if (m_hover)
    shapes.discs.push_back({context.ground.lift(*m_hover), context.settings.brush.radiusM, ShapeRole::Preview, true});
}

}  // namespace windloom::editor
