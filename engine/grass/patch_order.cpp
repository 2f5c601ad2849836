#include "engine/grass/patch_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/hash.hpp"
#include "engine/grass/blade_traits.hpp"

namespace windloom {
namespace {

constexpr int kKeyBits = 33;  // 11 bits along each axis, or 16 on the ground
constexpr int kDigit = 11;    // bits sorted at once
constexpr std::size_t kChunk = 16384;
constexpr int kPatchesPerChunk = 32;

/// Puts `gap` zeros after each of the lowest bits.
std::uint64_t spread(std::uint32_t value, int bits, int gap) {
  std::uint64_t out = 0;
  for (int i = 0; i < bits; ++i) out |= static_cast<std::uint64_t>(value >> i & 1u) << (i * (gap + 1));
  return out;
}

/// Bits of a number up to 2^11 (2^16) apart by two (one), looked up in pieces.
struct Spreading {
  std::vector<std::uint64_t> byTwo, byOne;
  Spreading() {
    for (std::uint32_t i = 0; i < 2048; ++i) byTwo.push_back(spread(i, 11, 2));
    for (std::uint32_t i = 0; i < 65536; ++i) byOne.push_back(spread(i, 16, 1));
  }
};

glm::vec3 placeOf(const BezierBlade& blade) {
  return {blade.x, blade.y, blade.z};
}

template <class Body>
void inChunks(ThreadPool& pool, std::size_t count, const Body& body) {
  pool.parallelFor(static_cast<int>((count + kChunk - 1) / kChunk), [&](int chunk) {
    const std::size_t from = static_cast<std::size_t>(chunk) * kChunk;
    body(from, std::min(from + kChunk, count));
  });
}

/// Morton code in the upper bits, the blade's index in the lower ones.
std::vector<std::uint64_t> mortonKeys(const std::vector<BezierBlade>& blades, bool level, int indexBits,
                                      ThreadPool& pool) {
  glm::vec3 low = placeOf(blades.front()), high = low;
  for (const BezierBlade& blade : blades) {
    low = glm::min(low, placeOf(blade));
    high = glm::max(high, placeOf(blade));
  }
  const glm::vec3 size = high - low;
  const float longest = std::max({size.x, level ? 0.0f : size.y, size.z, 1e-6f});
  const float cells = level ? 65535.0f : 2047.0f;
  static const Spreading kSpread;
  std::vector<std::uint64_t> keys(blades.size());
  inChunks(pool, blades.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      const glm::vec3 part = glm::clamp((placeOf(blades[i]) - low) * (cells / longest), 0.0f, cells);
      const auto x = static_cast<std::uint32_t>(part.x), y = static_cast<std::uint32_t>(part.y),
                 z = static_cast<std::uint32_t>(part.z);
      const std::uint64_t code = level ? kSpread.byOne[x] | kSpread.byOne[z] << 1
                                       : kSpread.byTwo[x] | kSpread.byTwo[y] << 1 | kSpread.byTwo[z] << 2;
      keys[i] = code << indexBits | i;
    }
  });
  return keys;
}

/// Radix sort by the upper bits; the lower ones ascend already.
void sortKeys(std::vector<std::uint64_t>& keys, int indexBits) {
  std::vector<std::uint64_t> other(keys.size());
  for (int shift = indexBits; shift < indexBits + kKeyBits; shift += kDigit) {
    std::vector<std::size_t> first((1u << kDigit) + 1, 0);
    const auto digit = [&](std::uint64_t key) { return key >> shift & ((1u << kDigit) - 1); };
    for (const std::uint64_t key : keys) ++first[digit(key) + 1];
    for (std::size_t d = 1; d < first.size(); ++d) first[d] += first[d - 1];
    for (const std::uint64_t key : keys) other[first[digit(key)]++] = key;
    keys.swap(other);
  }
}

std::uint32_t reversedByte(std::uint32_t i) {
  i = (i & 0xf0u) >> 4 | (i & 0x0fu) << 4;
  i = (i & 0xccu) >> 2 | (i & 0x33u) << 2;
  return (i & 0xaau) >> 1 | (i & 0x55u) << 1;
}

