#pragma once
// Where the colour legends stand in the viewport: at the bottom right, clear of the scale bar and of the axis sign.

#include <glm/glm.hpp>
#include <vector>

namespace windloom::editor {

/// Sizes in px at 100%, shared with what draws the instruments.
inline constexpr float kLegendWidth = 92, kLegendGap = 8, kInstrumentMargin = 12;
inline constexpr float kScaleBarRoom = 168, kScaleBarHeight = 44;  ///< bottom left, margins included
inline constexpr float kAxisSignRoom = 110;                        ///< square at the top right, margins included
inline constexpr float kLongestLegendBar = 110, kShortestLegendBar = 50;

struct LegendBox {
  glm::vec2 min{0.0f}, max{0.0f};  ///< px from the viewport's top left corner
  float bar = 0.0f;                ///< height of its colour bar, px
};

/// Boxes for up to `wanted` legends in a viewport of `size` px at an interface `scale`. `fixed` is the height of a
/// legend without its bar, px. The first is the rightmost; fewer than wanted where they can't be read.
std::vector<LegendBox> layoutLegends(glm::vec2 size, float scale, float fixed, int wanted);

}  // namespace windloom::editor
