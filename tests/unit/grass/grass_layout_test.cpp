#include "engine/grass/grass_layout.hpp"

#include <gtest/gtest.h>

namespace windloom {
namespace {

GrassSettings grassOf(float density) {
  GrassSettings grass;
  grass.density = density;
  return grass;
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
    const glm::vec2 high = layout.origin + layout.tileSideM * glm::vec2(layout.tiles);
    const glm::vec2 wantedLow = field.centre - 0.5f * size - kMeadowMarginM, wantedHigh = field.centre + 0.5f * size + kMeadowMarginM;
    EXPECT_LE(layout.origin.x, wantedLow.x + 1e-3f);
    EXPECT_LE(layout.origin.y, wantedLow.y + 1e-3f);
    EXPECT_GE(high.x, wantedHigh.x - 1e-3f);
    EXPECT_GE(high.y, wantedHigh.y - 1e-3f);
  }
}

TEST(GrassLayout, BladesOfTheTilesMakeTheDensity) {
  for (const float density : {0.5f, 30.0f, 100.0f, 700.0f, 5000.0f}) {
    const GrassLayout layout = makeGrassLayout({}, grassOf(density));
    EXPECT_NEAR(layout.bladesInTile / (layout.tileSideM * layout.tileSideM), density, 1e-3f * density);
  }
}

TEST(GrassLayout, ListsHoldEveryChunkThereCanBe) {
  const GrassLayout layout = makeGrassLayout({}, grassOf(700.0f));
  const auto most = static_cast<std::uint32_t>(layout.bladesInTile) + 1u;
  EXPECT_EQ(layout.chunkLimit, static_cast<std::uint32_t>(layout.tiles.x * layout.tiles.y) * ((most + GRASS_CHUNK - 1u) / GRASS_CHUNK));
}

TEST(GrassLayout, MemoryStaysBoundedForTheLargestMeadow) {
  FieldSettings field;
  field.size = {1000.0f, 1000.0f};
  const GrassLayout layout = makeGrassLayout(field, grassOf(200.0f));
  EXPECT_EQ(layout.bladesTotal, 200'000'000);
  const std::size_t blades = static_cast<std::size_t>(layout.capacity.x) + layout.capacity.y + layout.capacity.z;
  EXPECT_LE(blades * sizeof(shared::GrassBlade), 160u << 20u);
  EXPECT_LE(layout.chunkLimit * sizeof(shared::GrassChunk), 160u << 20u);
}

TEST(GrassLayout, NoDensityMeansNoTiles) {
  const GrassLayout layout = makeGrassLayout({}, grassOf(0.0f));
  EXPECT_EQ(layout.chunkLimit, 0u);
  EXPECT_EQ(layout.bladesTotal, 0);
}

TEST(GrassCover, ThinsWithDistanceAndKeepsAllBladesClose) {
  const GrassSettings grass = grassOf(100.0f);
  const GrassBlock block = makeGrassBlock(grass, makeGrassLayout({}, grass), 1.0f);
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
  const GrassLayout layout = makeGrassLayout({}, grass);
  const GrassBlock full = makeGrassBlock(grass, layout, 1.0f), half = makeGrassBlock(grass, layout, 0.5f);
  const float closePixels = 400.0f, farPixels = 20.0f;
  EXPECT_EQ(keptPart(half, closePixels), keptPart(full, closePixels));
  EXPECT_LT(keptPart(half, farPixels), 0.6f * keptPart(full, farPixels));
}

TEST(GrassBlockSettings, DoublingStiffnessHalvesTheBend) {
  GrassSettings grass;
  const GrassLayout layout = makeGrassLayout({}, grass);
  const float soft = makeGrassBlock(grass, layout, 1.0f).motion.x;
  grass.stiffness = 2.0f;
  EXPECT_FLOAT_EQ(makeGrassBlock(grass, layout, 1.0f).motion.x, 0.5f * soft);
}

}  // namespace
}  // namespace windloom
