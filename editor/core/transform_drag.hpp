#pragma once
// Rotating and scaling what is selected around its middle.

#include <vector>

#include "editor/core/axis_lock.hpp"
#include "editor/core/number_entry.hpp"
#include "editor/core/tool.hpp"

namespace windloom::editor {

enum class TransformKind { Rotate, Scale };

/// A typed number is the angle in degrees, or the factor. X and Z lock the axis of a scaling.
class TransformDrag : public Drag {
 public:
  TransformDrag(const ToolContext& context, TransformKind kind, glm::vec2 pivot, glm::vec2 pressed,
                AxisLock lock = AxisLock::None);

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override;
  std::optional<Edit> end(ToolContext& context) override;
  bool onKey(ToolContext& context, const KeyPress& press) override;
  [[nodiscard]] bool finished() const override { return m_finished; }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;
  [[nodiscard]] std::string hint(const ToolContext& context) const override;

 private:
  [[nodiscard]] float ratio() const;
  std::optional<Edit> make(const ToolContext& context) const;

  TransformKind m_kind;
  glm::vec2 m_pivot, m_pressed, m_place;
  std::vector<Id> m_ids;
  float m_degrees = 0.0f;
  glm::vec2 m_scale{1.0f};
  glm::vec2 m_pixel{0.0f};
  AxisLock m_lock;
  NumberEntry m_number;
  bool m_finished = false;
};

}  // namespace windloom::editor