// Neighbours along the curve among which the high ones come first: they are what is seen of a thinned meadow, and hide
// the others. Over a whole patch that would leave holes, since high blades stand in clumps and tufts.
constexpr std::size_t kNeighbours = 8;
constexpr std::size_t kGroups = BEZIER_PATCH / kNeighbours;

/// `blades`: along the curve, at most a patch's. The highest of each group of neighbours first, then the second, and so
/// on; groups in van der Corput's order (bits reversed, scrambled), so that any first part is spread over all of the
/// curve.
void arrange(std::vector<BezierBlade>& blades, std::uint32_t scramble, BezierBlade* out) {
  for (std::size_t from = 0; from < blades.size(); from += kNeighbours) {
    const auto first = blades.begin() + static_cast<std::ptrdiff_t>(from);
    std::stable_sort(first, first + static_cast<std::ptrdiff_t>(std::min(kNeighbours, blades.size() - from)),
                     [](const BezierBlade& a, const BezierBlade& b) { return sizesOf(a).x > sizesOf(b).x; });
  }
  for (std::size_t rank = 0; rank < kNeighbours; ++rank) {
    for (std::uint32_t i = 0; i < kGroups; ++i) {
      const std::size_t group = (reversedByte(i) / kNeighbours) ^ (scramble % kGroups);
      const std::size_t at = group * kNeighbours + rank;
      if (at < blades.size()) *out++ = blades[at];
    }
  }
}

}  // namespace

BezierPatch patchAround(const BezierBlade* blades, std::size_t count, int surface) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (std::size_t i = 0; i < count; ++i) {
    const glm::vec3 root = placeOf(blades[i]), up = upOf(blades[i]);
    const glm::vec2 sizes = sizesOf(blades[i]);
    // Half a ball: all of its reach along directions above the plane, and along others that of its rim.
    const glm::vec3 rim = glm::sqrt(glm::max(1.0f - up * up, glm::vec3(0.0f)));
    const float reach = kBladeReach * sizes.x;
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], root[c] - reach * (up[c] <= 0.0f ? 1.0f : rim[c]) - sizes.y);
      high[c] = std::max(high[c], root[c] + reach * (up[c] >= 0.0f ? 1.0f : rim[c]) + sizes.y);
    }
  }
  return {glm::vec4(0.5f * (low + high), static_cast<float>(count)),
          glm::vec4(0.5f * (high - low) * 1.0001f + 1e-5f, static_cast<float>(surface))};
}

void appendPatches(const std::vector<BezierBlade>& blades, int surface, ThreadPool& pool,
                   std::vector<BezierBlade>& ordered, std::vector<BezierPatch>& patches) {
  if (blades.empty()) return;
  constexpr std::size_t kSize = BEZIER_PATCH;
  int indexBits = 1;
  while (blades.size() >> indexBits != 0) ++indexBits;
  std::vector<std::uint64_t> keys = mortonKeys(blades, surface < 0, indexBits, pool);
  sortKeys(keys, indexBits);
  const std::uint64_t mask = (std::uint64_t{1} << indexBits) - 1;
  const std::size_t count = (blades.size() + kSize - 1) / kSize, firstPatch = patches.size();
  ordered.resize((firstPatch + count) * kSize, BezierBlade{});
  patches.resize(firstPatch + count);
  const auto fill = [&](std::size_t patch) {
    const std::size_t from = patch * kSize, has = std::min(kSize, blades.size() - from);
    BezierBlade* out = &ordered[(firstPatch + patch) * kSize];
    std::vector<BezierBlade> along(has);
    for (std::size_t i = 0; i < has; ++i) along[i] = blades[keys[from + i] & mask];
    arrange(along, pcgHash(static_cast<std::uint32_t>(firstPatch + patch)), out);
    patches[firstPatch + patch] = patchAround(out, has, surface);
  };
  pool.parallelFor(static_cast<int>((count + kPatchesPerChunk - 1) / kPatchesPerChunk), [&](int chunk) {
    const std::size_t from = static_cast<std::size_t>(chunk) * kPatchesPerChunk;
    for (std::size_t p = from; p < std::min(from + kPatchesPerChunk, count); ++p) fill(p);
  });
}

}  // namespace windloom
