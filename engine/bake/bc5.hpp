#pragma once
// BC5: two channels of 8 bits in blocks of 4 x 4 pixels, 16 bytes a block, as every desktop GPU reads it.

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace windloom {

inline constexpr int kBc5Side = 4;  ///< pixels
inline constexpr int kBc5BytesPerBlock = 16;

/// Blocks along each side; the last ones may reach over the edge.
glm::ivec2 bc5Blocks(glm::ivec2 resolution);

/// Packs `codes`, width * height pairs of (R, G), row 0 first, into `out`, 16 bytes a block, rows of blocks from the
/// top. What reaches over the edge repeats it. Both ends of each block's range are exact; between them lie six steps.
void encodeBc5(std::span<const std::uint8_t> codes, glm::ivec2 resolution, std::span<std::byte> out);

}  // namespace windloom
