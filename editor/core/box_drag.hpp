#pragma once
// Selecting with a rectangle.

#include "editor/core/tool.hpp"

namespace windloom::editor {

/// Selects while it is drawn; a cancel gives the old selection back.
class BoxDrag : public Drag {
 public:
  BoxDrag(const ToolContext& context, const PointerEvent& press);

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override;
  std::optional<Edit> end(ToolContext&) override { return std::nullopt; }
  void cancel(ToolContext& context) override { context.selection = m_before; }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;
  [[nodiscard]] std::string hint(const ToolContext& context) const override;

 private:
  Selection m_before;
  SelectMode m_mode;
  glm::vec2 m_from, m_to;
};

/// Shift adds, Ctrl toggles.
SelectMode selectMode(Modifiers held);

}  // namespace windloom::editor
