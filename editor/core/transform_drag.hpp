#pragma once
// Rotating and scaling what is selected around its middle.

#include <vector>

#include "editor/core/number_entry.hpp"
#include "editor/core/tool.hpp"

namespace windloom::editor {

enum class TransformKind { Rotate, Scale };

/// A typed number is the angle in degrees, or the factor.
class TransformDrag : public Drag {
 public:
  TransformDrag(const ToolContext& context, TransformKind kind, glm::vec2 pivot, glm::vec2 pressed);

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override;
  std::optional<Edit> end(ToolContext& context) override;
  bool onKey(ToolContext& context, const KeyPress& press) override;
  [[nodiscard]] bool finished() const override { return m_finished; }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;
  [[nodiscard]] std::string hint(const ToolContext& context) const override;

 private:
  std::optional<Edit> make(const ToolContext& context) const;

  TransformKind m_kind;
  glm::vec2 m_pivot, m_pressed, m_place;
  std::vector<Id> m_ids;
  float m_degrees = 0.0f, m_scale = 1.0f;
  glm::vec2 m_pixel{0.0f};
  NumberEntry m_number;
  bool m_finished = false;
};

}  // namespace windloom::editor
