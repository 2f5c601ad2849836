#pragma once
// What stands before the pixels of a KTX2 file: header, level index, data format descriptor, keys with their texts.
// docs/formats.md has it in tables.

#include <string>
#include <utility>
#include <vector>

#include "engine/bake/texture_pixels.hpp"

namespace windloom {

enum class Supercompression { None, Zstd };

struct Ktx2Texture {
  TextureFormat format = TextureFormat::Rg16f;
  glm::ivec2 resolution{1};
  int layers = 1;  ///< 1: a plain 2D texture, no array
  Supercompression supercompression = Supercompression::None;
  /// In alphabetical order; names of the specification's own, and names of ours.
  std::vector<std::pair<std::string, std::string>> texts;
};

/// Everything before the pixels, whose level is `storedBytes` long in the file. The length doesn't depend on it.
std::string ktx2Header(const Ktx2Texture& texture, std::uint64_t storedBytes);

/// Of all layers, before any supercompression.
std::uint64_t ktx2LevelBytes(const Ktx2Texture& texture);

/// Bytes of the data format descriptor, its leading length included.
std::string ktx2Descriptor(TextureFormat format);

}  // namespace windloom
