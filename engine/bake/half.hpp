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

/// The value of a finite half: its bits in a float's place have an exponent that is 112 too low.
inline float floatFromHalf(std::uint16_t half) {
  const std::uint32_t bits = (half & 0x8000u) << 16 | (half & 0x7fffu) << 13;
  return std::bit_cast<float>(bits) * 5.192296858534828e33f;  // 2^112
}

}  // namespace windloom
