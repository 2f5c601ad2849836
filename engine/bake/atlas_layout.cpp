#include "engine/bake/atlas_layout.hpp"

#include <algorithm>
#include <tuple>

namespace windloom {
namespace {

/// Less is better.
using Rank = std::tuple<bool, float, int>;

Rank rankOf(int frames, glm::ivec2 tiles, glm::ivec2 tile) {
  const glm::vec2 pixels = tiles * tile;
  const float aspect = std::max(pixels.x, pixels.y) / std::min(pixels.x, pixels.y);
  const bool full = tiles.x * tiles.y == frames && (aspect <= 2.0f || frames == 1);
  return {!full, aspect, -tiles.x};  // equal ones: the wider
}

}  // namespace

std::optional<glm::ivec2> atlasTiles(int frames, glm::ivec2 tile) {
  const glm::ivec2 most = glm::ivec2(kMaxAtlasSide) / tile;
  std::optional<glm::ivec2> best;
  for (int columns = 1; columns <= std::min(most.x, frames); ++columns) {
    const glm::ivec2 tiles(columns, (frames + columns - 1) / columns);
    if (tiles.y > most.y) continue;
    if (!best || rankOf(frames, tiles, tile) < rankOf(frames, *best, tile)) best = tiles;
  }
  return best;
}

}  // namespace windloom
