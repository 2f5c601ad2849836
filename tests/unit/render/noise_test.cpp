#include "engine/render/noise_texture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace windloom {
namespace {

int texel(const std::vector<std::uint8_t>& noise, int x, int y, int channel) {
  const auto wrap = [](int v) { return static_cast<std::size_t>((v + kNoiseSide) % kNoiseSide); };
  return noise[(wrap(y) * kNoiseSide + wrap(x)) * 4 + static_cast<std::size_t>(channel)];
}

TEST(Noise, ChannelsAreCentredAndSpread) {
  const std::vector<std::uint8_t> noise = makeNoise();
  for (int channel = 0; channel < 4; ++channel) {
    double sum = 0, squares = 0;
    for (int i = 0; i < kNoiseSide * kNoiseSide; ++i) {
      const double value = noise[static_cast<std::size_t>(i) * 4 + static_cast<std::size_t>(channel)];
      sum += value;
      squares += value * value;
    }
    const double mean = sum / (kNoiseSide * kNoiseSide);
    EXPECT_NEAR(mean, 127.5, 4.0) << channel;
    EXPECT_GT(std::sqrt(squares / (kNoiseSide * kNoiseSide) - mean * mean), 40.0) << channel;
  }
}

TEST(Noise, TilesWithoutASeam) {
  const std::vector<std::uint8_t> noise = makeNoise();
  for (int channel = 0; channel < 4; ++channel) {
    int seam = 0, inner = 0;
    for (int y = 0; y < kNoiseSide; ++y) {
      seam = std::max(seam, std::abs(texel(noise, -1, y, channel) - texel(noise, 0, y, channel)));
      for (int x = 0; x + 1 < kNoiseSide; ++x) inner = std::max(inner, std::abs(texel(noise, x, y, channel) - texel(noise, x + 1, y, channel)));
    }
    EXPECT_LE(seam, inner) << channel;
  }
}

}  // namespace
}  // namespace windloom
