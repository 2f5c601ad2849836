#include "engine/wind/gpu_levels.hpp"

#include <algorithm>
#include <glm/gtc/packing.hpp>

namespace windloom {
namespace {

std::size_t nodeCount(const PressureLevel& level) {
  return static_cast<std::size_t>(level.width + 1) * static_cast<std::size_t>(level.height + 1);
}

}  // namespace

std::size_t cellCount(const PressureLevel& level) {
  return static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
}

std::vector<shared::uint> packFaces(const PressureLevel& level) {
  const std::size_t w = static_cast<std::size_t>(level.width), h = static_cast<std::size_t>(level.height);
  std::vector<shared::uint> faces(nodeCount(level));
  for (std::size_t k = 0; k <= h; ++k) {
    for (std::size_t i = 0; i <= w; ++i) {
      glm::vec2 low(0);
      if (k < h) low.x = level.cx[k * (w + 1) + i];
      if (k < h && i == 0) low.x += level.groundX[2 * k];
      if (k < h && i == w) low.x += level.groundX[2 * k + 1];
      if (i < w) low.y = level.cz[k * w + i];
      if (i < w && k == 0) low.y += level.groundZ[2 * i];
      if (i < w && k == h) low.y += level.groundZ[2 * i + 1];
      faces[k * (w + 1) + i] = glm::packHalf2x16(low / level.scale);
    }
  }
  return faces;
}

PlainCells::PlainCells(int width, int height)
    : m_width(width),
      m_height(height),
      m_others(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1), 0) {}

PlainCells::PlainCells(const WindGrid& grid) : PlainCells(grid.width, grid.height) {
  for (int k = 0; k < m_height; ++k) {
    for (int i = 0; i < m_width; ++i) {
      const bool inside = i > 0 && k > 0 && i + 1 < m_width && k + 1 < m_height;
      set(i, k,
          inside && !grid.solidAt(i, k) && !grid.solidAt(i - 1, k) && !grid.solidAt(i + 1, k) &&
              !grid.solidAt(i, k - 1) && !grid.solidAt(i, k + 1));
    }
  }
}

PlainCells::PlainCells(const PressureLevel& level, std::span<const shared::uint> faces)
    : PlainCells(level.width, level.height) {
  const shared::uint whole = glm::packHalf2x16(glm::vec2(1));
  const std::size_t stride = static_cast<std::size_t>(m_width) + 1;
  for (int k = 0; k < m_height; ++k) {
    for (int i = 0; i < m_width; ++i) {
      const std::size_t node = static_cast<std::size_t>(k) * stride + static_cast<std::size_t>(i);
      const shared::uint right = faces[node + 1] ^ whole, above = faces[node + stride] ^ whole;
      set(i, k, faces[node] == whole && right << 16 == 0 && above >> 16 == 0);
    }
  }
}

const int& PlainCells::others(int i, int k) const {
  return m_others[static_cast<std::size_t>(k) * static_cast<std::size_t>(m_width + 1) + static_cast<std::size_t>(i)];
}

void PlainCells::set(int i, int k, bool plain) {
  m_others[static_cast<std::size_t>(k + 1) * static_cast<std::size_t>(m_width + 1) + static_cast<std::size_t>(i + 1)] =
      others(i, k + 1) + others(i + 1, k) - others(i, k) + (plain ? 0 : 1);
}

bool PlainCells::all(glm::ivec2 low, glm::ivec2 high) const {
  if (low.x < 0 || low.y < 0 || high.x > m_width || high.y > m_height) return false;
  return others(high.x, high.y) - others(low.x, high.y) - others(high.x, low.y) + others(low.x, low.y) == 0;
}

std::vector<shared::uint> kindsOf(const PlainCells& plain, const RegionTiling& tiling) {
  std::vector<shared::uint> kinds;
  for (int z = 0; z < tiling.groups.y; ++z) {
    for (int x = 0; x < tiling.groups.x; ++x) {
      const glm::ivec2 low = glm::ivec2(x, z) * tiling.inner - tiling.margin;
      kinds.push_back(plain.all(low, low + tiling.region) ? 1 : 0);
    }
  }
  return kinds;
}

std::size_t TailSize::bytes() const {
  const std::size_t d = cells + 1, rightHandSides = cells - first + 1;
  const std::size_t inverse = std::max<std::size_t>(last * last, 4 * WIND_TAIL_GROUP);  // also room for sums
  return (d + rightHandSides + nodes + inverse + last) * sizeof(float);
}

TailSize tailSize(std::span<const PressureLevel> levels, std::size_t first) {
  TailSize size;
  size.first = cellCount(levels[first]);
  size.last = cellCount(levels.back());
  for (std::size_t l = first; l < levels.size(); ++l) {
    size.cells += cellCount(levels[l]);
    if (l > first) size.nodes += nodeCount(levels[l]);
  }
  return size;
}

std::size_t firstOfTail(std::span<const PressureLevel> levels, std::size_t sharedBytes) {
  for (std::size_t first = 1;; ++first) {
    const bool last = first + 1 == levels.size();
    const bool fits = cellCount(levels[first]) <= WIND_TAIL_CELLS && tailSize(levels, first).bytes() <= sharedBytes;
    if (last || fits) return first;
  }
}

bool makesPair(const PressureLevel& level, const PressureLevel& next, const WindGrid& grid) {
  const bool wholeX = !grid.periodicX() || level.width == next.width * next.factorX;
  const bool wholeZ = !grid.periodicZ() || level.height == next.height * next.factorZ;
  return wholeX && wholeZ;
}

}  // namespace windloom
