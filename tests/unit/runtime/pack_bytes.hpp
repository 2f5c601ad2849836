#pragma once
// Packs put together from docs/windpack.md, field by field, independent of our writer.

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "engine/runtime/checksum.h"
#include "engine/runtime/windloom_runtime.hpp"

namespace windloom::runtime {

struct PackBytes {
  std::uint32_t version = 1, endianMark = 0x01020304, flags = 0, width = 2, height = 2, frames = 1;
  float corners[4] = {0, 0, 2, 2};
  float fps = 10, maxSpeed = 100;
  double start = 0;
  std::uint64_t dataBytes = 0;  // 0: what the extents say
  std::uint64_t reserved = 0;
  std::uint32_t quantity = 0;  // from here on version 2 only
  float referenceHeight = 2, roughness = 0;
  std::uint32_t reserved2 = 0;
  std::vector<std::uint16_t> halves;
  std::vector<float> floats;  // in place of halves with flag 8
  std::string stored;         // in place of both with flag 16

  std::string build() const {
    std::string bytes = "WINDPACK";
    const auto add = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
    add(version);
    add(endianMark);
    add(flags);
    add(width);
    add(height);
    add(frames);
    add(corners);
    add(fps);
    add(maxSpeed);
    add(start);
    const std::uint64_t cellBytes = version >= 2 && (flags & 8) != 0 ? 8 : 4;
    add(dataBytes != 0 ? dataBytes : cellBytes * width * height * frames);
    add(reserved);
    if (version >= 2) {
      add(quantity);
      add(referenceHeight);
      add(roughness);
      add(reserved2);
    }
    bytes += cells();
    add(windloom_checksum(0, bytes.data(), bytes.size()));
    return bytes;
  }

  /// What is stored between header and checksum.
  std::string cells() const {
    if (!stored.empty()) return stored;
    if (!floats.empty()) return {reinterpret_cast<const char*>(floats.data()), floats.size() * 4};
    return {reinterpret_cast<const char*>(halves.data()), halves.size() * 2};
  }
};

// Halves of small whole numbers: sign, 5 bits of exponent with bias 15, 10 bits of fraction.
inline constexpr std::uint16_t kZero = 0x0000, kOne = 0x3c00, kTwo = 0x4000, kFour = 0x4400, kEight = 0x4800,
                               kMinusOne = 0xbc00;

/// vx: 0 1 / 2 4 over (x, z); vz: -1 everywhere.
inline PackBytes twoByTwo() {
  PackBytes pack;
  pack.halves = {kZero, kMinusOne, kOne, kMinusOne, kTwo, kMinusOne, kFour, kMinusOne};
  return pack;
}

/// The same of version 2, with floats.
inline PackBytes twoByTwoFloats() {
  PackBytes pack;
  pack.version = 2;
  pack.flags = 8;
  pack.floats = {0, -1, 1, -1, 2, -1, 4, -1};
  return pack;
}

/// Loads a copy that ends exactly where its memory does, so that the address sanitizer sees every byte read too much.
inline WindPack load(const std::string& bytes) {
  const std::unique_ptr<char[]> exact(new char[bytes.size()]);
  std::memcpy(exact.get(), bytes.data(), bytes.size());
  return WindPack::load(exact.get(), bytes.size());
}

}  // namespace windloom::runtime
