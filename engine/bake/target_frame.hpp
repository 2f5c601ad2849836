#pragma once
// A recorded frame as a preset's image: the target's axes, signs, units and row order, or its texture space.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/bake/bake_header.hpp"

namespace windloom {

class TargetFrame {
 public:
  explicit TargetFrame(const BakeHeader& header);

  /// The frame's vectors, row 0 (the top of an image file) first, each along the target's two ground axes in unit().
  /// `out` is resized to width * height.
  void image(std::span<const glm::vec2> cells, std::vector<glm::vec2>& out) const;

  /// header.fullScale in unit(): no vector is longer unless the user chose a smaller full scale.
  [[nodiscard]] float fullScale() const { return m_fullScale; }
  /// "m/s", "cm/s", "uv/s" or "rad".
  [[nodiscard]] const std::string& unit() const { return m_unit; }
  /// What one of our vectors is multiplied with, signs included.
  [[nodiscard]] glm::vec2 factor() const { return m_factor; }

 private:
  const PresetRules& m_rules;
  glm::ivec2 m_resolution;
  glm::vec2 m_factor{1.0f};
  float m_fullScale = 1;
  std::string m_unit;
};

/// Codes of integer formats. Vectors longer than the full scale are shortened to it without turning; `clipped` counts
/// them.
/// Signed: code(0) = 128 exactly, (code - 128) / 127 * full scale decodes; 16 bits: 32768 and 32767.
std::uint8_t signedCode8(float part);
std::uint16_t signedCode16(float part);
/// 0..1 to 0..255 or 0..65535.
std::uint8_t unsignedCode8(float part);
std::uint16_t unsignedCode16(float part);
/// `vector` over the full scale, at most 1 long.
glm::vec2 partOf(glm::vec2 vector, float fullScale, long long& clipped);
/// Says how many vectors were shortened, where any was.
void warnOfClipping(long long clipped, const TargetFrame& target, const std::string& what);

}  // namespace windloom
