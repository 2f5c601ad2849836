#pragma once
// Frames as the bytes of GPU textures: what DDS and KTX2 files hold after their headers.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bake/half_image.hpp"

namespace windloom {

enum class TextureFormat {
  Rg16f,    ///< half floats: vector along the target's two axes, in TargetFrame::unit()
  Rgba16f,  ///< also B = length, A = 1
  Bc5,      ///< R, G: the codes of 8-bit flow maps (128: still air), compressed in blocks
};

/// As in the manifest.
std::string_view encodingOf(TextureFormat format);
/// As in the manifest.
std::string_view channelsOf(TextureFormat format);
/// Of one picture.
std::uint64_t textureBytes(TextureFormat format, glm::ivec2 resolution);

class TexturePixels {
 public:
  TexturePixels(const BakeHeader& header, TextureFormat format);

  /// textureBytes() bytes, row 0 (the top) first, that stay until the next call.
  std::string_view of(std::span<const glm::vec2> cells);

  [[nodiscard]] const TargetFrame& target() const { return m_target; }
  /// Says how many vectors were over the full scale, where the format has one.
  void warn() const;

 private:
  std::string_view blocksOf(std::span<const glm::vec2> cells);

  TargetFrame m_target;
  glm::ivec2 m_resolution;
  std::optional<HalfImage> m_halves;  // none for BC5
  std::vector<glm::vec2> m_vectors;
  std::vector<std::uint8_t> m_codes;
  std::vector<std::byte> m_blocks;
  long long m_clipped = 0;
};

}  // namespace windloom
