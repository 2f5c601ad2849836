#include "engine/wind/wind_grid.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/contract.hpp"
#include "engine/model/outline.hpp"

namespace windloom {
namespace {

struct CellBox {
  int iMin, iMax, kMin, kMax;  // inclusive; empty where min > max
};

CellBox cellsWithin(const WindGrid& grid, glm::vec2 centre, float reach) {
  const glm::dvec2 low =
      (glm::dvec2(centre) - double(reach) - glm::dvec2(grid.mapping.minCorner)) / glm::dvec2(grid.hx, grid.hz);
  const glm::dvec2 high =
      (glm::dvec2(centre) + double(reach) - glm::dvec2(grid.mapping.minCorner)) / glm::dvec2(grid.hx, grid.hz);
  const auto cell = [](double value, int count) {
    return static_cast<int>(std::clamp(std::floor(value), -1.0, double(count)));
  };
  return {std::max(0, cell(low.x, grid.width) - 1), std::min(grid.width - 1, cell(high.x, grid.width) + 1),
          std::max(0, cell(low.y, grid.height) - 1), std::min(grid.height - 1, cell(high.y, grid.height) + 1)};
}

void mark(WindGrid& grid, int i, int k) {
  grid.solid[static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(i)] = 1;
}

/// Row by row between pairs of crossings: a test of each cell against each of up to 256 sides would be felt.
void markPolygon(WindGrid& grid, const Obstacle& obstacle, const CellBox& box) {
  const std::vector<glm::vec2> corners = outlineOf(obstacle);
  std::vector<double> crossings;
  for (int k = box.kMin; k <= box.kMax; ++k) {
    const double z = cellCentreToWorld(glm::vec2(0, k), grid.mapping.minCorner, grid.mapping.cellSize).y;
    crossings.clear();
    for (std::size_t n = 0; n < corners.size(); ++n) {
      const glm::dvec2 a = corners[n], b = corners[(n + 1) % corners.size()];
      if ((a.y > z) != (b.y > z)) crossings.push_back(a.x + (z - a.y) / (b.y - a.y) * (b.x - a.x));
    }
    std::ranges::sort(crossings);
    for (int i = box.iMin; i <= box.iMax && !crossings.empty(); ++i) {
      const double x = cellCentreToWorld(glm::vec2(i, k), grid.mapping.minCorner, grid.mapping.cellSize).x;
      const auto before = std::ranges::lower_bound(crossings, x) - crossings.begin();
      if (before % 2 == 1) mark(grid, i, k);
    }
  }
}

}  // namespace

bool WindGrid::blockedX(int i, int k) const {
  if (i == 0 || i == width) {
    if (periodicX()) return solidAt(0, k) || solidAt(width - 1, k);
    return (i == 0 ? xMin : xMax) == Border::Wall || solidAt(i == 0 ? 0 : width - 1, k);
  }
  return solidAt(i - 1, k) || solidAt(i, k);
}

bool WindGrid::blockedZ(int i, int k) const {
  if (k == 0 || k == height) {
    if (periodicZ()) return solidAt(i, 0) || solidAt(i, height - 1);
    return (k == 0 ? zMin : zMax) == Border::Wall || solidAt(i, k == 0 ? 0 : height - 1);
  }
  return solidAt(i, k - 1) || solidAt(i, k);
}

WindGrid makeWindGrid(const FieldSettings& field, std::span<const Obstacle> obstacles) {
  WL_REQUIRE(field.resolution.x > 0 && field.resolution.y > 0 && field.size.x > 0 && field.size.y > 0,
             "an empty field");
  WL_REQUIRE((field.xMin == Border::Periodic) == (field.xMax == Border::Periodic), "periodic sides come in pairs");
  WL_REQUIRE((field.zMin == Border::Periodic) == (field.zMax == Border::Periodic), "periodic sides come in pairs");
  WindGrid grid;
  grid.mapping = makeGridMapping(field.centre, field.size, field.resolution);
  grid.width = field.resolution.x;
  grid.height = field.resolution.y;
  grid.hx = grid.mapping.cellSize.x;
  grid.hz = grid.mapping.cellSize.y;
  grid.xMin = field.xMin;
  grid.xMax = field.xMax;
  grid.zMin = field.zMin;
  grid.zMax = field.zMax;
  rasteriseSolids(grid, obstacles);
  return grid;
}

void rasteriseSolids(WindGrid& grid, std::span<const Obstacle> obstacles) {
  const std::size_t cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  grid.solid.assign(cells, 0);
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.muted) continue;
    const CellBox box = cellsWithin(grid, obstacle.centre, reachOf(obstacle));
    if (obstacle.shape == ObstacleShape::Polygon) {
      markPolygon(grid, obstacle, box);
      continue;
    }
    for (int k = box.kMin; k <= box.kMax; ++k) {
      for (int i = box.iMin; i <= box.iMax; ++i) {
        if (isInside(obstacle, cellCentreToWorld(glm::vec2(i, k), grid.mapping.minCorner, grid.mapping.cellSize)))
          mark(grid, i, k);
      }
    }
  }
  grid.airCells = cells - static_cast<std::size_t>(std::count(grid.solid.begin(), grid.solid.end(), std::uint8_t{1}));
}

}  // namespace windloom
