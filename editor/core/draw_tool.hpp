#pragma once
// Drawing wind trees. Press = root, drag, release = end; or click, click, click. Starting at a point branches
// from it, ending at a point joins it. The wheel changes the radius of what is drawn, Shift+wheel its strength.

#include "editor/core/tool.hpp"

namespace windloom::editor {

/// Where an arrow starts or ends: a point that exists, or a place for a new one.
struct DrawEnd {
  Id point = 0;  ///< 0: new
  glm::vec2 place{0.0f};
};

struct DrawResult {
  Edit edit;
  Id arrow = 0;
  Id end = 0;  ///< the point at the end
};
/// The edit that draws an arrow between two ends. Nothing where it would have no length.
std::optional<DrawResult> drawEdit(const Project& project, const DrawEnd& from, const DrawEnd& to, const Arrow& model);

class DrawTool : public Tool {
 public:
  [[nodiscard]] std::string id() const override { return "draw"; }
  [[nodiscard]] std::string label() const override { return "Draw tree"; }
  [[nodiscard]] std::string hint(const ToolContext& context) const override;
  [[nodiscard]] PointerShape pointerShape() const override { return PointerShape::Cross; }
  void onClick(ToolContext& context, const PointerEvent& pointer) override;
  std::unique_ptr<Drag> beginDrag(ToolContext& context, const PointerEvent& press) override;
  void onHover(ToolContext& context, const PointerEvent& pointer) override;
  bool onKey(ToolContext& context, const KeyPress& press) override;
  bool onWheel(ToolContext& context, float notches, Modifiers modifiers) override;
  [[nodiscard]] bool busy() const override { return m_chain.has_value(); }
  void cancel(ToolContext&) override { m_chain.reset(); }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;

 private:
  void dropLostChain(const ToolContext& context);

  std::optional<DrawEnd> m_chain;  // where the next arrow of a click chain starts
  std::optional<DrawEnd> m_hover;  // where it would end now
  glm::vec2 m_pixel{0.0f};
};

}  // namespace windloom::editor
