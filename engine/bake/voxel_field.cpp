#include "engine/bake/voxel_field.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

float sideOf(const BakeHeader& header) {
  return std::min(header.grid.cellSize.x, header.grid.cellSize.y);
}

/// Enough of them for `length`; a part in a thousand of one more is rounding.
int countFor(float length, float side) {
  return std::max(1, static_cast<int>(std::ceil(static_cast<double>(length) / static_cast<double>(side) - 1e-3)));
}

Volume volumeOf(const BakeHeader& header) {
  const float side = sideOf(header);
  const glm::ivec3 size = VoxelField::sizeFor(header);
  const glm::ivec2 plane(size.x, size.z);
  VolumeLayers layers;
  const bool flat = header.profile.layers == 1;
  layers.low = flat ? header.profile.reference - 0.5f * side : 0.0f;
  layers.high = layers.low + side * static_cast<float>(size.y);
  for (int n = 0; n < size.y; ++n) {
    const bool same = flat || header.track.quantity == Quantity::Bend;
    layers.factors.push_back(same ? 1.0f : header.profile.at((static_cast<float>(n) + 0.5f) * side));
  }
  const GridMapping grid{header.grid.minCorner, glm::vec2(plane) * side, plane, glm::vec2(side)};
  return {grid, std::move(layers), header.track.quantity, header.preset};
}

}  // namespace

glm::ivec3 VoxelField::sizeFor(const BakeHeader& header) {
  const float side = sideOf(header);
  return {countFor(header.grid.size.x, side), header.profile.layers == 1 ? 1 : countFor(header.profile.top, side),
          countFor(header.grid.size.y, side)};
}

VoxelField::VoxelField(const BakeHeader& header)
    : m_volume(volumeOf(header)),
      m_side(sideOf(header) * rulesOf(header.preset).unitsPerMetre),
      m_width(static_cast<std::size_t>(header.grid.resolution.x)) {
  const glm::ivec3 size = sizeFor(header);
  const float side = sideOf(header);
  const glm::ivec2 cells = header.grid.resolution;
  m_columns = tapsFor(size.x, side, cells.x, header.grid.cellSize.x, header.periodicX);
  m_rows = tapsFor(size.z, side, cells.y, header.grid.cellSize.y, header.periodicZ);
}

std::vector<VoxelField::Tap> VoxelField::tapsFor(int voxels, float side, int cells, float cellSize, bool wraps) {
  std::vector<Tap> taps;
  const auto index = [&](int cell) {
    return static_cast<std::size_t>(wraps ? (cell + cells) % cells : std::clamp(cell, 0, cells - 1));
  };
  for (int n = 0; n < voxels; ++n) {
    // Where voxels are cells nothing is interpolated, not even by rounding.
    const bool same = side == cellSize && voxels == cells;
    const double at = same ? n : (n + 0.5) * static_cast<double>(side) / static_cast<double>(cellSize) - 0.5;
    const int first = static_cast<int>(std::floor(at));
    taps.push_back({index(first), index(first + 1), static_cast<float>(1.0 - (at - first))});
  }
  return taps;
}

void VoxelField::block(std::span<const glm::vec2> cells, std::vector<glm::vec3>& out) {
  m_plane.resize(m_columns.size() * m_rows.size());
  glm::vec2* to = m_plane.data();
  for (const Tap& row : m_rows) {
    const glm::vec2* first = cells.data() + row.first * m_width;
    const glm::vec2* second = cells.data() + row.second * m_width;
    for (const Tap& column : m_columns) {
      const glm::vec2 a = glm::mix(first[column.second], first[column.first], column.weight);
      const glm::vec2 b = glm::mix(second[column.second], second[column.first], column.weight);
      *to++ = glm::mix(b, a, row.weight);
    }
  }
  m_volume.block(m_plane, out);
}

}  // namespace windloom
