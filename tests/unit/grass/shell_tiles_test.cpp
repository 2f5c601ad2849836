// Which tiles of the ground carry shells.
#include "engine/grass/shell_tiles.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windloom {
namespace {

constexpr float kSide = 100.0f;
const ShellGround kGround{glm::vec2(-0.5f * kSide), glm::vec2(0.5f * kSide), nullptr, 0.6f};

/// All of the world in sight of an eye.
shared::FrameBlock everywhere(glm::vec3 eye) {
  shared::FrameBlock frame{};
  frame.cameraPosition = {eye, 0.0f};
  frame.pixelScale.x = 930.0f;
  for (glm::vec4& plane : frame.frustum) plane = {0, 1, 0, 1e6f};
  return frame;
}

double areaOf(const std::vector<ShellTile>& tiles) {
  double area = 0;
  for (const ShellTile& tile : tiles) {
    const glm::vec2 size = glm::min(tile.low + tile.side, kGround.high) - glm::max(tile.low, kGround.low);
    area += static_cast<double>(size.x) * static_cast<double>(size.y);
  }
  return area;
}

const ShellTile* tileAt(const std::vector<ShellTile>& tiles, glm::vec2 place) {
  const ShellTile* found = nullptr;
  for (const ShellTile& tile : tiles) {
    if (glm::all(glm::greaterThanEqual(place, tile.low)) && glm::all(glm::lessThan(place, tile.low + tile.side))) {
      EXPECT_EQ(found, nullptr) << "two tiles at " << place.x << ", " << place.y;
      found = &tile;
    }
  }
  return found;
}

TEST(ShellTiles, CoverTheGroundOnceNearOnesFirst) {
  for (const glm::vec3 eye : {glm::vec3(0, 1.7f, 0), glm::vec3(30, 12, -20), glm::vec3(300, 80, 300)}) {
    const std::vector<ShellTile> tiles = selectShellTiles(kGround, everywhere(eye), 1e9f);
    EXPECT_NEAR(areaOf(tiles), static_cast<double>(kSide) * static_cast<double>(kSide), 1e-2);
    for (float x = -49.7f; x < 50; x += 7.3f) {
      for (float z = -49.1f; z < 50; z += 6.1f) ASSERT_NE(tileAt(tiles, {x, z}), nullptr);
    }
    EXPECT_TRUE(std::ranges::is_sorted(tiles, {}, &ShellTile::nearest));
  }
}

TEST(ShellTiles, AreFineNearTheEyeAndNeighboursDifferByOneStep) {
  const glm::vec3 eye(3, 1.7f, 4);
  const std::vector<ShellTile> tiles = selectShellTiles(kGround, everywhere(eye), 1e9f);
  EXPECT_FLOAT_EQ(tiles.front().side, 1.0f);
  for (const ShellTile& tile : tiles) {
    if (tile.side > 1) {
      EXPECT_GE(tile.nearest, 0.5f * SHELL_TILE_REACH * tile.side) << "else it had been divided";
    }
    // A tile ends before the coarser one behind it begins to change.
    EXPECT_LE(tile.farthest, 2.0f * SHELL_MORPH_BEGIN * SHELL_TILE_REACH * tile.side);
    for (const glm::vec2 way :
         {glm::vec2(-0.01f, 0.5f), glm::vec2(1.01f, 0.5f), glm::vec2(0.5f, -0.01f), glm::vec2(0.5f, 1.01f)}) {
      const ShellTile* next = tileAt(tiles, tile.low + way * tile.side);
      if (next == nullptr) continue;
      EXPECT_GE(next->side, 0.5f * tile.side);
      EXPECT_LE(next->side, 2.0f * tile.side);
    }
  }
}

TEST(ShellTiles, LeaveOutWhatIsBehindTheEyeOrTooFar) {
  shared::FrameBlock frame = everywhere({0, 2, 0});
  frame.frustum[0] = {1, 0, 0, 0};  // only x > 0
  const std::vector<ShellTile> ahead = selectShellTiles(kGround, frame, 1e9f);
  const std::vector<ShellTile> near = selectShellTiles(kGround, everywhere({0, 2, 0}), 20.0f);
  ASSERT_FALSE(ahead.empty());
  ASSERT_FALSE(near.empty());
  for (const ShellTile& tile : ahead) EXPECT_GT(tile.low.x + tile.side, -0.6f);
  for (const ShellTile& tile : near) EXPECT_LE(tile.nearest, 20.0f);
}

TEST(ShellTiles, AreAllAlikeWhereProjectionIsParallel) {
  shared::FrameBlock frame = everywhere({0, 50, 0});
  frame.cameraPosition.w = 1.0f;
  frame.pixelScale.x = 20.0f;
  const std::vector<ShellTile> tiles = selectShellTiles(kGround, frame, 1e9f);
  ASSERT_GT(tiles.size(), 4u);
  for (const ShellTile& tile : tiles) EXPECT_EQ(tile.side, tiles.front().side);
}

TEST(GrowthMask, FindsWhereNothingGrows) {
  GrassMap map;
  map.size = {300, 200};
  map.pixels.assign(4u * 300 * 200, 0);
  for (int y = 0; y < 200; ++y) {
    for (int x = 150; x < 300; ++x)
      map.pixels[4 * (static_cast<std::size_t>(y) * 300 + static_cast<std::size_t>(x))] = 7;
  }
  const GrowthMask mask(&map, {-50, -50}, {100, 100});
  EXPECT_FALSE(mask.grows({-40, -40}, {-10, 40}));
  EXPECT_TRUE(mask.grows({-40, -40}, {1, 40}));
  EXPECT_TRUE(mask.grows({10, -40}, {40, 40}));
  EXPECT_TRUE(mask.grows({-70, -40}, {-40, 40})) << "beyond the field";
  EXPECT_TRUE(GrowthMask(nullptr, {-50, -50}, {100, 100}).grows({-40, -40}, {-10, 40}));
}

}  // namespace
}  // namespace windloom
