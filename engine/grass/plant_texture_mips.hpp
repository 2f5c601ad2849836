#pragma once
// Mip levels of a plant's texture that keep as much of it above the alpha cutoff as the largest has, so that leaves
// don't get thin in the distance (Castano, "Computing Alpha Mipmaps", 2010). Pure arithmetic.

#include <vector>

#include "engine/model/plant_mesh.hpp"

namespace windloom {

struct MipLevel {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> pixels;  ///< RGBA, sRGB
};

/// Part of the pixels whose alpha is at least `cutoff` (0..1), 0..1.
float alphaCoverage(const MipLevel& level, float cutoff);

/// All levels down to 1 x 1, the mesh's own first. Colours are averaged as light and by their alpha.
std::vector<MipLevel> mipLevels(const PlantMesh& mesh);

}  // namespace windloom
