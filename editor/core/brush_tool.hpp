#pragma once
// Combing wind: a drag pushes the live air along. It makes no edit.

#include "editor/core/tool.hpp"

namespace windloom::editor {

/// [ and ] change the radius, Shift+[ ] the strength; the wheel does while the button is held.
class BrushTool : public Tool {
 public:
  [[nodiscard]] std::string id() const override { return "brush"; }
  [[nodiscard]] std::string label() const override { return "Wind brush"; }
  [[nodiscard]] std::string hint(const ToolContext& context) const override;
  [[nodiscard]] PointerShape pointerShape() const override { return PointerShape::Cross; }
  std::unique_ptr<Drag> beginDrag(ToolContext& context, const PointerEvent& press) override;
  void onHover(ToolContext& context, const PointerEvent& pointer) override;
  void hoverEnded() override { m_hover.reset(); }
  bool onKey(ToolContext& context, const KeyPress& press) override;
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;

 private:
  std::optional<glm::vec2> m_hover;
};

}  // namespace windloom::editor
