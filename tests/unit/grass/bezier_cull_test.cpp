// Tests that leave blades out: Jahrmann & Wimmer, 2017, eq. 17-20.
#include "shaders/shared/bezier_cull.h"

#include <gtest/gtest.h>

namespace windloom {
namespace {

using namespace shared;

TEST(BezierCull, LeavesOutBladesSeenEdgeOnAsThePaperMeans) {
  const glm::vec3 sight(0.0f, 0.0f, -1.0f);
  const auto seen = [&](float cosine) {
    return seenFromSide({std::sqrt(1.0f - cosine * cosine), 0.0f, cosine}, sight, 0.9f);
  };
  EXPECT_EQ(seen(0.95f), 0.0f);
  EXPECT_EQ(seen(-0.95f), 0.0f);
  EXPECT_EQ(seen(0.7f), 1.0f);
  EXPECT_GT(seen(0.85f), 0.0f) << "a blade fades before it is gone";
  EXPECT_LT(seen(0.85f), 1.0f);
  EXPECT_EQ(seenFromSide({0.0f, 0.0f, 1.0f}, sight, 1.0f), 1.0f) << "a limit of 1 switches the test off";
}

TEST(BezierCull, MeasuresTheDistanceOverTheGround) {
  EXPECT_NEAR(distanceOverGround({3.0f, 0.0f, 4.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 50.0f, 0.0f}), 5.0f, 1e-4f);
  EXPECT_NEAR(distanceOverGround({3.0f, 7.0f, 4.0f}, {1.0f, 0.0f, 0.0f}, {9.0f, 7.0f, 4.0f}), 0.0f, 1e-4f);
}

TEST(BezierCull, KeepsThePartOfThePaper) {
  // Eq. 20: of n levels those below n (1 - d / d_max) are kept.
  for (const float distance : {0.0f, 10.0f, 40.0f, 79.0f, 80.0f, 200.0f}) {
    const float kept = keptAtDistance(distance, 80.0f, 100.0f, 0.5f);
    EXPECT_NEAR(kept, std::max(1.0f - distance / 80.0f, 0.0f), 1e-6f);
    int full = 0, any = 0;
    for (int blade = 0; blade < 1000; ++blade) {
      const float grown = grownAtRank((static_cast<float>(blade) + 0.5f) / 1000.0f, kept, 8.0f);
      full += grown >= 1.0f ? 1 : 0;
      any += grown > 0.0f ? 1 : 0;
    }
    const float band = 1.0f / 8.0f;
    EXPECT_LE(static_cast<float>(full) / 1000.0f, kept + 1e-3f);
    EXPECT_GE(static_cast<float>(any) / 1000.0f, kept - 1e-3f);
    EXPECT_NEAR(static_cast<float>(any - full) / 1000.0f,
                std::min(band, std::min(kept * (1.0f + band), std::max(1.0f - kept, 0.0f))), 0.02f);
  }
}

TEST(BezierCull, NoBladePopsAsTheDistanceGrows) {
  const auto width = [](float distance) {
    return grownAtRank(0.37f, keptAtDistance(distance, 80.0f, 100.0f, 0.5f), 8.0f);
  };
  float before = width(0.0f), largest = 0.0f;
  for (float distance = 0.1f; distance < 80.0f; distance += 0.1f) {
    largest = std::max(largest, std::abs(width(distance) - before));
    before = width(distance);
  }
  EXPECT_LT(largest, 0.02f);
  EXPECT_EQ(before, 0.0f);
}

TEST(BezierCull, WhatIsKeptCoversAsMuchAsAllBlades) {
  for (const float kept : {0.25f, 0.5f, 0.75f, 0.95f, 1.0f}) {
    double cover = 0;
    for (int blade = 0; blade < 10000; ++blade)
      cover += static_cast<double>(grownAtRank((static_cast<float>(blade) + 0.5f) / 10000.0f, kept, 8.0f));
    cover *= static_cast<double>(keptWidening(kept, 8.0f)) / 10000.0;
    EXPECT_NEAR(cover, 1.0, 1e-3) << kept;
  }
  EXPECT_LE(keptWidening(0.01f, 8.0f), BEZIER_MOST_WIDENING);
}

TEST(BezierCull, ThinsBladesTooNarrowToBeSeen) {
  EXPECT_FLOAT_EQ(keptAtDistance(0.0f, 80.0f, 0.25f, 0.5f), 0.5f);
  EXPECT_FLOAT_EQ(keptAtDistance(0.0f, 80.0f, 0.75f, 0.5f), 1.0f);
  EXPECT_FLOAT_EQ(keptAtDistance(0.0f, 80.0f, 0.01f, 0.0f), 1.0f) << "0 pixels: never";
}

}  // namespace
}  // namespace windloom
