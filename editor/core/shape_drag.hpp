#pragma once
// What dragging the handle of a thing has in common, whatever the handle changes: it follows the pointer over the
// ground, takes a typed value, and tells beside the pointer what comes out.

#include <optional>
#include <string>

#include "editor/core/grips.hpp"
#include "editor/core/number_entry.hpp"
#include "editor/core/snapping.hpp"

namespace windloom::editor {

class ShapeDrag : public Drag {
 public:
  explicit ShapeDrag(const Grip& grip) : m_grip(grip), m_place(grip.place) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override;
  std::optional<Edit> end(ToolContext& context) override { return make(context); }
  bool onKey(ToolContext& context, const KeyPress& press) override;
  [[nodiscard]] bool finished() const override { return m_finished; }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;
  [[nodiscard]] std::string hint(const ToolContext&) const override {
    return "Type a value + Enter, Ctrl snaps, Esc cancels";
  }

 protected:
  /// The edit that the drag is so far, and m_text; none where it changes nothing.
  virtual std::optional<Edit> make(const ToolContext& context) = 0;
  /// From the grip's pivot to the pointer, snapped, m.
  [[nodiscard]] float distance(const ToolContext& context) const;

  Grip m_grip;
  glm::vec2 m_place, m_pixel{0.0f};  // of the pointer: m on the ground, pixels
  Modifiers m_held;
  NumberEntry m_number;
  std::string m_text;  // shown beside the pointer
  bool m_finished = false;
};

}  // namespace windloom::editor
