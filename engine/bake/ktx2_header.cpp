// After "KTX File Format Specification 2.0" and "Khronos Data Format Specification 1.3" (The Khronos Group).

#include "engine/bake/ktx2_header.hpp"

#include <numeric>

#include "engine/bake/bc5.hpp"
#include "engine/bake/little_endian.hpp"
#include "engine/core/contract.hpp"

namespace windloom {
namespace {

constexpr std::uint64_t kStartBytes = 80, kLevelIndexBytes = 24;  // one level

struct FormatFacts {
  std::uint32_t vkFormat, typeBytes, blockBytes;
  std::uint8_t model, lastX, lastY;  // colour model; the block's last column and row
};

FormatFacts factsOf(TextureFormat format) {
  constexpr std::uint8_t kModelRgbsda = 1, kModelBc5 = 132;
  switch (format) {
    case TextureFormat::Rg16f:
      return {83, 2, 4, kModelRgbsda, 0, 0};
    case TextureFormat::Rgba16f:
      return {97, 2, 8, kModelRgbsda, 0, 0};
    case TextureFormat::Bc5:
      break;
  }
  return {141, 1, kBc5BytesPerBlock, kModelBc5, kBc5Side - 1, kBc5Side - 1};
}

std::string sample(int firstBit, int bits, int channel, std::uint32_t lower, std::uint32_t upper) {
  return numberBytes(static_cast<std::uint16_t>(firstBit), static_cast<std::uint8_t>(bits - 1),
                     static_cast<std::uint8_t>(channel), std::uint32_t{0}, lower, upper);
}

std::string samples(TextureFormat format) {
  if (format == TextureFormat::Bc5) return sample(0, 64, 0, 0, ~0u) + sample(64, 64, 1, 0, ~0u);
  // The range is written as 32-bit floats for halves, too.
  constexpr int kFloatSigned = 0xc0, kAlpha = 15;
  const auto lower = std::bit_cast<std::uint32_t>(-1.0f), upper = std::bit_cast<std::uint32_t>(1.0f);
  std::string bytes;
  const int count = format == TextureFormat::Rg16f ? 2 : 4;
  for (int i = 0; i < count; ++i) {
    const int channel = i == 3 ? kAlpha : i;
    bytes += sample(16 * i, 16, kFloatSigned | channel, lower, upper);
  }
  return bytes;
}

std::string keyValues(const Ktx2Texture& texture) {
  std::string bytes;
  for (const auto& [key, text] : texture.texts) {
    appendNumber(bytes, static_cast<std::uint32_t>(key.size() + text.size() + 2));
    bytes.append(key.c_str(), key.size() + 1);
    bytes.append(text.c_str(), text.size() + 1);
    bytes.resize((bytes.size() + 3) / 4 * 4);
  }
  return bytes;
}

}  // namespace

std::string ktx2Descriptor(TextureFormat format) {
  constexpr std::uint8_t kPrimariesBt709 = 1, kTransferLinear = 1, kStraightAlpha = 0;
  const FormatFacts facts = factsOf(format);
  const std::string channels = samples(format);
  const auto blockBytes = static_cast<std::uint32_t>(24 + channels.size());
  std::string bytes =
      numberBytes(blockBytes + 4, std::uint32_t{0}, std::uint16_t{2}, static_cast<std::uint16_t>(blockBytes));
  bytes += numberBytes(facts.model, kPrimariesBt709, kTransferLinear, kStraightAlpha);
  bytes += numberBytes(facts.lastX, facts.lastY, std::uint8_t{0}, std::uint8_t{0});
  // Bytes of a block. Also where zstd packs it: readers of the older rule, 0 there, take either.
  bytes += numberBytes(facts.blockBytes, std::uint32_t{0});
  return bytes + channels;
}

std::uint64_t ktx2LevelBytes(const Ktx2Texture& texture) {
  return textureBytes(texture.format, texture.resolution) * static_cast<std::uint64_t>(texture.layers);
}

std::string ktx2Header(const Ktx2Texture& texture, std::uint64_t storedBytes) {
  WL_REQUIRE(texture.resolution.x > 0 && texture.resolution.y > 0 && texture.layers > 0, "a texture has pixels");
  const FormatFacts facts = factsOf(texture.format);
  const bool zstd = texture.supercompression == Supercompression::Zstd;
  const std::string descriptor = ktx2Descriptor(texture.format), texts = keyValues(texture);
  const std::uint64_t textsAt = kStartBytes + kLevelIndexBytes + descriptor.size();
  const std::uint64_t end = textsAt + texts.size();
  // Packed bytes follow at once; pixels begin where a block and a number of 4 bytes both may.
  const std::uint64_t alignment = zstd ? 1 : std::lcm(facts.blockBytes, 4u);
  const std::uint64_t dataAt = (end + alignment - 1) / alignment * alignment;

  std::string bytes("\xABKTX 20\xBB\r\n\x1A\n", 12);
  bytes += numberBytes(facts.vkFormat, facts.typeBytes, texture.resolution.x, texture.resolution.y, /* depth */ 0u,
                       texture.layers > 1 ? texture.layers : 0, /* faces */ 1u, /* levels */ 1u, zstd ? 2u : 0u);
  bytes += numberBytes(static_cast<std::uint32_t>(kStartBytes + kLevelIndexBytes),
                       static_cast<std::uint32_t>(descriptor.size()), static_cast<std::uint32_t>(textsAt),
                       static_cast<std::uint32_t>(texts.size()), std::uint64_t{0}, std::uint64_t{0});
  bytes += numberBytes(dataAt, storedBytes, ktx2LevelBytes(texture));
  bytes += descriptor + texts;
  bytes.resize(dataAt);
  return bytes;
}

}  // namespace windloom
