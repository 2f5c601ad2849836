#include <gtest/gtest.h>

#include <cmath>

#include "engine/render/frame_renderer.hpp"

namespace windloom {
namespace {

float linear(float s) { return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f); }

/// CIE lightness 0..100.
float lightness(glm::vec3 c) {
  const float y = 0.2126f * linear(c.x) + 0.7152f * linear(c.y) + 0.0722f * linear(c.z);
  return y > 0.008856f ? 116.0f * std::cbrt(y) - 16.0f : 903.3f * y;
}

TEST(SpeedColour, GrowsLighterEvenly) {
  float before = lightness(speedColour(0.0f));
  for (int i = 1; i <= 8; ++i) {
    const float now = lightness(speedColour(static_cast<float>(i) / 8.0f));
    EXPECT_GT(now - before, 4.0f) << i;
    EXPECT_LT(now - before, 17.0f) << i;
    before = now;
  }
}

TEST(SpeedColour, ClampsItsRange) {
  EXPECT_EQ(speedColour(-3.0f), speedColour(0.0f));
  EXPECT_EQ(speedColour(7.0f), speedColour(1.0f));
}

}  // namespace
}  // namespace windloom
