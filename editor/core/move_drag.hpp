#pragma once
// Moving what is selected, or copies of it.

#include <vector>

#include "editor/core/axis_lock.hpp"
#include "editor/core/number_entry.hpp"
#include "editor/core/tool.hpp"

namespace windloom::editor {

enum class MoveWhat { Selection, Copies };

/// X and Z lock the axis, a typed number is the distance along it (or along the way the pointer went).
class MoveDrag : public Drag {
 public:
  /// `anchor` is the place on the ground that follows the pointer (the grabbed handle's) and snaps to the grid. Where
  /// it is a moved point, it snaps to other points, too.
  MoveDrag(const ToolContext& context, glm::vec2 pressed, glm::vec2 anchor, MoveWhat what,
           AxisLock lock = AxisLock::None);

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override;
  std::optional<Edit> end(ToolContext& context) override;
  void applied(ToolContext& context) override;
  bool onKey(ToolContext& context, const KeyPress& press) override;
  [[nodiscard]] bool finished() const override { return m_finished; }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override;
  [[nodiscard]] std::string hint(const ToolContext& context) const override;

 private:
  [[nodiscard]] glm::vec2 deltaFor(const ToolContext& context, const PointerEvent& pointer);
  [[nodiscard]] const Point* pointUnder(const ToolContext& context, glm::vec2 pixel) const;
  std::optional<Edit> make(const ToolContext& context);

  glm::vec2 m_pressed, m_anchor;
  MoveWhat m_what;
  std::vector<Id> m_ids;
  std::vector<Id> m_copies;
  glm::vec2 m_free{0.0f};   // where the pointer would move it
  glm::vec2 m_delta{0.0f};  // with lock, snap and typed number
  glm::vec2 m_pixel{0.0f};
  AxisLock m_lock;
  Id m_anchorPoint = 0;  // the moved point at the anchor
  Id m_snapped = 0;      // the point that it snapped to
  NumberEntry m_number;
  bool m_finished = false;
};

}  // namespace windloom::editor
