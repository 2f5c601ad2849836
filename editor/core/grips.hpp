#pragma once
// Handles to drag by beside the objects themselves: the gizmo of the move, rotate and scale tools in the middle of the
// selection, and the handles of a selected obstacle's, collider's, surface's or rotor's outline. Both keep their size
// on the screen.

#include <optional>
#include <string>
#include <vector>

#include "editor/core/tool.hpp"

namespace windloom::editor {

enum class SelectKind {
  Select,  ///< a drag moves a handle, or draws a box on empty ground
  Move,    ///< a drag anywhere moves the selection
  Rotate,
  Scale,
};

enum class GripKind {
  AxisX,   ///< gizmo: along x
  AxisZ,   ///< gizmo: along z
  Centre,  ///< gizmo: both
  Ring,    ///< gizmo: turn
  Radius,  ///< of a circle, sphere, capsule or rotor; a surface's size
  Side,    ///< of a box; index 0..3: low x, high x, low z, high z of its own axes
  Turn,    ///< rotation of a box, polygon, capsule, mesh or surface
  Corner,  ///< of a polygon; index
};

struct Grip {
  GripKind kind = GripKind::Centre;
  Id object = 0;  ///< the thing whose outline it changes; 0: gizmo
  int index = 0;
  glm::vec2 place{0.0f};  ///< on the ground
  glm::vec2 pivot{0.0f};  ///< middle of the selection, or of the object
  bool operator==(const Grip& other) const {
    return kind == other.kind && object == other.object && index == other.index;
  }
};

/// Length of the gizmo's arms, pixels at an interface scale of 1.
inline constexpr float kGizmoPx = 70.0f;

/// Grips of a tool for what is selected; none where nothing that can move is. Handles of outlines only with the select
/// and move tools, and only of the active obstacle, collider, surface or rotor where it is not locked.
std::vector<Grip> gripsOf(const ToolContext& context, SelectKind tool);
/// The one under the pixel. Handles of points and probes that aren't selected come before arms and ring.
std::optional<Grip> gripAt(const ToolContext& context, SelectKind tool, glm::vec2 pixel);
void addGripShapes(const ToolContext& context, SelectKind tool, const std::optional<Grip>& hot, PreviewShapes& shapes);
std::string gripHint(const Grip& grip);

/// Changes an obstacle's outline. A typed number is the radius, the side's length or the angle.
std::unique_ptr<Drag> makeOutlineDrag(const Grip& grip);

/// Changes a collider's radius or rotation. A typed number is the radius or the angle.
std::unique_ptr<Drag> makeColliderDrag(const Grip& grip);

/// Changes a surface's size or rotation, or a rotor's radius. A typed number is the size (of a mesh: its scale), the
/// angle, or the radius.
std::unique_ptr<Drag> makeSurfaceDrag(const Grip& grip);
std::unique_ptr<Drag> makeRotorDrag(const Grip& grip);

/// A corner put into the polygon's side nearest to the pixel. False: no side of a polygon there.
bool insertCornerAt(ToolContext& context, glm::vec2 pixel, std::string& message);
/// The polygon without the corner. Nothing where there is no such corner; one with three keeps them and is refused.
Edit removeCornerEdit(const Project& project, Id obstacle, int corner);

}  // namespace windloom::editor
