#pragma once
// A drag from a middle to a rim: circles, boxes and vortices are drawn so.

#include <optional>

#include "editor/core/snapping.hpp"
#include "editor/core/tool.hpp"

namespace windloom::editor {

class CentreDrag : public Drag {
 public:
  explicit CentreDrag(glm::vec2 centre) : m_centre(centre), m_place(centre) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) final {
    m_pixel = pointer.pixel;
    if (const auto place = context.groundAt(pointer.pixel))
      m_place = snapToGrid(context.settings.snap, *place, pointer.modifiers);
    return make(context);
  }
  std::optional<Edit> end(ToolContext& context) final { return make(context); }
  void applied(ToolContext& context) final { context.selection.replace(m_made); }

 protected:
  /// The edit for the present centre and place; sets m_made. Nothing where it would be too small.
  virtual std::optional<Edit> make(const ToolContext& context) = 0;

  glm::vec2 m_centre, m_place;  ///< m on the ground
  glm::vec2 m_pixel{0.0f};      ///< where the pointer is
  Id m_made = 0;
};

}  // namespace windloom::editor
