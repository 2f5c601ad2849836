#pragma once
// Smooth noise for what changes slowly over a meadow.

#include <cmath>
#include <glm/glm.hpp>

#include "engine/core/hash.hpp"

namespace windloom {

/// 0..1, mean 0.5, smooth; `place` in units of the noise's size.
inline float valueNoise(glm::vec2 place, std::uint32_t seed) {
  const glm::vec2 low = glm::floor(place);
  const glm::vec2 f = place - low, s = f * f * (3.0f - 2.0f * f);
  const auto x = static_cast<std::uint32_t>(static_cast<std::int32_t>(low.x)),
             z = static_cast<std::uint32_t>(static_cast<std::int32_t>(low.y));
  const auto corner = [&](std::uint32_t i, std::uint32_t k) {
    return hashToUnit(pcgHash(((x + i) * 0x8da6b343u + (z + k) * 0xd8163841u) ^ seed));
  };
  return glm::mix(glm::mix(corner(0, 0), corner(1, 0), s.x), glm::mix(corner(0, 1), corner(1, 1), s.x), s.y);
}

}  // namespace windloom
