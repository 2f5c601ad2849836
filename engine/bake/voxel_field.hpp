#pragma once
// A frame in cubic voxels, for formats whose grids have one side length for all axes.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/bake/volume.hpp"

namespace windloom {

/// Voxels that a volume may have: about 1 GB of memory while it is written.
inline constexpr std::int64_t kMostVoxels = 1 << 25;

class VoxelField {
 public:
  /// Voxels as wide as the smaller side of the header's cells, from the field's low corner and the ground up to at
  /// least its high corner and the profile's top; in the axes of the header's preset.
  explicit VoxelField(const BakeHeader& header);

  /// Voxels a header would need, without making anything.
  static glm::ivec3 sizeFor(const BakeHeader& header);

  [[nodiscard]] const Volume& volume() const { return m_volume; }
  /// In the preset's unit of length.
  [[nodiscard]] float side() const { return m_side; }
  /// Volume::block of the frame, interpolated linearly between the centres of its cells; clamped at the border or,
  /// along an axis in which the field repeats, with the cell at the other end.
  void block(std::span<const glm::vec2> cells, std::vector<glm::vec3>& out);

 private:
  /// What a voxel takes along one axis: `weight` of cell `first`, the rest of `second`.
  struct Tap {
    std::size_t first = 0, second = 0;
    float weight = 1;
  };
  static std::vector<Tap> tapsFor(int voxels, float side, int cells, float cellSize, bool wraps);

  Volume m_volume;
  float m_side;
  std::size_t m_width;
  std::vector<Tap> m_columns, m_rows;
  std::vector<glm::vec2> m_plane;
};

}  // namespace windloom
