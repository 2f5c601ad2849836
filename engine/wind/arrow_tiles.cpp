#include "engine/wind/arrow_tiles.hpp"

#include <algorithm>
#include <cmath>

#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

constexpr std::size_t kMaxEntries = 8'000'000;

struct TileBox {
  int aMin, aMax, bMin, bMax;  // inclusive; empty where min > max
};

TileBox tilesNear(const WindGrid& grid, const ArrowTiles& tiles, const ArrowForce& arrow) {
  const glm::dvec2 cellSize(grid.hx, grid.hz);
  const glm::dvec2 low =
      (glm::dvec2(glm::min(arrow.from, arrow.to)) - double(arrow.radius) - glm::dvec2(grid.mapping.minCorner)) /
      cellSize;
  const glm::dvec2 high =
      (glm::dvec2(glm::max(arrow.from, arrow.to)) + double(arrow.radius) - glm::dvec2(grid.mapping.minCorner)) /
      cellSize;
  const auto tile = [&](double cell, int count) {
    return static_cast<int>(std::clamp(std::floor(cell / tiles.cellsPerSide), -1.0, static_cast<double>(count)));
  };
  return {std::max(0, tile(low.x - 1, tiles.columns)), std::min(tiles.columns - 1, tile(high.x + 1, tiles.columns)),
          std::max(0, tile(low.y - 1, tiles.rows)), std::min(tiles.rows - 1, tile(high.y + 1, tiles.rows))};
}

/// Whether the arrow's capsule can reach the tile: the box alone would give a long slanted arrow far too many tiles.
bool reaches(const WindGrid& grid, const ArrowTiles& tiles, const ArrowForce& arrow, int a, int b) {
  const glm::vec2 extent = float(tiles.cellsPerSide) * grid.mapping.cellSize;
  const glm::vec2 centre = grid.mapping.minCorner + (glm::vec2(a, b) + 0.5f) * extent;
  const glm::vec2 along = arrow.to - arrow.from;
  const float square = glm::dot(along, along);
  const float t = square > 0 ? std::clamp(glm::dot(centre - arrow.from, along) / square, 0.0f, 1.0f) : 0.0f;
  const glm::vec2 away = glm::abs(centre - (arrow.from + along * t)) * 0.999f;
  return glm::length(away) <= arrow.radius + glm::length(extent) * 0.501f;
}

template <class Visit>
void eachTile(const WindGrid& grid, const ArrowTiles& tiles, const ArrowForce& arrow, Visit visit) {
  const TileBox box = tilesNear(grid, tiles, arrow);
  for (int b = box.bMin; b <= box.bMax; ++b) {
    for (int a = box.aMin; a <= box.aMax; ++a) {
      if (reaches(grid, tiles, arrow, a, b)) visit(static_cast<std::size_t>(b * tiles.columns + a));
    }
  }
}

/// Lays out the tiles and counts their arrows into start[t + 1]; the sum.
std::size_t countArrows(const WindGrid& grid, std::span<const ArrowForce> arrows, int cellsPerSide, ArrowTiles& tiles) {
  tiles.cellsPerSide = cellsPerSide;
  tiles.columns = (grid.width + cellsPerSide - 1) / cellsPerSide;
  tiles.rows = (grid.height + cellsPerSide - 1) / cellsPerSide;
  tiles.start.assign(static_cast<std::size_t>(tiles.columns * tiles.rows) + 1, 0);
  std::size_t sum = 0;
  for (const ArrowForce& arrow : arrows) {
    eachTile(grid, tiles, arrow, [&](std::size_t t) {
      ++tiles.start[t + 1];
      ++sum;
    });
    if (sum > kMaxEntries) break;
  }
  return sum;
}

}  // namespace

void binArrows(const WindGrid& grid, std::span<const ArrowForce> arrows, ArrowTiles& tiles) {
  int cellsPerSide = WIND_TILE;
  while (countArrows(grid, arrows, cellsPerSide, tiles) > kMaxEntries && tiles.columns * tiles.rows > 1)
    cellsPerSide *= 2;
  for (std::size_t t = 0; t + 1 < tiles.start.size(); ++t) tiles.start[t + 1] += tiles.start[t];
  tiles.indices.resize(tiles.start.back());
  std::vector<std::uint32_t> next(tiles.start.begin(), tiles.start.end() - 1);
  for (std::size_t n = 0; n < arrows.size(); ++n) {
    eachTile(grid, tiles, arrows[n], [&](std::size_t t) { tiles.indices[next[t]++] = static_cast<std::uint32_t>(n); });
  }
}

}  // namespace windloom
