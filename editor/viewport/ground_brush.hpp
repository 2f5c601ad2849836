#pragma once
// How marks and handles are drawn on the ground. For the files of editor/viewport only.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "editor/core/collider_shape.hpp"
#include "editor/viewport/handles.hpp"
#include "editor/widgets/look.hpp"
#include "engine/model/outline.hpp"

namespace windloom::editor {

// Above so many, only the hovered handle gets its full form, and none is named in the map of controls.
inline constexpr std::size_t kManyPoints = 3000;

inline bool isMany(const WindGraph& graph) {
  return graph.points.size() > kManyPoints;
}

/// Draws in ground coordinates.
class GroundBrush {
 public:
  GroundBrush(const ViewArea& area, const Workspace& workspace)
      : m_area(area),
        m_view(workspace.view()),
        m_ground(workspace.ground),
        m_list(*ImGui::GetWindowDrawList()),
        m_named(look().map.on() && !isMany(*workspace.document.project().graph)) {}

  [[nodiscard]] std::optional<ImVec2> screen(glm::vec3 world) const {
    const auto pixel = m_view.toScreen(world);
    if (!pixel) return std::nullopt;
    return m_area.at(*pixel);
  }
  [[nodiscard]] std::optional<ImVec2> screen(glm::vec2 place) const { return screen(m_ground.lift(place)); }
  [[nodiscard]] bool inside(ImVec2 p) const {
    const float margin = scaled(20);
    return p.x > m_area.min.x - margin && p.x < m_area.max.x + margin && p.y > m_area.min.y - margin &&
           p.y < m_area.max.y + margin;
  }

  void line(glm::vec3 a, glm::vec3 b, ImU32 colour, float width) const {
    const auto from = screen(a), to = screen(b);
    if (from && to) m_list.AddLine(*from, *to, colour, width);
  }

  void ring(glm::vec3 centre, float radius, ImU32 colour, float width) const {
    constexpr int kSegments = 40;
    std::optional<ImVec2> last;
    for (int i = 0; i <= kSegments; ++i) {
      const float angle = 6.2831853f * float(i) / kSegments;
      const glm::vec2 place{centre.x + radius * std::cos(angle), centre.z + radius * std::sin(angle)};
      const auto at = screen(place);
      if (at && last) m_list.AddLine(*last, *at, colour, width);
      last = at;
    }
  }

  /// A line that follows the ground.
  void shaft(glm::vec2 a, glm::vec2 b, ImU32 colour, float width) const {
    constexpr int kPieces = 16;
    for (int i = 0; i < kPieces; ++i) {
      line(m_ground.lift(glm::mix(a, b, float(i) / kPieces)), m_ground.lift(glm::mix(a, b, float(i + 1) / kPieces)),
           colour, width);
    }
  }

  /// A line with a head whose size is in pixels.
  void arrow(glm::vec3 a, glm::vec3 b, ImU32 colour, float width) const {
    const auto from = screen(a), to = screen(b);
    if (!from || !to) return;
    const float dx = to->x - from->x, dy = to->y - from->y, length = std::hypot(dx, dy);
    if (length < 1.0f) return;
    const float head = std::min(scaled(12), length * 0.6f);
    const ImVec2 along{dx / length, dy / length}, side{-along.y, along.x};
    const ImVec2 neck{to->x - along.x * head, to->y - along.y * head};
    if (m_ground.height) {
      shaft({a.x, a.z}, {b.x, b.z}, colour, width);
    } else {
      m_list.AddLine(*from, neck, colour, width);
    }
    m_list.AddTriangleFilled(*to, {neck.x + side.x * head * 0.45f, neck.y + side.y * head * 0.45f},
                             {neck.x - side.x * head * 0.45f, neck.y - side.y * head * 0.45f}, colour);
  }

  template <class Thing>
  void outline(const Thing& thing, ImU32 colour, float width) const {
    const std::vector<glm::vec2> corners = outlineOf(thing);
    for (std::size_t i = 0; i < corners.size(); ++i)
      shaft(corners[i], corners[(i + 1) % corners.size()], colour, width);
  }

  ImDrawList& list() const { return m_list; }
  [[nodiscard]] bool named() const { return m_named; }
  const Ground& ground() const { return m_ground; }

 private:
  ViewArea m_area;
  ViewMapping m_view;
  const Ground& m_ground;
  ImDrawList& m_list;
  bool m_named;
};

struct Marks {
  std::unordered_set<Id> chosen;
  Id hovered = 0;
  [[nodiscard]] bool selected(Id id) const { return chosen.contains(id); }
};

inline void name(const GroundBrush& brush, const std::string& id, ImVec2 at) {
  if (!brush.named()) return;
  const float half = scaled(5);
  if (brush.inside(at)) look().map.rectangle(id, {at.x - half, at.y - half}, {at.x + half, at.y + half});
}

/// The handle of a thing that stands on the ground.
inline void diamond(const GroundBrush& brush, ImVec2 at, bool marked, ImU32 colour) {
  const float half = scaled(marked ? 5.0f : 4.0f), edge = half + scaled(2);
  const auto fill = [&](float r, ImU32 with) {
    brush.list().AddQuadFilled({at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}, with);
  };
  fill(edge, IM_COL32(10, 12, 14, 190));
  fill(half, colour);
}

void drawSurfaces(const GroundBrush& brush, const Project& project, const Marks& marks, bool withOutlines);
void drawRotors(const GroundBrush& brush, const Project& project, const Marks& marks);

}  // namespace windloom::editor
