#include "engine/render/ground_tiles.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr int kSide = GROUND_TILE_SIDE;
// The way out to the horizon is cut at least so often, since it is curved outwards.
constexpr int kCoarsestOutside = 3;

/// How far the samples that a level leaves out lie from the lattice that it keeps.
float levelError(const HeightField& field, glm::ivec2 first, int level) {
  const glm::ivec2 last = field.source->samples - 1;
  const int step = 1 << level, half = step / 2;
  const auto at = [&](int i, int k) { return field.at(std::min(i, last.x), std::min(k, last.y)); };
  float error = 0;
  for (int k = first.y; k <= std::min(first.y + kSide, last.y); k += half) {
    for (int i = first.x; i <= std::min(first.x + kSide, last.x); i += half) {
      const bool betweenX = (i - first.x) % step != 0, betweenZ = (k - first.y) % step != 0;
      if (!betweenX && !betweenZ) continue;
      const int x = betweenX ? half : 0, z = betweenZ ? half : 0;
      const float corners = betweenX && betweenZ ? 0.25f * (at(i - x, k - z) + at(i + x, k - z) + at(i - x, k + z) + at(i + x, k + z))
                                                 : 0.5f * (at(i - x, k - z) + at(i + x, k + z));
      error = std::max(error, std::abs(at(i, k) - corners));
    }
  }
  return error;
}

class Selector {
 public:
  Selector(const HeightField& field, const GroundTiles& tiles, const FrameBlock& frame, float reach)
      : m_field(field), m_tiles(tiles), m_frame(frame), m_reach(reach), m_size(tiles.count + 2), m_level(static_cast<std::size_t>(m_size.x) * static_cast<std::size_t>(m_size.y)) {}

  GroundSelection select(float pixels) {
    for (int z = 1; z <= m_tiles.count.y; ++z) {
      for (int x = 1; x <= m_tiles.count.x; ++x) level({x, z}) = wantedLevel({x, z}, pixels);
    }
    for (int z = 0; z < m_size.y; ++z) {
      for (int x = 0; x < m_size.x; ++x) {
        const glm::ivec2 inner = glm::clamp(glm::ivec2(x, z), glm::ivec2(1), m_tiles.count);
        if (inner != glm::ivec2(x, z)) level({x, z}) = std::min(level(inner), kCoarsestOutside);
      }
    }
    GroundSelection selection;
    for (int z = 0; z < m_size.y; ++z) {
      for (int x = 0; x < m_size.x; ++x) {
        if (!visible({x, z})) continue;
        const int own = level({x, z});
        selection.levels[static_cast<std::size_t>(own)].push_back(tileAt({x, z}));
        const int quads = kSide >> own;
        selection.triangles += 2l * quads * quads;
      }
    }
    return selection;
  }

 private:
  int& level(glm::ivec2 tile) { return m_level[static_cast<std::size_t>(tile.y) * static_cast<std::size_t>(m_size.x) + static_cast<std::size_t>(tile.x)]; }

  const GroundTiles::Tile& inside(glm::ivec2 tile) const {
    const glm::ivec2 at = glm::clamp(tile, glm::ivec2(1), m_tiles.count) - 1;
    return m_tiles.tiles[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(m_tiles.count.x) + static_cast<std::size_t>(at.x)];
  }

  GroundTile tileAt(glm::ivec2 tile) {
    std::uint32_t around = 0;
    const glm::ivec2 ways[] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    for (int side = 0; side < 4; ++side) {
      const glm::ivec2 next = glm::clamp(tile + ways[side], glm::ivec2(0), m_size - 1);
      around |= static_cast<std::uint32_t>(std::max(level(next), level(tile))) << (8 * side);
    }
    return {static_cast<std::uint32_t>(tile.x), static_cast<std::uint32_t>(tile.y), static_cast<std::uint32_t>(level(tile)), around};
  }

