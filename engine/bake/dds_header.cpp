// After the programming guide for DDS in Microsoft's Direct3D documentation.

#include "engine/bake/dds_header.hpp"

#include "engine/bake/bc5.hpp"
#include "engine/bake/little_endian.hpp"
#include "engine/core/contract.hpp"

namespace windloom {
namespace {

constexpr std::uint32_t kCaps = 0x1, kHeight = 0x2, kWidth = 0x4, kPitch = 0x8, kPixelFormat = 0x1000,
                        kLinearSize = 0x80000, kDepth = 0x800000;
constexpr std::uint32_t kCapsComplex = 0x8, kCapsTexture = 0x1000, kCaps2Volume = 0x200000;
constexpr std::uint32_t kFourCc = 0x4;
constexpr std::uint32_t kTexture2D = 3, kTexture3D = 4;

std::uint32_t dxgiFormat(TextureFormat format) {
  switch (format) {
    case TextureFormat::Rg16f:
      return 34;  // R16G16_FLOAT
    case TextureFormat::Rgba16f:
      return 10;  // R16G16B16A16_FLOAT
    case TextureFormat::Bc5:
      return 83;  // BC5_UNORM
  }
  return 0;
}

/// Bytes of a row of pixels; of a whole picture where it is compressed.
std::uint32_t pitchOf(TextureFormat format, glm::ivec2 resolution) {
  const std::uint64_t bytes = textureBytes(format, resolution);
  if (format == TextureFormat::Bc5) return static_cast<std::uint32_t>(bytes);
  return static_cast<std::uint32_t>(bytes / static_cast<std::uint64_t>(resolution.y));
}

}  // namespace

std::string ddsHeader(TextureFormat format, TextureShape shape, glm::ivec2 resolution, int slices) {
  WL_REQUIRE(resolution.x > 0 && resolution.y > 0 && slices > 0, "a texture has pixels");
  const bool volume = shape == TextureShape::Volume;
  const auto count = static_cast<std::uint32_t>(slices);
  const std::uint32_t flags = kCaps | kHeight | kWidth | kPixelFormat | (volume ? kDepth : 0) |
                              (format == TextureFormat::Bc5 ? kLinearSize : kPitch);
  std::string bytes = "DDS ";
  bytes += numberBytes(std::uint32_t{124}, flags, resolution.y, resolution.x, pitchOf(format, resolution),
                       volume ? count : 0u, /* mipmaps */ 1u);
  bytes.append(11 * 4, '\0');
  bytes += numberBytes(std::uint32_t{32}, kFourCc);
  bytes += "DX10";
  bytes.append(5 * 4, '\0');
  bytes += numberBytes(kCapsTexture | (volume ? kCapsComplex : 0), volume ? kCaps2Volume : 0u, 0u, 0u, 0u);
  bytes += numberBytes(dxgiFormat(format), volume ? kTexture3D : kTexture2D, 0u, volume ? 1u : count, 0u);
  return bytes;
}

std::string ddsRefusal(TextureShape shape, glm::ivec2 resolution, int slices) {
  const std::string limit = std::to_string(kMaxTextureSlices);
  if (slices > kMaxTextureSlices) {
    return std::string(shape == TextureShape::Array ? "a texture array holds at most " + limit + " layers"
                                                    : "a volume texture holds at most " + limit + " slices") +
           ", not " + std::to_string(slices) + " frames; bake fewer";
  }
  if (shape == TextureShape::Volume && std::max(resolution.x, resolution.y) > kMaxTextureSlices) {
    return "a side of a volume texture has at most " + limit + " pixels, not " +
           std::to_string(std::max(resolution.x, resolution.y)) + "; bake a lower --resolution";
  }
  return {};
}

}  // namespace windloom
