#include "shaders/shared/grass_density.h"

#include <gtest/gtest.h>

#include <cmath>

namespace windloom {
namespace {

using namespace shared;

TEST(GrassDensity, ContourGainIsBelyaevsG) {
  for (double x = 0; x <= 1.0; x += 0.01) {
    EXPECT_NEAR(double(contourGain(float(x), 1.0f)), x + std::pow(1 - x, 8), 2e-6);
  }
  EXPECT_EQ(contourGain(-0.3f, 1.0f), 1.0f) << "ground seen from behind counts as its contour";
}

TEST(GrassDensity, ContoursStayDenserThanSlopes) {
  EXPECT_GT(contourGain(0.0f, 0.05f), 0.0f);
  EXPECT_GT(contourGain(0.0f, 1.0f), contourGain(0.3f, 1.0f));
}

TEST(GrassDensity, ThinningKeepsTheCover) {
  // Blades left times their widening cover as much as all did, until the widening ends.
  const float least = 1.35f, most = 5.0f;
  for (float pixels = 3.0f; pixels > least / most; pixels *= 0.9f) {
    const float kept = std::min(keptTogether(1e6f, pixels / least), 1.0f);
    EXPECT_NEAR(kept * widening(pixels, least, most), 1.0f, 1e-4f) << pixels << " pixels wide";
  }
}

TEST(GrassDensity, NeverKeepsMoreThanEitherPartAllows) {
  for (float layers = 0.05f; layers < 3.0f; layers += 0.1f) {
    for (float width = 0.05f; width < 3.0f; width += 0.1f) {
      const float kept = keptTogether(layers, width);
      EXPECT_LE(kept, layers);
      EXPECT_LE(kept, width);
      if (layers >= 1.0f && width >= 1.0f) {
        EXPECT_GE(kept, 1.0f);
      }
      EXPECT_LE(kept, keptTogether(layers + 0.1f, width) + 1e-6f);
      EXPECT_LE(kept, keptTogether(layers, width + 0.1f) + 1e-6f);
    }
  }
}

TEST(GrassDensity, BladesKeptDependOnLayersNotOnDensity) {
  const float gain = contourGain(0.2f, 0.05f);
  const float sparse = 1.2f, dense = 8.5f;
  EXPECT_NEAR(sparse * keptByLayers(gain, sparse, 6.0f), dense * keptByLayers(gain, dense, 6.0f), 1e-5f);
}

TEST(GrassDensity, FadesSmoothlyIntoTheGround) {
  EXPECT_EQ(keptByHeight(0.5f, 2.2f), 0.0f);
  EXPECT_EQ(keptByHeight(5.0f, 2.2f), 1.0f);
  float before = 0.0f;
  for (float pixels = 0.5f; pixels < 5.0f; pixels += 0.05f) {
    const float kept = keptByHeight(pixels, 2.2f);
    EXPECT_GE(kept, before);
    EXPECT_LT(kept - before, 0.04f);
    before = kept;
  }
}

}  // namespace
}  // namespace windloom
