#include "engine/bake/texture_pixels.hpp"

#include "engine/bake/bc5.hpp"

namespace windloom {
namespace {

std::optional<HalfImage> halvesFor(const BakeHeader& header, TextureFormat format) {
  if (format == TextureFormat::Bc5) return std::nullopt;
  return HalfImage(header, format == TextureFormat::Rg16f ? HalfLayout::Rg : HalfLayout::Rgba);
}

}  // namespace

std::string_view encodingOf(TextureFormat format) {
  return format == TextureFormat::Bc5 ? "bc5" : "half";
}

std::string_view channelsOf(TextureFormat format) {
  return format == TextureFormat::Rgba16f ? "RGBA" : "RG";
}

std::uint64_t textureBytes(TextureFormat format, glm::ivec2 resolution) {
  const glm::ivec2 units = format == TextureFormat::Bc5 ? bc5Blocks(resolution) : resolution;
  const std::uint64_t unitBytes = format == TextureFormat::Rg16f     ? 4
                                  : format == TextureFormat::Rgba16f ? 8
                                                                     : kBc5BytesPerBlock;
  return static_cast<std::uint64_t>(units.x) * static_cast<std::uint64_t>(units.y) * unitBytes;
}

TexturePixels::TexturePixels(const BakeHeader& header, TextureFormat format)
    : m_target(header), m_resolution(header.grid.resolution), m_halves(halvesFor(header, format)) {}

std::string_view TexturePixels::of(std::span<const glm::vec2> cells) {
  if (!m_halves) return blocksOf(cells);
  const std::span<const std::uint16_t> halves = m_halves->of(cells);
  return {reinterpret_cast<const char*>(halves.data()), halves.size_bytes()};
}

std::string_view TexturePixels::blocksOf(std::span<const glm::vec2> cells) {
  m_target.image(cells, m_vectors);
  m_codes.resize(2 * m_vectors.size());
  for (std::size_t i = 0; i < m_vectors.size(); ++i) {
    const glm::vec2 part = partOf(m_vectors[i], m_target.fullScale(), m_clipped);
    m_codes[2 * i] = signedCode8(part.x);
    m_codes[2 * i + 1] = signedCode8(part.y);
  }
  m_blocks.resize(textureBytes(TextureFormat::Bc5, m_resolution));
  encodeBc5(m_codes, m_resolution, m_blocks);
  return {reinterpret_cast<const char*>(m_blocks.data()), m_blocks.size()};
}

void TexturePixels::warn() const {
  if (!m_halves) warnOfClipping(m_clipped, m_target, "the BC5 texture");
}

}  // namespace windloom
