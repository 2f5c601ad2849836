#include "engine/bake/bc5.hpp"

#include <stb_dxt.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

using Block = std::array<std::uint8_t, 2 * kBc5Side * kBc5Side>;

/// The block whose first pixel is `corner`, edges repeated.
void gather(const std::uint8_t* codes, glm::ivec2 corner, glm::ivec2 resolution, Block& block) {
  const bool inside = corner.x + kBc5Side <= resolution.x;
  for (int row = 0; row < kBc5Side; ++row) {
    const int y = std::min(corner.y + row, resolution.y - 1);
    const std::uint8_t* line = codes + 2 * static_cast<std::size_t>(y) * static_cast<std::size_t>(resolution.x);
    std::uint8_t* to = block.data() + 2 * kBc5Side * row;
    if (inside) {
      std::memcpy(to, line + 2 * corner.x, 2 * kBc5Side);
      continue;
    }
    for (int column = 0; column < kBc5Side; ++column) {
      const int x = std::min(corner.x + column, resolution.x - 1);
      std::memcpy(to + 2 * column, line + 2 * x, 2);
    }
  }
}

}  // namespace

glm::ivec2 bc5Blocks(glm::ivec2 resolution) {
  return (resolution + kBc5Side - 1) / kBc5Side;
}

void encodeBc5(std::span<const std::uint8_t> codes, glm::ivec2 resolution, std::span<std::byte> out) {
  const glm::ivec2 blocks = bc5Blocks(resolution);
  const std::size_t pixels = static_cast<std::size_t>(resolution.x) * static_cast<std::size_t>(resolution.y);
  const std::size_t bytes = static_cast<std::size_t>(blocks.x) * static_cast<std::size_t>(blocks.y) * kBc5BytesPerBlock;
  WL_REQUIRE(codes.size() == 2 * pixels && out.size() == bytes, "two codes a pixel, 16 bytes a block");
  auto* to = reinterpret_cast<unsigned char*>(out.data());
  Block block;
  for (int row = 0; row < blocks.y; ++row) {
    for (int column = 0; column < blocks.x; ++column, to += kBc5BytesPerBlock) {
      gather(codes.data(), kBc5Side * glm::ivec2(column, row), resolution, block);
      stb_compress_bc5_block(to, block.data());
    }
  }
}

}  // namespace windloom
