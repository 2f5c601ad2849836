#include "engine/grass/grass_layout.hpp"

#include <gtest/gtest.h>

namespace windloom {
namespace {

GrassSettings grassOf(float density) {
  GrassSettings grass;
  grass.density = density;
  return grass;
}

/// Of a camera with a picture of 1080 rows and 45 degrees.
shared::FrameBlock frameFrom(glm::vec3 position) {
  shared::FrameBlock frame{};
  frame.cameraPosition = {position, 0.0f};
  frame.pixelScale.x = 1300.0f;
  return frame;
}

GrassBlock blockOf(const GrassSettings& grass, float detail) {
  return makeGrassBlock(grass, {}, makeGrassLayout({}, grass), {.detail = detail}, frameFrom({0.0f, 2.0f, 0.0f}));
}

TEST(GrassLayout, CountsOneToSevenMillionBlades) {
  EXPECT_EQ(makeGrassLayout({}, grassOf(100.0f)).bladesTotal, 1'000'000);
  EXPECT_EQ(makeGrassLayout({}, grassOf(700.0f)).bladesTotal, 7'000'000);
}

TEST(GrassLayout, CoversTheFieldAndItsMargin) {
  for (const glm::vec2 size : {glm::vec2(100.0f), glm::vec2(8.0f, 300.0f), glm::vec2(2000.0f, 50.0f)}) {
    FieldSettings field;
    field.centre = {3.0f, -7.0f};
    field.size = size;
    const GrassLayout layout = makeGrassLayout(field, grassOf(100.0f));
    const glm::vec2 low = layout.tileSideM * glm::vec2(layout.low), high = layout.tileSideM * glm::vec2(layout.high + 1);
    const glm::vec2 wantedLow = field.centre - 0.5f * size - kMeadowMarginM;
    const glm::vec2 wantedHigh = field.centre + 0.5f * size + kMeadowMarginM;
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_LE(low[axis], wantedLow[axis] + 1e-3f);
      EXPECT_GE(high[axis], wantedHigh[axis] - 1e-3f);
      EXPECT_GT(low[axis] + layout.tileSideM, wantedLow[axis] - 1e-3f) << "no tile too many";
      EXPECT_LE(layout.tiles()[axis], kMaxTilesPerSide);
    }
  }
}

TEST(GrassLayout, TilesAreCellsOfTheWorldWhereverTheFieldLies) {
  FieldSettings field;
  const GrassLayout before = makeGrassLayout(field, grassOf(100.0f));
  field.centre = {37.25f, -11.5f};
  const GrassLayout after = makeGrassLayout(field, grassOf(100.0f));
  EXPECT_EQ(after.tileSideM, before.tileSideM) << "tile (i, k) begins at (i, k) sides in both";
}

TEST(GrassLayout, BladesOfTheTilesMakeTheDensity) {
  for (const float density : {0.5f, 30.0f, 100.0f, 700.0f, 5000.0f}) {
    const GrassLayout layout = makeGrassLayout({}, grassOf(density));
    EXPECT_NEAR(layout.bladesInTile / (layout.tileSideM * layout.tileSideM), density, 1e-3f * density);
  }
}

TEST(GrassLayout, ChunksHoldEveryBladeOfTheTilesInSight) {
  const GrassSettings grass = grassOf(700.0f);
  const GrassLayout layout = makeGrassLayout({}, grass);
  const GrassBlock block = makeGrassBlock(grass, {}, layout, {.thinning = false}, frameFrom({0.0f, 2.0f, 0.0f}));
  const double tiles = static_cast<double>(layout.tiles().x) * layout.tiles().y;
  EXPECT_GE(chunksInRange(block) * GRASS_CHUNK, tiles * static_cast<double>(layout.bladesInTile));
}

TEST(GrassLayout, LooksAtFewTilesOfALargeMeadow) {
  FieldSettings field;
  field.size = {1000.0f, 1000.0f};
  const GrassSettings grass = grassOf(200.0f);
  const GrassLayout layout = makeGrassLayout(field, grass);
  EXPECT_EQ(layout.bladesTotal, 200'000'000);
  const GrassBlock block = makeGrassBlock(grass, {}, layout, {}, frameFrom({0.0f, 2.0f, 0.0f}));
  EXPECT_LE(tilesInRings(block), static_cast<std::uint32_t>(kMaxTilesPerSide * kMaxTilesPerSide));
  // Where the ground's shading has taken over no tile is looked at.
  const GrassBlock far = makeGrassBlock(grass, {}, layout, {}, frameFrom({9000.0f, 2.0f, 0.0f}));
  EXPECT_EQ(tilesInRings(far), 0u);
}

TEST(GrassLayout, NoDensityMeansNoTiles) {
  const GrassLayout layout = makeGrassLayout({}, grassOf(0.0f));
  EXPECT_TRUE(layout.empty());
  EXPECT_EQ(layout.bladesTotal, 0);
  EXPECT_EQ(tilesInRings(makeGrassBlock(grassOf(0.0f), {}, layout, {}, frameFrom({0.0f, 2.0f, 0.0f}))), 0u);
}

TEST(GrassCover, ThinsWithDistanceAndKeepsAllBladesClose) {
  const GrassSettings grass = grassOf(100.0f);
  const GrassBlock block = blockOf(grass, 1.0f);
  EXPECT_EQ(keptPart(block, 800.0f), 1.0f);
  float before = 1.0f;
  for (float pixels = 40.0f; pixels > 2.0f; pixels *= 0.8f) {
    const float kept = keptPart(block, pixels);
    EXPECT_LT(kept, before) << pixels;
    before = kept;
  }
  EXPECT_EQ(keptPart(block, 1.0f), 0.0f) << "the ground's shading takes over";
}

TEST(GrassCover, LowerDetailTakesFarBladesFirst) {
  const GrassSettings grass = grassOf(100.0f);
  const GrassBlock full = blockOf(grass, 1.0f), half = blockOf(grass, 0.5f);
  const float closePixels = 400.0f, farPixels = 20.0f;
  EXPECT_EQ(keptPart(half, closePixels), keptPart(full, closePixels));
  EXPECT_LT(keptPart(half, farPixels), 0.6f * keptPart(full, farPixels));
}

TEST(GrassBlockSettings, DoublingStiffnessHalvesTheBend) {
  GrassSettings grass;
  const float soft = blockOf(grass, 1.0f).motion.x;
  grass.stiffness = 2.0f;
  EXPECT_FLOAT_EQ(blockOf(grass, 1.0f).motion.x, 0.5f * soft);
}

}  // namespace
}  // namespace windloom
