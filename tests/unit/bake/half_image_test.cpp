#include "engine/bake/half_image.hpp"

#include <gtest/gtest.h>

#include "engine/bake/half.hpp"

namespace windloom {
namespace {

BakeHeader header(glm::ivec2 resolution, Preset preset = Preset::Generic) {
  BakeHeader made;
  made.grid = makeGridMapping({0, 0}, {10, 10}, resolution);
  made.preset = preset;
  return made;
}

std::vector<std::uint16_t> halves(HalfLayout layout, const BakeHeader& of, const std::vector<glm::vec2>& cells) {
  HalfImage image(of, layout);
  const std::span<const std::uint16_t> found = image.of(cells);
  return {found.begin(), found.end()};
}

std::vector<std::uint16_t> expected(std::initializer_list<float> values) {
  std::vector<std::uint16_t> found;
  for (const float value : values) found.push_back(halfFromFloat(value));
  return found;
}

const std::vector<glm::vec2> kCells = {{3, 4}, {-6, 8}, {0, 0}, {5, -12}};

}  // namespace

TEST(HalfImage, LaysOutComponentsAsAsked) {
  const BakeHeader two = header({2, 2});
  EXPECT_EQ(halves(HalfLayout::Rg, two, kCells), expected({3, 4, -6, 8, 0, 0, 5, -12}));
  EXPECT_EQ(halves(HalfLayout::Rgba, two, kCells), expected({3, 4, 5, 1, -6, 8, 10, 1, 0, 0, 0, 1, 5, -12, 13, 1}));
  EXPECT_EQ(halves(HalfLayout::RowsBgr, two, kCells), expected({5, 10, 4, 8, 3, -6, 0, 13, 0, -12, 0, 5}));
}

TEST(HalfImage, IsInThePresetsFrameAndUnit) {
  EXPECT_EQ(halves(HalfLayout::Rg, header({2, 2}, Preset::Unreal), kCells),
            expected({300, 400, -600, 800, 0, 0, 500, -1200}));
  EXPECT_EQ(halves(HalfLayout::Rg, header({2, 2}, Preset::Unity), kCells), expected({-5, -12, -0.0f, 0, 6, 8, -3, 4}));
}

TEST(HalfImage, NeverHoldsInfinity) {
  const std::vector<std::uint16_t> found = halves(HalfLayout::Rgba, header({1, 1}), {{1e6f, -1e6f}});
  EXPECT_EQ(found, (std::vector<std::uint16_t>{0x7bff, 0xfbff, 0x7bff, 0x3c00}));
}

TEST(HalfImage, KnowsItsLongestVector) {
  HalfImage image(header({2, 2}, Preset::Unreal), HalfLayout::RowsBgr);
  (void)image.of(kCells);
  EXPECT_FLOAT_EQ(image.longest(), 1300);
  EXPECT_EQ(image.target().unit(), "cm/s");
}

}  // namespace windloom
