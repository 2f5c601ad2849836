#pragma once
// The 148 bytes before the pixels of a DDS file with the DX10 extension. docs/formats.md has them in a table.

#include <string>

#include "engine/bake/texture_pixels.hpp"

namespace windloom {

enum class TextureShape {
  Array,   ///< 2D layers, one a frame; one frame alone is a plain 2D texture
  Volume,  ///< one 3D texture whose slices are the frames
};

/// Slices of an array or volume, and pixels of a volume's side, that Direct3D 11 GPUs take.
inline constexpr int kMaxTextureSlices = 2048;

/// No mipmaps: readers disagree on their order in volumes.
std::string ddsHeader(TextureFormat format, TextureShape shape, glm::ivec2 resolution, int slices);

/// Why GPUs can't take such a texture; empty: they can.
std::string ddsRefusal(TextureShape shape, glm::ivec2 resolution, int slices);

}  // namespace windloom
