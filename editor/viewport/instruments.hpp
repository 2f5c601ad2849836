#pragma once
// What helps to read the picture: axis sign, scale bar, colour legends, the hint in an empty project. Drawn with the
// current window's draw list; `min` and `max` are the viewport's corners in window pixels.

#include <imgui.h>

#include "editor/core/workspace.hpp"
#include "engine/render/overlay_settings.hpp"

namespace windloom::editor {

struct ViewArea {
  ImVec2 min, max;
  [[nodiscard]] ImVec2 at(glm::vec2 pixel) const { return {min.x + pixel.x, min.y + pixel.y}; }
};

/// Axes as the camera sees them, top right. A click on an end looks along it. True while the pointer is on it.
bool axisSign(const ViewArea& area, Workspace& workspace);

/// A length of ground in round metres, bottom left; true to scale at the camera's target.
void scaleBar(const ViewArea& area, const Workspace& workspace);

/// What a legend's range can be set to, m/s or 1/s.
inline constexpr double kLeastRange = 0.05, kGreatestRange = 200;

/// A legend for each set of colours in the picture, bottom right; its range can be changed. True while the pointer is
/// on one.
bool colourLegends(const ViewArea& area, Overlays& overlays);

/// How to draw the first tree.
void firstTreeHint(const ViewArea& area);

}  // namespace windloom::editor
