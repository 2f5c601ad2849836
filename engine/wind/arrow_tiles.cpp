#include "engine/wind/arrow_tiles.hpp"

#include <algorithm>
#include <cmath>

#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

constexpr std::size_t kMaxEntries = 8'000'000;

struct Interval {
  double low, high;
};

/// A bit more than what an arrow reaches, so that rounding loses no cell; m from the low corner of the field.
struct Capsule {
  glm::dvec2 a, b;
  double radius;

  Capsule(const WindGrid& grid, const ArrowForce& arrow)
      : a(glm::dvec2(arrow.from) - glm::dvec2(grid.mapping.minCorner)),
        b(glm::dvec2(arrow.to) - glm::dvec2(grid.mapping.minCorner)),
        radius(double(arrow.radius) * 1.00001 + 0.01 * double(std::max(grid.hx, grid.hz))) {}

  [[nodiscard]] Interval reachZ() const { return {std::min(a.y, b.y) - radius, std::max(a.y, b.y) + radius}; }

  /// How far it reaches towards +x (side 1) or -x (-1) at a height within reachZ().
  [[nodiscard]] double endAt(double z, double side) const {
    const auto disc = [&](glm::dvec2 centre) {
      const double square = radius * radius - (z - centre.y) * (z - centre.y);
      return square >= 0 ? side * centre.x + std::sqrt(square) : -1e300;
    };
    double end = std::max(disc(a), disc(b));
    const glm::dvec2 along = b - a;
    const double length = glm::length(along);
    if (length > 0 && along.y != 0) {  // the straight side between the discs
      const glm::dvec2 out = glm::dvec2(along.y, -along.x) * (radius / length * (along.y * side > 0 ? 1.0 : -1.0));
      const double part = (z - a.y - out.y) / along.y;
      if (part > 0 && part < 1) end = std::max(end, side * (a.x + out.x + part * along.x));
    }
    return side * end;
  }

  /// What it reaches along x between two heights that reachZ() touches. Its sides bulge outwards: they end at the
  /// height nearest to that of the outermost end point.
  [[nodiscard]] Interval reachX(Interval z) const {
    const Interval all = reachZ();
    z = {std::max(z.low, all.low), std::min(z.high, all.high)};
    const bool aIsLow = a.x < b.x;
    return {endAt(std::max(z.low, std::min(z.high, (aIsLow ? a : b).y)), -1),
            endAt(std::max(z.low, std::min(z.high, (aIsLow ? b : a).y)), 1)};
  }
};

/// Calls visit(first tile, number of tiles) for each row of tiles that the arrow reaches into.
template <class Visit>
void eachTileRow(const WindGrid& grid, const ArrowTiles& tiles, const ArrowForce& arrow, Visit visit) {
  const Capsule capsule(grid, arrow);
  const glm::dvec2 size = double(tiles.cellsPerSide) * glm::dvec2(grid.hx, grid.hz);
  const auto tile = [](double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), -1.0, static_cast<double>(count)));
  };
  const Interval z = capsule.reachZ();
  const int last = std::min(tiles.rows - 1, tile(z.high / size.y, tiles.rows));
  for (int row = std::max(0, tile(z.low / size.y, tiles.rows)); row <= last; ++row) {
    const Interval x = capsule.reachX({row * size.y, (row + 1) * size.y});
    const int begin = std::max(0, tile(x.low / size.x, tiles.columns));
    const int end = std::min(tiles.columns, tile(x.high / size.x, tiles.columns) + 1);
    if (begin < end)
      visit(static_cast<std::size_t>(row * tiles.columns + begin), static_cast<std::size_t>(end - begin));
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
    eachTileRow(grid, tiles, arrow, [&](std::size_t first, std::size_t count) {
      for (std::size_t t = first; t < first + count; ++t) ++tiles.start[t + 1];
      sum += count;
    });
    if (sum > kMaxEntries) break;
  }
  return sum;
}

/// Whether the tiles are those of arrows of these shapes already; takes the shapes down if not.
bool sameShapes(const WindGrid& grid, std::span<const ArrowForce> arrows, ArrowTiles& tiles) {
  const auto same = [](const ArrowForce& arrow, const ArrowTiles::Shape& shape) {
    return arrow.from == shape.from && arrow.to == shape.to && arrow.radius == shape.radius;
  };
  const GridMapping &now = grid.mapping, &before = tiles.field;
  if (tiles.cellsPerSide > 0 && now.minCorner == before.minCorner && now.size == before.size &&
      now.resolution == before.resolution &&
      std::equal(arrows.begin(), arrows.end(), tiles.shapes.begin(), tiles.shapes.end(), same))
    return true;
  tiles.field = grid.mapping;
  tiles.shapes.clear();
  for (const ArrowForce& arrow : arrows) tiles.shapes.push_back({arrow.from, arrow.to, arrow.radius});
  return false;
}

}  // namespace

void binArrows(const WindGrid& grid, std::span<const ArrowForce> arrows, ArrowTiles& tiles) {
  if (sameShapes(grid, arrows, tiles)) return;
  int cellsPerSide = WIND_TILE;
  while (countArrows(grid, arrows, cellsPerSide, tiles) > kMaxEntries && tiles.columns * tiles.rows > 1)
    cellsPerSide *= 2;
  for (std::size_t t = 0; t + 1 < tiles.start.size(); ++t) tiles.start[t + 1] += tiles.start[t];
  tiles.indices.resize(tiles.start.back());
  std::vector<std::uint32_t> next(tiles.start.begin(), tiles.start.end() - 1);
  for (std::size_t n = 0; n < arrows.size(); ++n) {
    eachTileRow(grid, tiles, arrows[n], [&](std::size_t first, std::size_t count) {
      for (std::size_t t = first; t < first + count; ++t) tiles.indices[next[t]++] = static_cast<std::uint32_t>(n);
    });
  }
}

}  // namespace windloom
