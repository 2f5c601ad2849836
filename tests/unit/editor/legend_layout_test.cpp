#include "editor/core/legend_layout.hpp"

#include <gtest/gtest.h>

namespace windloom::editor {
namespace {

constexpr float kFixed = 64;  // px at 100%

bool apart(glm::vec2 aMin, glm::vec2 aMax, glm::vec2 bMin, glm::vec2 bMax) {
  return aMax.x <= bMin.x || bMax.x <= aMin.x || aMax.y <= bMin.y || bMax.y <= aMin.y;
}

TEST(LegendLayout, NeverCoversScaleBarAxisSignOrEdge) {
  int shown = 0;
  for (const float scale : {1.0f, 1.25f, 1.5f, 2.0f}) {
    for (int width = 120; width <= 1600; width += 37) {
      for (int height = 80; height <= 900; height += 41) {
        const glm::vec2 size(width, height);
        const std::vector<LegendBox> boxes = layoutLegends(size, scale, kFixed * scale, 2);
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          const LegendBox& box = boxes[i];
          EXPECT_GE(box.min.x, 0.0f);
          EXPECT_GE(box.min.y, 0.0f);
          EXPECT_LE(box.max.x, size.x);
          EXPECT_LE(box.max.y, size.y);
          EXPECT_GE(box.bar, kShortestLegendBar * scale);
          EXPECT_NEAR(box.max.y - box.min.y, box.bar + kFixed * scale, 0.01f);
          EXPECT_TRUE(apart(box.min, box.max, {0, size.y - kScaleBarHeight * scale}, {kScaleBarRoom * scale, size.y}))
              << width << " x " << height << " at " << scale;
          EXPECT_TRUE(apart(box.min, box.max, {size.x - kAxisSignRoom * scale, 0}, {size.x, kAxisSignRoom * scale}))
              << width << " x " << height << " at " << scale;
          for (std::size_t j = 0; j < i; ++j)
            EXPECT_TRUE(apart(box.min, box.max, boxes[j].min, boxes[j].max)) << width << " x " << height;
          ++shown;
        }
      }
    }
  }
  EXPECT_GT(shown, 1000);
}

TEST(LegendLayout, ShowsBothInAnOrdinaryViewport) {
  const std::vector<LegendBox> boxes = layoutLegends({740, 450}, 1.0f, kFixed, 2);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_EQ(boxes[0].bar, kLongestLegendBar);
  EXPECT_LT(boxes[1].max.x, boxes[0].min.x) << "beside each other";
}

TEST(LegendLayout, StacksWhereTheViewportIsNarrow) {
  const std::vector<LegendBox> boxes = layoutLegends({330, 620}, 1.0f, kFixed, 2);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_LT(boxes[1].max.y, boxes[0].min.y);
}

TEST(LegendLayout, ShowsNoneWhereNoneCouldBeRead) {
  EXPECT_TRUE(layoutLegends({740, 200}, 1.0f, kFixed, 1).empty());
  EXPECT_TRUE(layoutLegends({60, 900}, 1.0f, kFixed, 1).empty());
}

}  // namespace
}  // namespace windloom::editor
