#pragma once
// Drawing whirls: an arrow that only turns the air around its end point.

#include "editor/core/tool.hpp"

namespace windloom::editor {

/// Drag from the middle outwards: the radius. The wheel changes how fast it turns, C turns it the other way round.
class VortexTool : public Tool {
 public:
  [[nodiscard]] std::string id() const override { return "vortex"; }
  [[nodiscard]] std::string label() const override { return "Vortex"; }
  [[nodiscard]] std::string hint(const ToolContext& context) const override;
  [[nodiscard]] PointerShape pointerShape() const override { return PointerShape::Cross; }
  std::unique_ptr<Drag> beginDrag(ToolContext& context, const PointerEvent& press) override;
  bool onKey(ToolContext& context, const KeyPress& press) override;
};

}  // namespace windloom::editor
