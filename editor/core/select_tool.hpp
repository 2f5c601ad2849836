#pragma once
// Selecting, and moving, rotating or scaling what is selected: four tools that differ in what a drag does.

#include "editor/core/grips.hpp"
#include "editor/core/tool.hpp"

namespace windloom::editor {

/// Click selects (Shift adds, Ctrl toggles, on an arrow Ctrl inserts a point and Ctrl+Shift toggles); clicks at
/// the same place go through what overlaps there. Alt+drag on a handle moves copies. Grips come before objects; a
/// corner of a polygon that was clicked or is under the pointer goes with Del.
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
  void onHover(ToolContext& context, const PointerEvent& pointer) override;
  void hoverEnded() override { m_hot.reset(); }
  [[nodiscard]] bool overGrip() const override { return m_hot.has_value(); }
  bool onKey(ToolContext& context, const KeyPress& press) override;
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;

 private:
  std::unique_ptr<Drag> dragGrip(ToolContext& context, const PointerEvent& press, const Grip& grip);
  std::unique_ptr<Drag> transform(ToolContext& context, const PointerEvent& press, const Hit* grabbed);

  SelectKind m_kind;
  std::optional<glm::vec2> m_lastClick;
  std::optional<Grip> m_hot;     // under the pointer
  std::optional<Grip> m_corner;  // the corner that was clicked
};

/// Puts a point into the topmost arrow at the pixel and selects it. False: no arrow there.
bool insertPointAt(ToolContext& context, glm::vec2 pixel, std::string& message);

}  // namespace windloom::editor
