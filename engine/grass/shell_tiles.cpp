#include "engine/grass/shell_tiles.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr float kLeastSide = 1.0f;          // m
constexpr float kUsualPixelScale = 930.0f;  // pixels a metre covers at 1 m: 768 lines under 45 degrees

struct Box {
  glm::vec3 low, high;
};

class Selector {
 public:
  Selector(const ShellGround& ground, const shared::FrameBlock& frame, float farthest)
      : m_ground(ground), m_frame(frame), m_parallel(shellParallelDistance(frame)), m_farthest(farthest) {}

  void visit(glm::vec2 low, float side) {
    if (glm::any(glm::greaterThanEqual(low, m_ground.high)) || glm::any(glm::lessThanEqual(low + side, m_ground.low))) {
      return;
    }
    const Box box = boxOf(low, side);
    if (!visible(box)) return;
    const glm::vec3 eye(m_frame.cameraPosition);
    const bool parallel = m_frame.cameraPosition.w > 0.5f;
    // The ground's own height counts, as in the shader, not that of the blades on it.
    const glm::vec3 top(box.high.x, box.high.y - m_ground.tallest, box.high.z);
    const float nearest = parallel ? m_parallel : glm::length(eye - glm::clamp(eye, box.low, top));
    if (nearest > m_farthest) return;
    if (side > kLeastSide && nearest < 0.5f * side * SHELL_TILE_REACH) {
      const float half = 0.5f * side;
      for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)}) {
        visit(low + half * corner, half);
      }
      return;
    }
    const float farthest =
        parallel ? m_parallel : glm::length(glm::max(glm::abs(eye - box.low), glm::abs(eye - box.high)));
    tiles.push_back({low, side, nearest, farthest});
  }

  std::vector<ShellTile> tiles;

 private:
  [[nodiscard]] Box boxOf(glm::vec2 low, float side) const {
    HeightRange range;
    if (m_ground.heights != nullptr) range = heightsOver(*m_ground.heights, low, low + side);
    const float tall = m_ground.tallest;
    return {{low.x, range.lowest, low.y}, {low.x + side, range.highest + tall, low.y + side}};
  }

  /// Blades lean out of a tile by their length at most.
  [[nodiscard]] bool visible(const Box& box) const {
    const float tall = m_ground.tallest;
    const glm::vec3 centre = 0.5f * (box.low + box.high), half = 0.5f * (box.high - box.low) + glm::vec3(tall, 0, tall);
    return std::ranges::all_of(m_frame.frustum, [&](const glm::vec4& plane) {
      const glm::vec3 normal(plane);
      return glm::dot(normal, centre) + plane.w >= -glm::dot(glm::abs(normal), half);
    });
  }

  const ShellGround& m_ground;
  const shared::FrameBlock& m_frame;
  float m_parallel, m_farthest;
};

}  // namespace

float shellParallelDistance(const shared::FrameBlock& frame) {
  return kUsualPixelScale / std::max(frame.pixelScale.x, 1e-6f);
}

std::vector<ShellTile> selectShellTiles(const ShellGround& ground, const shared::FrameBlock& frame, float farthest) {
  const glm::vec2 size = ground.high - ground.low;
  // A power of two, so that sides are the same whatever the field's size is.
  const float side = std::exp2(std::ceil(std::log2(std::max({size.x, size.y, kLeastSide}))));
  Selector selector(ground, frame, farthest);
  selector.visit(ground.low, side);
  std::ranges::sort(selector.tiles, {}, &ShellTile::nearest);
  return std::move(selector.tiles);
}

GrowthMask::GrowthMask(const GrassMap* map, glm::vec2 low, glm::vec2 size) : m_low(low), m_size(size) {
  if (map == nullptr || map->size.x <= 0 || map->size.y <= 0) return;
  m_cells.assign(static_cast<std::size_t>(kSide) * kSide, 0);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      // Filtering reaches a pixel further.
      const glm::ivec2 first = glm::max(glm::ivec2(x, y) * map->size / kSide - 1, 0);
      const glm::ivec2 last = glm::min((glm::ivec2(x, y) + 1) * map->size / kSide + 1, map->size - 1);
      unsigned char& cell = m_cells[static_cast<std::size_t>(y * kSide + x)];
      for (int k = first.y; k <= last.y; ++k) {
        for (int i = first.x; i <= last.x; ++i) {
          const std::size_t at =
              4 * (static_cast<std::size_t>(k) * static_cast<std::size_t>(map->size.x) + static_cast<std::size_t>(i));
          cell = std::max({cell, map->pixels[at], map->pixels[at + 1], map->pixels[at + 2]});
        }
      }
    }
  }
}

bool GrowthMask::grows(glm::vec2 low, glm::vec2 high) const {
  if (m_cells.empty()) return true;
  const glm::vec2 first = (low - m_low) / m_size * static_cast<float>(kSide);
  const glm::vec2 last = (high - m_low) / m_size * static_cast<float>(kSide);
  const auto side = static_cast<float>(kSide);
  if (first.x < 0 || first.y < 0 || last.x > side || last.y > side) return true;
  const glm::ivec2 from(first), to = glm::min(glm::ivec2(last), kSide - 1);
  for (int k = from.y; k <= to.y; ++k) {
    for (int i = from.x; i <= to.x; ++i) {
      if (m_cells[static_cast<std::size_t>(k * kSide + i)] > 0) return true;
    }
  }
  return false;
}

}  // namespace windloom
