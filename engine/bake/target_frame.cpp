#include "engine/bake/target_frame.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/contract.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"

namespace windloom {

TargetFrame::TargetFrame(const BakeHeader& header)
    : m_rules(rulesOf(header.preset)), m_resolution(header.grid.resolution) {
  const glm::vec2 signs(m_rules.negateX ? -1.0f : 1.0f, m_rules.negateZ ? -1.0f : 1.0f);
  if (header.track.quantity == Quantity::Bend) {
    m_factor = signs;
    m_fullScale = header.fullScale;
    m_unit = "rad";
  } else if (header.space == FlowSpace::World) {
    m_factor = signs * m_rules.unitsPerMetre;
    m_fullScale = header.fullScale * m_rules.unitsPerMetre;
    m_unit = m_rules.speedUnit;
  } else {
    // In every preset u grows with the first axis and v with the second: rows are ordered so that they do.
    m_factor = signs / header.grid.size;
    m_fullScale = header.fullScale / std::min(header.grid.size.x, header.grid.size.y);
    m_unit = "uv/s";
  }
}

void TargetFrame::image(std::span<const glm::vec2> cells, std::vector<glm::vec2>& out) const {
  const auto width = static_cast<std::size_t>(m_resolution.x), height = static_cast<std::size_t>(m_resolution.y);
  WL_REQUIRE(cells.size() == width * height, "a frame has the grid of its header");
  out.resize(cells.size());
  for (std::size_t row = 0; row < height; ++row) {
    const auto from = static_cast<std::size_t>(cellOfPixel(m_rules, {0, static_cast<int>(row)}, m_resolution).y);
    const glm::vec2* source = cells.data() + from * width;
    glm::vec2* target = out.data() + row * width;
    if (m_rules.negateX) {
      for (std::size_t i = 0; i < width; ++i) target[i] = source[width - 1 - i] * m_factor;
    } else {
      for (std::size_t i = 0; i < width; ++i) target[i] = source[i] * m_factor;
    }
  }
}

std::uint8_t signedCode8(float part) {
  return static_cast<std::uint8_t>(128 + std::clamp(static_cast<int>(std::lround(part * 127.0f)), -127, 127));
}

std::uint16_t signedCode16(float part) {
  return static_cast<std::uint16_t>(32768 + std::clamp(static_cast<int>(std::lround(part * 32767.0f)), -32767, 32767));
}

std::uint8_t unsignedCode8(float part) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0f, 1.0f) * 255.0f));
}

std::uint16_t unsignedCode16(float part) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(part, 0.0f, 1.0f) * 65535.0f));
}

glm::vec2 partOf(glm::vec2 vector, float fullScale, long long& clipped) {
  const glm::vec2 part = vector / fullScale;
  const float length = glm::length(part);
  if (length <= 1.0f) return part;
  // A part in 10,000 is far below one code: rounding, not clipping.
  if (length > 1.0001f) ++clipped;
  return part / length;
}

void warnOfClipping(long long clipped, const TargetFrame& target, const std::string& what) {
  if (clipped == 0) return;
  logWarning(std::to_string(clipped) + " cells of " + what + " are over the chosen full scale of " +
             fixed(static_cast<double>(target.fullScale()), 2) + " " + target.unit() + " and were shortened to it");
}

}  // namespace windloom
