#include "engine/io/picture_compare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

// As in tests/data/reference/ssim.py, which gave the expected numbers.
constexpr int kWidth = 23, kHeight = 17;

FloatImage noise(unsigned state) {
  FloatImage image(kWidth, kHeight, 1);
  for (float& sample : image.pixels) sample = static_cast<float>((state = state * 1664525u + 1013904223u) >> 24);
  return image;
}

FloatImage ramp() {
  FloatImage image(kWidth, kHeight, 1);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) *image.at(x, y) = static_cast<float>((9 * x + 5 * y) % 256);
  }
  return image;
}

FloatImage moved(const FloatImage& image) {
  FloatImage result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) *result.at(x, y) = *image.at(std::max(x - 1, 0), y);
  }
  return result;
}

FloatImage halved(FloatImage image) {
  for (float& sample : image.pixels) sample = std::floor(sample / 2);
  return image;
}

FloatImage plain(float value) {
  FloatImage image(kWidth, kHeight, 1);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

TEST(PictureCompare, EqualPicturesAreWhollySimilar) {
  EXPECT_DOUBLE_EQ(meanSsim(noise(1), noise(1)), 1.0);
  EXPECT_DOUBLE_EQ(meanSsim(plain(0), plain(0)), 1.0);
  EXPECT_EQ(largestLocalError(noise(1), noise(1), 16), 0.0);
}

TEST(PictureCompare, SimilarityIsThatOfThePlainReference) {
  EXPECT_NEAR(meanSsim(noise(1), noise(2)), -0.184083314, 1e-8);
  EXPECT_NEAR(meanSsim(noise(1), moved(noise(1))), -0.217716714, 1e-8);
  EXPECT_NEAR(meanSsim(ramp(), noise(1)), 0.038566373, 1e-8);
  EXPECT_NEAR(meanSsim(ramp(), moved(ramp())), 0.995819169, 1e-8);
  EXPECT_NEAR(meanSsim(ramp(), halved(ramp())), 0.664670325, 1e-8);
}

TEST(PictureCompare, SimilarityDoesNotDependOnTheOrder) {
  EXPECT_DOUBLE_EQ(meanSsim(ramp(), noise(1)), meanSsim(noise(1), ramp()));
}

TEST(PictureCompare, PlainPicturesDifferByTheirBrightnessAlone) {
  const double c1 = 6.5025;
  EXPECT_NEAR(meanSsim(plain(100), plain(110)), (2 * 100 * 110 + c1) / (100 * 100 + 110 * 110 + c1), 1e-12);
}

TEST(PictureCompare, ABoxFilterAverages) {
  Image image(4, 2, 3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>(10 * i);
  const FloatImage small = boxFiltered(image, 2);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 1);
  ASSERT_EQ(small.channels, 3);
  // Red: pixels 0, 1 of both rows: 0, 30, 120, 150.
  EXPECT_FLOAT_EQ(small.at(0, 0)[0], 75.0f);
  EXPECT_FLOAT_EQ(small.at(1, 0)[2], (80 + 110 + 200 + 230) / 4.0f);
}

TEST(PictureCompare, TellsLumaAndLight) {
  FloatImage image(2, 1, 4);
  image.pixels = {255, 255, 255, 255, 0, 188, 0, 255};
  EXPECT_NEAR(*lumaOf(image).at(0, 0), 255.0f, 1e-3f);
  EXPECT_NEAR(*lumaOf(image).at(1, 0), 0.587f * 188, 1e-3f);
  EXPECT_NEAR(*lightOf(image).at(0, 0), 1.0f, 1e-5f);
  EXPECT_NEAR(*lightOf(image).at(1, 0), 0.7152f * 0.5029f, 1e-3f);
  EXPECT_NEAR(meanOf(lightOf(image)), 0.5 * (1.0 + 0.7152 * 0.5029), 1e-3);
}

TEST(PictureCompare, FindsTheWorstSquare) {
  const FloatImage reference = plain(0.5f);
  FloatImage picture = reference;
  *picture.at(20, 16) = 1.0f;  // in the last square, 7 x 1 pixels
  EXPECT_NEAR(largestLocalError(picture, reference, 16), 1.0 / 7.0, 1e-6);
  EXPECT_NEAR(largestLocalError(plain(0.4f), reference, 16), 0.2, 1e-6);
}

TEST(PictureCompare, ABlackSquareDoesNotCountForInfinitelyMuch) {
  FloatImage reference = plain(0.5f);
  for (int y = 0; y < 16; ++y) std::fill(reference.at(0, y), reference.at(16, y), 0.0f);
  FloatImage picture = reference;
  for (int y = 0; y < 16; ++y) std::fill(picture.at(0, y), picture.at(16, y), 0.001f);
  EXPECT_LT(largestLocalError(picture, reference, 16), 0.06);
}

}  // namespace
}  // namespace windloom
