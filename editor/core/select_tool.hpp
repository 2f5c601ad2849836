#pragma once
// Selecting, and moving, rotating or scaling what is selected: four tools that differ in what a drag does.

#include "editor/core/tool.hpp"

namespace windloom::editor {

enum class SelectKind {
  Select,  ///< a drag moves a handle, or draws a box on empty ground
  Move,    ///< a drag anywhere moves the selection
  Rotate,
  Scale,
};

/// Click selects (Shift adds, Ctrl toggles, on an arrow Ctrl inserts a point and Ctrl+Shift toggles); clicks at
/// the same place go through what overlaps there. Alt+drag on a handle moves copies.
class SelectTool : public Tool {
 public:
  explicit SelectTool(SelectKind kind) : m_kind(kind) {}
  [[nodiscard]] std::string id() const override;
  [[nodiscard]] std::string label() const override;
  [[nodiscard]] std::string hint(const ToolContext& context) const override;
  [[nodiscard]] PointerShape pointerShape() const override;
  [[nodiscard]] bool usesAlt() const override { return m_kind == SelectKind::Select || m_kind == SelectKind::Move; }
  void onClick(ToolContext& context, const PointerEvent& pointer) override;
  std::unique_ptr<Drag> beginDrag(ToolContext& context, const PointerEvent& press) override;

 private:
  std::unique_ptr<Drag> transform(ToolContext& context, const PointerEvent& press, const Hit* grabbed);

  SelectKind m_kind;
  std::optional<glm::vec2> m_lastClick;
};

/// Puts a point into the topmost arrow at the pixel and selects it. False: no arrow there.
bool insertPointAt(ToolContext& context, glm::vec2 pixel, std::string& message);

}  // namespace windloom::editor
