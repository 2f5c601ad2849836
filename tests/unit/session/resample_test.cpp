#include "engine/session/resample.hpp"

#include <gtest/gtest.h>

namespace windloom {
namespace {

std::vector<glm::vec2> noise(glm::ivec2 resolution) {
  std::vector<glm::vec2> field(static_cast<std::size_t>(resolution.x * resolution.y));
  unsigned state = 7;
  const auto next = [&] {
    return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0f - 0.25f;
  };
  for (glm::vec2& v : field) v = {next(), 10.0f * next()};
  return field;
}

glm::dvec2 meanOf(const std::vector<glm::vec2>& field) {
  glm::dvec2 sum(0);
  for (const glm::vec2 v : field) sum += glm::dvec2(v);
  return sum / static_cast<double>(field.size());
}

std::vector<glm::vec2> resampled(const std::vector<glm::vec2>& field, glm::ivec2 from, glm::ivec2 to) {
  std::vector<glm::vec2> out;
  Resampler(from, to).apply(field, out);
  return out;
}

}  // namespace

TEST(Resampler, KeepsTheMeanWhenCellsMerge) {
  const glm::ivec2 from(100, 37);
  const std::vector<glm::vec2> field = noise(from);
  for (const glm::ivec2 to : {glm::ivec2(50, 37), glm::ivec2(33, 10), glm::ivec2(1, 1), glm::ivec2(99, 36)}) {
    const glm::dvec2 difference = meanOf(resampled(field, from, to)) - meanOf(field);
    EXPECT_NEAR(difference.x, 0.0, 1e-6) << to.x;
    EXPECT_NEAR(difference.y, 0.0, 1e-5) << to.x;
  }
}

TEST(Resampler, AveragesWholeCells) {
  const std::vector<glm::vec2> field = {{1, 0}, {3, 0}, {5, 1}, {7, 1}, {1, 2}, {3, 2}, {5, 5}, {7, 5}};
  const std::vector<glm::vec2> out = resampled(field, {4, 2}, {2, 1});
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0], glm::vec2(2, 1));
  EXPECT_EQ(out[1], glm::vec2(6, 3));
}

TEST(Resampler, WeighsCellsByTheirCover) {
  // Three cells to two: each new one holds one and a half.
  const std::vector<glm::vec2> out = resampled({{0, 0}, {3, 0}, {9, 0}}, {3, 1}, {2, 1});
  EXPECT_FLOAT_EQ(out[0].x, 1.0f);
  EXPECT_FLOAT_EQ(out[1].x, 7.0f);
}

TEST(Resampler, InterpolatesWhereCellsSplit) {
  const std::vector<glm::vec2> out = resampled({{0, 0}, {4, 0}}, {2, 1}, {4, 1});
  EXPECT_FLOAT_EQ(out[0].x, 0.0f);
  EXPECT_FLOAT_EQ(out[1].x, 1.0f);
  EXPECT_FLOAT_EQ(out[2].x, 3.0f);
  EXPECT_FLOAT_EQ(out[3].x, 4.0f);
  for (const glm::vec2 v : resampled({{2, -1}}, {1, 1}, {5, 3})) EXPECT_EQ(v, glm::vec2(2, -1));
}

TEST(Resampler, LeavesAConstantFieldAsItIs) {
  const std::vector<glm::vec2> field(64 * 48, glm::vec2(1.5f, -2.0f));
  for (const glm::vec2 v : resampled(field, {64, 48}, {37, 90})) {
    EXPECT_NEAR(v.x, 1.5f, 1e-6f);
    EXPECT_NEAR(v.y, -2.0f, 1e-6f);
  }
}

TEST(Resampler, GoesOnAtTheOtherEndWhereTheFieldRepeats) {
  const std::vector<glm::vec2> field = {{0, 0}, {4, 0}, {8, 0}, {4, 8}};
  std::vector<glm::vec2> out;
  Resampler({4, 1}, {8, 1}, {true, false}).apply(field, out);
  ASSERT_EQ(out.size(), 8u);
  EXPECT_EQ(out[0], glm::vec2(1, 2)) << "a quarter of the last cell";
  EXPECT_EQ(out[7], glm::vec2(3, 6)) << "a quarter of the first cell";
  EXPECT_EQ(out[3], glm::vec2(5, 0));
  Resampler({4, 1}, {8, 1}).apply(field, out);
  EXPECT_EQ(out[0], glm::vec2(0, 0));
}

}  // namespace windloom
