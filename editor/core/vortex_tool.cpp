#include "editor/core/vortex_tool.hpp"

#include <algorithm>
#include <cmath>

#include "editor/core/centre_drag.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

constexpr float kMinRadiusM = 0.1f;
constexpr float kMaxSwirlMps = 100.0f;

bool turnRound(ToolContext& context, const KeyPress& press) {
  if (press.key != Key::C || press.modifiers.any()) return false;
  context.settings.newSwirlMps = -context.settings.newSwirlMps;
  return true;
}

std::string swirlText(float swirl) {
  return fixed(static_cast<double>(std::abs(swirl)), 1) + " m/s " + (swirl > 0.0f ? "from +X to +Z" : "from +Z to +X");
}

class VortexDrag : public CentreDrag {
 public:
  using CentreDrag::CentreDrag;
  bool onKey(ToolContext& context, const KeyPress& press) override { return turnRound(context, press); }
  bool onWheel(ToolContext& context, float notches, Modifiers) override {
    float& swirl = context.settings.newSwirlMps;
    swirl = std::clamp(swirl * std::pow(1.1f, notches), -kMaxSwirlMps, kMaxSwirlMps);
    return true;
  }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override {
    const float radius = glm::distance(m_centre, m_place);
    shapes.discs.push_back({context.ground.lift(m_centre), radius, ShapeRole::Preview});
    shapes.labels.push_back({m_pixel + glm::vec2(16.0f, 16.0f), "radius " + fixed(static_cast<double>(radius), 1) +
                                                                    " m, " + swirlText(context.settings.newSwirlMps)});
  }
  [[nodiscard]] std::string hint(const ToolContext&) const override {
    return "Release to set the radius. Wheel: speed, C: the other way round, Esc cancels";
  }

 private:
  /// The swirl is around the end of an arrow, so a short arrow of no strength leads from the rim to the middle.
  std::optional<Edit> make(const ToolContext& context) override {
    Arrow model = context.settings.newArrow;
    model.radius = glm::distance(m_centre, m_place);
    if (model.radius < kMinRadiusM) return std::nullopt;
    model.strength = 0.0f;
    model.where = Where::End;
    model.swirl = context.settings.newSwirlMps;
    TreeResult tree = treeEdit(context.document.committed(), m_place, m_centre, model);
    tree.edit.label = "Draw vortex";
    m_made = tree.arrow;
    return std::move(tree.edit);
  }
};

}  // namespace

std::string VortexTool::hint(const ToolContext& context) const {
  return "Drag from the middle outwards (" + swirlText(context.settings.newSwirlMps) + ", C turns it round)";
}

std::unique_ptr<Drag> VortexTool::beginDrag(ToolContext& context, const PointerEvent& press) {
  const auto place = context.groundAt(press.pixel);
  if (!place) return nullptr;
  return std::make_unique<VortexDrag>(snapToGrid(context.settings.snap, *place, press.modifiers));
}

bool VortexTool::onKey(ToolContext& context, const KeyPress& press) {
  return turnRound(context, press);
}

}  // namespace windloom::editor
