#include "engine/bake/atlas_layout.hpp"

#include <gtest/gtest.h>

#include "engine/bake/writers.hpp"

namespace windloom {

TEST(AtlasLayout, IsAsSquareAsCanBe) {
  EXPECT_EQ(atlasTiles(64, {256, 256}), glm::ivec2(8, 8));
  EXPECT_EQ(atlasTiles(16, {200, 50}), glm::ivec2(2, 8));
  EXPECT_EQ(atlasTiles(1, {1000, 10}), glm::ivec2(1, 1));
  EXPECT_EQ(atlasTiles(2, {64, 64}), glm::ivec2(2, 1));
}

TEST(AtlasLayout, PrefersNoEmptyTilesOverALittleSquareness) {
  EXPECT_EQ(atlasTiles(60, {256, 256}), glm::ivec2(10, 6));
  EXPECT_EQ(atlasTiles(24, {64, 64}), glm::ivec2(6, 4));
  EXPECT_EQ(atlasTiles(61, {256, 256}), glm::ivec2(8, 8));  // a prime number: a full row would be a strip
}

TEST(AtlasLayout, StaysWithinTheGreatestSide) {
  EXPECT_EQ(atlasTiles(64, {2048, 2048}), glm::ivec2(8, 8));
  EXPECT_EQ(atlasTiles(4, {8192, 8192}), glm::ivec2(2, 2));
  EXPECT_EQ(atlasTiles(65, {2048, 2048}), std::nullopt);
  EXPECT_EQ(atlasTiles(5, {8192, 8192}), std::nullopt);
  for (int frames = 1; frames < 400; ++frames) {
    const auto tiles = atlasTiles(frames, {700, 900});
    if (frames > 23 * 18) break;
    ASSERT_TRUE(tiles) << frames;
    EXPECT_GE(tiles->x * tiles->y, frames);
    EXPECT_LT(tiles->x * (tiles->y - 1), frames) << "no row without a frame";
    EXPECT_LE(tiles->x * 700, kMaxAtlasSide);
    EXPECT_LE(tiles->y * 900, kMaxAtlasSide);
  }
}

TEST(AtlasLayout, SaysHowManyFramesWouldFit) {
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, {100, 100}, {2048, 2048});
  header.frames = 64;
  EXPECT_EQ(atlasRefusal(header), "");
  header.frames = 65;
  EXPECT_NE(atlasRefusal(header).find("holds 64 frames of 2048 x 2048, not 65"), std::string::npos);
  const auto opened = openAtlasWriter(header, "/nowhere");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().kind, ErrorKind::BadInput);
}

}  // namespace windloom
