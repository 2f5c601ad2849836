#include "editor/core/legend_layout.hpp"

#include <algorithm>

namespace windloom::editor {
namespace {

/// Stacked upwards from `bottom` in one column, between `top` and `bottom`.
std::vector<LegendBox> stack(float right, float top, float bottom, float width, float gap, float fixed, float scale,
                             int wanted) {
  std::vector<LegendBox> boxes;
  for (int count = wanted; count > 0; --count) {
    const float room = (bottom - top - gap * float(count - 1)) / float(count) - fixed;
    if (room < kShortestLegendBar * scale) continue;
    const float bar = std::min(room, kLongestLegendBar * scale);
    for (int i = 0; i < count; ++i) {
      const float foot = bottom - float(i) * (fixed + bar + gap);
      boxes.push_back({{right - width, foot - fixed - bar}, {right, foot}, bar});
    }
    break;
  }
  return boxes;
}

}  // namespace

std::vector<LegendBox> layoutLegends(glm::vec2 size, float scale, float fixed, int wanted) {
  const float width = kLegendWidth * scale, gap = kLegendGap * scale, margin = kInstrumentMargin * scale;
  const float right = size.x - margin, top = kAxisSignRoom * scale;
  float bottom = size.y - margin;
  const float columns = (right - kScaleBarRoom * scale + gap) / (width + gap);
  if (columns < 1) {
    // Not beside the scale bar: above it.
    bottom = size.y - kScaleBarHeight * scale;
    return right - width < 0 ? std::vector<LegendBox>{} : stack(right, top, bottom, width, gap, fixed, scale, wanted);
  }
  if (columns < float(wanted)) return stack(right, top, bottom, width, gap, fixed, scale, wanted);
  std::vector<LegendBox> boxes;
  for (int i = 0; i < wanted; ++i) {
    for (const LegendBox& box : stack(right - float(i) * (width + gap), top, bottom, width, gap, fixed, scale, 1)) {
      boxes.push_back(box);
    }
  }
  return boxes;
}

}  // namespace windloom::editor
