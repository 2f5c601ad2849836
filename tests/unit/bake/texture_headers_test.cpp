#include <gtest/gtest.h>

#include <cstring>

#include "engine/bake/dds_header.hpp"
#include "engine/bake/ktx2_header.hpp"

namespace windloom {
namespace {

std::uint32_t wordAt(const std::string& bytes, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::uint64_t longAt(const std::string& bytes, std::size_t at) {
  std::uint64_t value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// Places of a DDS file's words, in bytes.
constexpr std::size_t kFlags = 8, kHeight = 12, kWidth = 16, kPitch = 20, kDepth = 24, kFourCc = 84, kCaps = 108,
                      kCaps2 = 112, kDxgi = 128, kDimension = 132, kArraySize = 140;

Ktx2Texture ktx2(TextureFormat format, int layers, Supercompression supercompression = Supercompression::None) {
  return {format, {5, 3}, layers, supercompression, {{"KTXorientation", "rd"}, {"KTXwriter", "test"}}};
}

}  // namespace

TEST(DdsHeader, TellsAnArrayOfHalves) {
  const std::string bytes = ddsHeader(TextureFormat::Rg16f, TextureShape::Array, {5, 3}, 7);
  ASSERT_EQ(bytes.size(), 148u);
  EXPECT_EQ(bytes.substr(0, 4), "DDS ");
  EXPECT_EQ(wordAt(bytes, 4), 124u);
  EXPECT_EQ(wordAt(bytes, kFlags), 0x100fu);
  EXPECT_EQ(wordAt(bytes, kHeight), 3u);
  EXPECT_EQ(wordAt(bytes, kWidth), 5u);
  EXPECT_EQ(wordAt(bytes, kPitch), 20u);
  EXPECT_EQ(wordAt(bytes, kDepth), 0u);
  EXPECT_EQ(bytes.substr(kFourCc, 4), "DX10");
  EXPECT_EQ(wordAt(bytes, kCaps), 0x1000u);
  EXPECT_EQ(wordAt(bytes, kCaps2), 0u);
  EXPECT_EQ(wordAt(bytes, kDxgi), 34u);
  EXPECT_EQ(wordAt(bytes, kDimension), 3u);
  EXPECT_EQ(wordAt(bytes, kArraySize), 7u);
  EXPECT_EQ(wordAt(ddsHeader(TextureFormat::Rgba16f, TextureShape::Array, {5, 3}, 7), kPitch), 40u);
}

TEST(DdsHeader, TellsAVolumesDepthInPlaceOfLayers) {
  const std::string bytes = ddsHeader(TextureFormat::Rg16f, TextureShape::Volume, {5, 3}, 7);
  EXPECT_EQ(wordAt(bytes, kFlags), 0x80100fu);
  EXPECT_EQ(wordAt(bytes, kDepth), 7u);
  EXPECT_EQ(wordAt(bytes, kCaps), 0x1008u);
  EXPECT_EQ(wordAt(bytes, kCaps2), 0x200000u);
  EXPECT_EQ(wordAt(bytes, kDimension), 4u);
  EXPECT_EQ(wordAt(bytes, kArraySize), 1u);
}

TEST(DdsHeader, TellsTheBytesOfACompressedLayerAndItsTrueSize) {
  const std::string bytes = ddsHeader(TextureFormat::Bc5, TextureShape::Array, {5, 3}, 1);
  EXPECT_EQ(wordAt(bytes, kFlags), 0x81007u);
  EXPECT_EQ(wordAt(bytes, kWidth), 5u);
  EXPECT_EQ(wordAt(bytes, kHeight), 3u);
  EXPECT_EQ(wordAt(bytes, kPitch), 32u);
  EXPECT_EQ(wordAt(bytes, kDxgi), 83u);
}

TEST(DdsHeader, RefusesMoreSlicesThanGpusTake) {
  EXPECT_EQ(ddsRefusal(TextureShape::Array, {4096, 4096}, 2048), "");
  EXPECT_NE(ddsRefusal(TextureShape::Array, {1, 1}, 2049).find("2048 layers, not 2049 frames"), std::string::npos);
  EXPECT_EQ(ddsRefusal(TextureShape::Volume, {2048, 2048}, 2048), "");
  EXPECT_NE(ddsRefusal(TextureShape::Volume, {1, 1}, 2049).find("2048 slices, not 2049 frames"), std::string::npos);
  EXPECT_NE(ddsRefusal(TextureShape::Volume, {1, 2049}, 1).find("2048 pixels, not 2049"), std::string::npos);
}

TEST(Ktx2Header, TellsAnArrayOfHalves) {
  const std::string bytes = ktx2Header(ktx2(TextureFormat::Rg16f, 7), 7 * 60);
  EXPECT_EQ(bytes.substr(0, 12), "\xABKTX 20\xBB\r\n\x1A\n");
  const std::uint32_t words[] = {83, 2, 5, 3, 0, 7, 1, 1, 0, 104, 60, 164};
  for (std::size_t i = 0; i < std::size(words); ++i) EXPECT_EQ(wordAt(bytes, 12 + 4 * i), words[i]) << i;
  EXPECT_EQ(wordAt(bytes, 60), 24u + 20) << "bytes of keys and texts";
  EXPECT_EQ(longAt(bytes, 80), bytes.size()) << "the pixels follow";
  EXPECT_EQ(longAt(bytes, 88), 420u);
  EXPECT_EQ(longAt(bytes, 96), 420u);
  EXPECT_EQ(bytes.substr(164, 24), std::string("\x12\0\0\0KTXorientation\0rd\0\0\0", 24));
}

TEST(Ktx2Header, OneFrameIsNoArray) {
  EXPECT_EQ(wordAt(ktx2Header(ktx2(TextureFormat::Rg16f, 1), 60), 32), 0u);
}

TEST(Ktx2Header, PixelsBeginWhereABlockMay) {
  for (const auto& [format, alignment] :
       {std::pair{TextureFormat::Rg16f, 4u}, {TextureFormat::Rgba16f, 8u}, {TextureFormat::Bc5, 16u}}) {
    for (const char* text : {"", "a", "longer", "the longest one"}) {
      Ktx2Texture texture = ktx2(format, 2);
      texture.texts.back().second = text;
      const std::string bytes = ktx2Header(texture, 1);
      EXPECT_EQ(longAt(bytes, 80), bytes.size());
      EXPECT_EQ(bytes.size() % alignment, 0u);
      EXPECT_LT(bytes.size(), wordAt(bytes, 56) + wordAt(bytes, 60) + alignment) << "no more padding than needed";
    }
  }
}

TEST(Ktx2Header, PackedBytesFollowTheTextsAtOnce) {
  const std::string bytes = ktx2Header(ktx2(TextureFormat::Rg16f, 7, Supercompression::Zstd), 99);
  EXPECT_EQ(wordAt(bytes, 44), 2u);
  EXPECT_EQ(longAt(bytes, 80), wordAt(bytes, 56) + wordAt(bytes, 60));
  EXPECT_EQ(longAt(bytes, 88), 99u);
  EXPECT_EQ(longAt(bytes, 96), 420u) << "before packing";
}

TEST(Ktx2Header, DescribesEachFormatsSamples) {
  EXPECT_EQ(ktx2Descriptor(TextureFormat::Rg16f).size(), 60u);
  const std::string rgba = ktx2Descriptor(TextureFormat::Rgba16f);
  ASSERT_EQ(rgba.size(), 92u);
  EXPECT_EQ(wordAt(rgba, 28), 0xc00f0000u) << "red: 16 bits from 0, a signed float";
  EXPECT_EQ(wordAt(rgba, 76), 0xcf0f0030u) << "alpha is channel 15";
  EXPECT_EQ(wordAt(rgba, 36), 0xbf800000u);
  EXPECT_EQ(wordAt(rgba, 40), 0x3f800000u);
  const std::string bc5 = ktx2Descriptor(TextureFormat::Bc5);
  ASSERT_EQ(bc5.size(), 60u);
  EXPECT_EQ(wordAt(bc5, 12), 0x00010184u) << "model BC5, linear";
  EXPECT_EQ(wordAt(bc5, 16), 0x0303u) << "blocks of 4 x 4";
  EXPECT_EQ(wordAt(bc5, 20), 16u);
  EXPECT_EQ(wordAt(bc5, 44), 0x013f0040u) << "green: 64 bits from 64";
}

}  // namespace windloom