  struct Box {
    glm::vec3 low, high;
  };
  Box boxOf(glm::ivec2 tile) const {
    const GroundTiles::Tile& known = inside(tile);
    Box box{{0, known.lowest, 0}, {0, known.highest, 0}};
    for (int axis = 0; axis < 2; ++axis) {
      const int out = axis == 0 ? 0 : 2, last = m_field.source->samples[axis] - 1;
      const float low = m_field.low[axis], spacing = m_field.spacing()[axis], high = low + m_field.size[axis];
      const int first = (tile[axis] - 1) * kSide;
      const bool before = tile[axis] == 0, behind = tile[axis] > m_tiles.count[axis];
      box.low[out] = before ? low - m_reach : behind ? high : low + spacing * static_cast<float>(first);
      box.high[out] = before ? low : behind ? high + m_reach : low + spacing * static_cast<float>(std::min(first + kSide, last));
    }
    return box;
  }

  bool visible(glm::ivec2 tile) const {
    const Box box = boxOf(tile);
    const glm::vec3 centre = 0.5f * (box.low + box.high), half = 0.5f * (box.high - box.low);
    return std::ranges::all_of(m_frame.frustum, [&](const glm::vec4& plane) {
      const glm::vec3 normal(plane);
      return glm::dot(normal, centre) + plane.w >= -glm::dot(glm::abs(normal), half);
    });
  }

  int wantedLevel(glm::ivec2 tile, float pixels) const {
    const Box box = boxOf(tile);
    const glm::vec3 camera(m_frame.cameraPosition);
    const float distance = glm::length(camera - glm::clamp(camera, box.low, box.high));
    const bool orthographic = m_frame.cameraPosition.w > 0.5f;
    const float perMetre = m_frame.pixelScale.x / (orthographic ? 1.0f : std::max(distance, 0.5f));
    const auto& error = inside(tile).error;
    int wanted = 0;
    while (wanted + 1 < GROUND_LEVELS && error[static_cast<std::size_t>(wanted) + 1] * perMetre <= pixels) ++wanted;
    return wanted;
  }

  const HeightField& m_field;
  const GroundTiles& m_tiles;
  const FrameBlock& m_frame;
  float m_reach;
  glm::ivec2 m_size;
  std::vector<int> m_level;
};

}  // namespace

GroundTiles measureGroundTiles(const HeightField& field) {
  GroundTiles tiles;
  tiles.count = (field.source->samples - 1 + kSide - 1) / kSide;
  tiles.tiles.reserve(static_cast<std::size_t>(tiles.count.x) * static_cast<std::size_t>(tiles.count.y));
  const glm::vec2 spacing = field.spacing();
  for (int z = 0; z < tiles.count.y; ++z) {
    for (int x = 0; x < tiles.count.x; ++x) {
      const glm::ivec2 first(x * kSide, z * kSide);
      GroundTiles::Tile tile;
      const glm::vec2 low = field.low + spacing * glm::vec2(first);
      const HeightRange range = heightsOver(field, low, low + spacing * static_cast<float>(kSide));
      tile.lowest = range.lowest;
      tile.highest = range.highest;
      for (int level = 1; level < GROUND_LEVELS; ++level) {
        const auto at = static_cast<std::size_t>(level);
        tile.error[at] = tile.error[at - 1] + levelError(field, first, level);
      }
      tiles.tiles.push_back(tile);
    }
  }
  return tiles;
}

GroundSelection selectGroundTiles(const HeightField& field, const GroundTiles& tiles, const FrameBlock& frame, float reach,
                                  float pixels, long mostTriangles) {
  Selector selector(field, tiles, frame, reach);
  GroundSelection selection = selector.select(pixels);
  for (int tries = 0; tries < 12 && selection.triangles > mostTriangles; ++tries) {
    pixels *= 1.6f;
    selection = selector.select(pixels);
  }
  return selection;
}

}  // namespace windloom
