#pragma once
// IEEE 754 half floats for baked files.

#include <bit>
#include <cstdint>

namespace windloom {

/// The nearest half, ties to even; beyond the range the greatest finite one. `value` must not be NaN.
inline std::uint16_t halfFromFloat(float value) {
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
  const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000u);
  const std::uint32_t magnitude = bits & 0x7fffffffu;
  if (magnitude >= 0x477ff000u) return sign | 0x7bffu;  // rounds to more than 65504
  if (magnitude < 0x38800000u) {
    // Below 2^-14 halves lie 2^-24 apart, as floats do between 0.5 and 1: adding 0.5 rounds to them.
    const float shifted = std::bit_cast<float>(magnitude) + 0.5f;
    return static_cast<std::uint16_t>(sign | (std::bit_cast<std::uint32_t>(shifted) - 0x3f000000u));
  }
  const std::uint32_t even = magnitude >> 13 & 1u;
  return static_cast<std::uint16_t>(sign | ((magnitude - 0x38000000u + 0xfffu + even) >> 13));
}

}  // namespace windloom
