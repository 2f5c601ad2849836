#pragma once
// Drawing obstacles: a drag makes a circle or a box, clicks make a polygon.

#include <vector>

#include "editor/core/tool.hpp"

namespace windloom::editor {

/// Drag from the centre outwards for a circle or box; C changes between the two, also during the drag. Click, click,
/// click for the corners of a polygon; Enter, right click or a click on the first corner closes it, Backspace takes
/// the last corner back, Esc drops it.
class ObstacleTool : public Tool {
 public:
  [[nodiscard]] std::string id() const override { return "obstacle"; }
  [[nodiscard]] std::string label() const override { return "Obstacle"; }
  [[nodiscard]] std::string hint(const ToolContext& context) const override;
  [[nodiscard]] PointerShape pointerShape() const override { return PointerShape::Cross; }
  void onClick(ToolContext& context, const PointerEvent& pointer) override;
  std::unique_ptr<Drag> beginDrag(ToolContext& context, const PointerEvent& press) override;
  void onHover(ToolContext& context, const PointerEvent& pointer) override;
  bool onKey(ToolContext& context, const KeyPress& press) override;
  [[nodiscard]] bool busy() const override { return !m_corners.empty(); }
  void cancel(ToolContext&) override { m_corners.clear(); }
  void finish(ToolContext& context) override;
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;

 private:
  /// Where a click at the pixel sets a corner; nothing over the sky.
  [[nodiscard]] std::optional<glm::vec2> cornerAt(const ToolContext& context, const PointerEvent& pointer) const;
  [[nodiscard]] bool onFirstCorner(const ToolContext& context, glm::vec2 pixel) const;

  std::vector<glm::vec2> m_corners;  // of the polygon under way, in the world
  std::optional<glm::vec2> m_hover;  // where the next one would be
  bool m_closes = false;             // the pointer is on the first corner
  glm::vec2 m_pixel{0.0f};
};

/// An obstacle with these corners in the world, its centre in their middle. Other values as in `model`.
Obstacle polygonOf(const std::vector<glm::vec2>& corners, Obstacle model);

}  // namespace windloom::editor
