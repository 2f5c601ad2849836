#include "engine/io/png_stream.hpp"

#include <gtest/gtest.h>

#include "engine/io/image.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

template <class Sample>
std::vector<Sample> ramp(int width, int height) {
  std::vector<Sample> samples(static_cast<std::size_t>(width * height) * 4);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<Sample>(i * 977);
  return samples;
}

}  // namespace

TEST(PngStream, RowsThatComeInPiecesMakeTheSamePictureAsAtOnce) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> samples = ramp<std::uint8_t>(5, 7);
  const std::span<const std::uint8_t> all = samples;
  auto png = PngStream<std::uint8_t>::create(folder.path() / "a.png", 5, 7);
  ASSERT_TRUE(png);
  for (const auto& [first, rows] : {std::pair{0, 3}, {3, 1}, {4, 3}})
    ASSERT_TRUE(png->write(all.subspan(static_cast<std::size_t>(first) * 20, static_cast<std::size_t>(rows) * 20)));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.png"));
  ASSERT_TRUE(png->finish());
  const Image read = readPng(folder.path() / "a.png").value();
  EXPECT_EQ(read.channels, 4);
  EXPECT_EQ(read.pixels, samples);
}

TEST(PngStream, KeepsAll16Bits) {
  const TemporaryFolder folder;
  const std::vector<std::uint16_t> samples = ramp<std::uint16_t>(3, 2);
  auto png = PngStream<std::uint16_t>::create(folder.path() / "a.png", 3, 2);
  ASSERT_TRUE(png);
  ASSERT_TRUE(png->write(samples));
  ASSERT_TRUE(png->finish());
  EXPECT_EQ(readPng16(folder.path() / "a.png").value().pixels, samples);
}

TEST(PngStream, LeavesNothingWithoutFinishAndSaysWhereItCantWrite) {
  const TemporaryFolder folder;
  {
    auto png = PngStream<std::uint8_t>::create(folder.path() / "a.png", 1, 1);
    ASSERT_TRUE(png);
    ASSERT_TRUE(png->write(std::vector<std::uint8_t>(4)));
  }
  EXPECT_EQ(folder.entries(), 0);
  const auto refused = PngStream<std::uint8_t>::create(folder.path() / "no" / "a.png", 1, 1);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("a.png"), std::string::npos);
}

TEST(PngStreamDeathTest, RefusesMoreRowsThanThePictureHas) {
  const TemporaryFolder folder;
  auto png = PngStream<std::uint8_t>::create(folder.path() / "a.png", 1, 1);
  ASSERT_TRUE(png);
  EXPECT_DEATH((void)png->write(std::vector<std::uint8_t>(8)), "not more than the picture has");
}

}  // namespace windloom
