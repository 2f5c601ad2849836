#pragma once
// A block of vectors as an OpenVDB file. The only door to that library, which may be missing.

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "engine/core/result.hpp"

namespace windloom {

struct VdbBlock {
  std::string name = "velocity";
  glm::ivec3 size{1};                  ///< voxels
  float side = 1.0f;                   ///< of a voxel, in the file's unit of length
  glm::vec3 low{0.0f};                 ///< corner of voxel (0, 0, 0), not its centre
  std::span<const glm::vec3> vectors;  ///< x fastest, then y, then z
};

/// The file: one Vec3SGrid of half floats, every voxel of the block active, a vector that turns with its grid's
/// transform. The same block gives the same bytes. Fails with Machine (no memory).
Result<std::string> vdbBytes(const VdbBlock& block);

}  // namespace windloom
