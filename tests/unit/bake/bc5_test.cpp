#include "engine/bake/bc5.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace windloom {
namespace {

/// One channel of a block after the definition of BC4: 0 to 255.
double decoded(std::span<const std::byte> block, int channel, int pixel) {
  const auto byte = [&](int i) { return static_cast<unsigned>(block[static_cast<std::size_t>(8 * channel + i)]); };
  std::uint64_t bits = 0;
  for (int i = 0; i < 6; ++i) bits |= static_cast<std::uint64_t>(byte(2 + i)) << (8 * i);
  const auto index = static_cast<int>(bits >> (3 * pixel) & 7);
  const double first = byte(0), last = byte(1);
  if (index < 2) return index == 0 ? first : last;
  if (first > last) return ((8 - index) * first + (index - 1) * last) / 7;
  if (index > 5) return index == 6 ? 0 : 255;
  return ((6 - index) * first + (index - 1) * last) / 5;
}

std::vector<std::byte> encoded(const std::vector<std::uint8_t>& codes, glm::ivec2 resolution) {
  const glm::ivec2 blocks = bc5Blocks(resolution);
  std::vector<std::byte> out(static_cast<std::size_t>(blocks.x * blocks.y * kBc5BytesPerBlock));
  encodeBc5(codes, resolution, out);
  return out;
}

}  // namespace

TEST(Bc5, CountsBlocksUpToTheEdge) {
  EXPECT_EQ(bc5Blocks({1, 1}), glm::ivec2(1, 1));
  EXPECT_EQ(bc5Blocks({4, 5}), glm::ivec2(1, 2));
  EXPECT_EQ(bc5Blocks({256, 1000}), glm::ivec2(64, 250));
}

TEST(Bc5, StillAirStaysExact) {
  const std::vector<std::byte> block = encoded(std::vector<std::uint8_t>(32, 128), {4, 4});
  for (int pixel = 0; pixel < 16; ++pixel) {
    EXPECT_EQ(decoded(block, 0, pixel), 128);
    EXPECT_EQ(decoded(block, 1, pixel), 128);
  }
}

TEST(Bc5, KeepsChannelsApartAndPixelsInPlace) {
  std::vector<std::uint8_t> codes(32);
  for (int pixel = 0; pixel < 16; ++pixel) {
    codes[static_cast<std::size_t>(2 * pixel)] = static_cast<std::uint8_t>(10 + 14 * (pixel % 8));
    codes[static_cast<std::size_t>(2 * pixel + 1)] = static_cast<std::uint8_t>(200 - 7 * (pixel / 2));
  }
  const std::vector<std::byte> block = encoded(codes, {4, 4});
  for (int pixel = 0; pixel < 16; ++pixel) {
    EXPECT_NEAR(decoded(block, 0, pixel), codes[static_cast<std::size_t>(2 * pixel)], 0.6) << pixel;
    EXPECT_NEAR(decoded(block, 1, pixel), codes[static_cast<std::size_t>(2 * pixel + 1)], 0.6) << pixel;
  }
}

TEST(Bc5, RepeatsTheEdgeInBlocksThatReachOverIt) {
  // 5 x 6 pixels: the second column of blocks has one column of pixels, the second row of blocks two.
  std::vector<std::uint8_t> codes;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 5; ++column) {
      codes.push_back(static_cast<std::uint8_t>(100 + column));
      codes.push_back(static_cast<std::uint8_t>(100 + row));
    }
  }
  const std::vector<std::byte> out = encoded(codes, {5, 6});
  ASSERT_EQ(out.size(), 4u * 16);
  const std::span<const std::byte> last(out.data() + 48, 16);
  for (int pixel = 0; pixel < 16; ++pixel) {
    EXPECT_EQ(decoded(last, 0, pixel), 104) << "the only column, repeated";
    EXPECT_EQ(decoded(last, 1, pixel), pixel < 4 ? 104 : 105) << "the last row, repeated";
  }
}

}  // namespace windloom
