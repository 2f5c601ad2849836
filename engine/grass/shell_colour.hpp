#pragma once
// sRGB codes of linear light, for the colours of shell textures.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace windloom {

class SrgbCodes {
 public:
  SrgbCodes() {
    for (std::size_t i = 0; i < m_linear.size(); ++i) {
      const float code = static_cast<float>(i) / 255.0f;
      m_linear[i] = code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
    }
    for (std::size_t i = 0; i < m_between.size(); ++i) m_between[i] = 0.5f * (m_linear[i] + m_linear[i + 1]);
  }

  [[nodiscard]] float linear(std::uint8_t code) const { return m_linear[code]; }
  [[nodiscard]] glm::vec3 linear(glm::u8vec4 code) const {
    return {m_linear[code.r], m_linear[code.g], m_linear[code.b]};
  }
  /// The code whose light is nearest; what is out of range gets the first or the last.
  [[nodiscard]] std::uint8_t code(float light) const {
    return static_cast<std::uint8_t>(std::ranges::upper_bound(m_between, light) - m_between.begin());
  }

 private:
  std::array<float, 256> m_linear{};
  std::array<float, 255> m_between{};
};

inline std::uint8_t shellByte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

}  // namespace windloom
