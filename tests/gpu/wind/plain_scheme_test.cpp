#include "engine/wind/plain_scheme.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/gpu/gpu_test.hpp"

namespace windloom {
namespace {

class PlainGpuScheme : public windloom::testing::GpuTest {};

/// A purely divergent mode: the gradient of a cosine of this wavelength along x, m.
std::vector<glm::vec2> divergentMode(glm::ivec2 cells, double wavelength) {
  std::vector<glm::vec2> field;
  for (int k = 0; k < cells.y; ++k) {
    for (int i = 0; i < cells.x; ++i) {
      field.emplace_back(static_cast<float>(std::sin(2 * std::numbers::pi * (i + 0.5) / wavelength)), 0.0f);
    }
  }
  return field;
}

TEST_F(PlainGpuScheme, CompilesAndRunsItsDispatches) {
  ASSERT_TRUE(shaders().loadAll(plainPrograms()).ok());
  auto scheme = PlainScheme::create(shaders(), {64, 48});
  ASSERT_TRUE(scheme.ok()) << scheme.error().text();
  for (int n = 0; n < 10; ++n) scheme->step(1.0f / 60);
  const auto [before, after] = scheme->measureStep(1.0f / 60);
  EXPECT_GT(before, 0);
  EXPECT_LT(after, before);
}

TEST_F(PlainGpuScheme, LeavesLongWavesInPlaceAndTakesShortOnes) {
  auto scheme = PlainScheme::create(shaders(), {128, 128});
  ASSERT_TRUE(scheme.ok());
  const auto left = [&](double wavelength) {
    scheme->setVelocity(divergentMode({128, 128}, wavelength));
    const auto [before, after] = scheme->measureProjection();
    return after / before;
  };
  EXPECT_GT(left(128), 0.8);
  EXPECT_LT(left(8), 0.3);
}

TEST(PlainJacobiSweep, IsTheFivePointFormula) {
  ThreadPool pool(2);
  const std::vector<float> p = {1, 2, 3, 4, 5, 6, 7, 8, 9}, divergence = {0, 0, 0, 0, 4, 0, 0, 0, 8};
  std::vector<float> next(9);
  plainJacobiSweep(pool, 3, 3, p, divergence, next);
  EXPECT_EQ(next[4], 0.25f * (4 + 6 + 2 + 8 - 4));
  EXPECT_EQ(next[0], 0.25f * (2 + 4));
  EXPECT_EQ(next[8], 0.25f * (8 + 6 - 8));
}

}  // namespace
}  // namespace windloom
