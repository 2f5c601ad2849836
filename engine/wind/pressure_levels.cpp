// Cell-centred multigrid: Wesseling, An Introduction to Multigrid Methods, 1992; solids as open lengths of coarse faces
// in the manner of McAdams, Sifakis & Teran, A parallel multigrid Poisson solver for fluids simulation on large grids,
// 2010.
#include "engine/wind/pressure_levels.hpp"

#include <algorithm>

#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

using Index = std::size_t;

/// A level while it is being built: where its columns and rows lie, and how much of each face is open.
struct Geometry {
  int width = 0, height = 0;
  glm::dvec2 cellSize{0};
  std::vector<double> columns, rows;  // widths, m
  std::vector<double> openX, openZ;   // open lengths of the faces, m
};

Index at(int i, int k, int stride) {
  return static_cast<Index>(k) * static_cast<Index>(stride) + static_cast<Index>(i);
}

Geometry fineGeometry(const WindGrid& grid) {
  Geometry g;
  g.width = grid.width;
  g.height = grid.height;
  g.cellSize = {grid.hx, grid.hz};
  g.columns.assign(static_cast<Index>(g.width), g.cellSize.x);
  g.rows.assign(static_cast<Index>(g.height), g.cellSize.y);
  g.openX.resize(static_cast<Index>(g.width + 1) * static_cast<Index>(g.height));
  g.openZ.resize(static_cast<Index>(g.width) * static_cast<Index>(g.height + 1));
  for (int k = 0; k < g.height; ++k) {
    for (int i = 0; i <= g.width; ++i) g.openX[at(i, k, g.width + 1)] = grid.blockedX(i, k) ? 0.0 : g.cellSize.y;
  }
  for (int k = 0; k <= g.height; ++k) {
    for (int i = 0; i < g.width; ++i) g.openZ[at(i, k, g.width)] = grid.blockedZ(i, k) ? 0.0 : g.cellSize.x;
  }
  return g;
}

Geometry coarsen(const Geometry& fine, glm::ivec2 factor) {
  Geometry g;
  g.width = (fine.width + factor.x - 1) / factor.x;
  g.height = (fine.height + factor.y - 1) / factor.y;
  g.cellSize = fine.cellSize * glm::dvec2(factor);
  g.columns.assign(static_cast<Index>(g.width), 0);
  g.rows.assign(static_cast<Index>(g.height), 0);
  for (int i = 0; i < fine.width; ++i)
    g.columns[static_cast<Index>(i / factor.x)] += fine.columns[static_cast<Index>(i)];
  for (int k = 0; k < fine.height; ++k) g.rows[static_cast<Index>(k / factor.y)] += fine.rows[static_cast<Index>(k)];
  g.openX.assign(static_cast<Index>(g.width + 1) * static_cast<Index>(g.height), 0);
  g.openZ.assign(static_cast<Index>(g.width) * static_cast<Index>(g.height + 1), 0);
  for (int k = 0; k < fine.height; ++k) {
    for (int i = 0; i <= g.width; ++i) {
      g.openX[at(i, k / factor.y, g.width + 1)] +=
          fine.openX[at(std::min(i * factor.x, fine.width), k, fine.width + 1)];
    }
  }
  for (int k = 0; k <= g.height; ++k) {
    for (int i = 0; i < fine.width; ++i) {
      g.openZ[at(i / factor.x, k, g.width)] += fine.openZ[at(i, std::min(k * factor.y, fine.height), fine.width)];
    }
  }
  return g;
}

/// Conductance between a face's two cells, or to the ground behind an open border.
struct Link {
  double between = 0, groundLow = 0, groundHigh = 0;  // ground of the cell on the face's low or high side
};

Link linkOf(double open, int face, const std::vector<double>& widths, Border low, Border high) {
  const int count = static_cast<int>(widths.size());
  if (face > 0 && face < count) {
    return {2 * open / (widths[static_cast<Index>(face - 1)] + widths[static_cast<Index>(face)]), 0, 0};
  }
  const Border border = face == 0 ? low : high;
  if (border == Border::Periodic) return {count > 1 ? 2 * open / (widths.front() + widths.back()) : 0.0, 0, 0};
  if (border == Border::Wall) return {};
  return face == 0 ? Link{0, 0, 2 * open / widths.front()} : Link{0, 2 * open / widths.back(), 0};
}

PressureLevel levelOf(const Geometry& g, const WindGrid& grid, glm::ivec2 factor) {
  PressureLevel level;
  level.width = g.width;
  level.height = g.height;
  level.factorX = factor.x;
  level.factorZ = factor.y;
  level.cx.assign(g.openX.size(), 0);
  level.shareX.assign(g.openX.size(), 0);
  level.cz.assign(g.openZ.size(), 0);
  level.shareZ.assign(g.openZ.size(), 0);
  std::vector<double> diagonal(static_cast<Index>(g.width) * static_cast<Index>(g.height), 0);
  level.groundX.assign(2 * static_cast<Index>(g.height), 0);
  level.groundZ.assign(2 * static_cast<Index>(g.width), 0);
  level.scale = glm::vec2(g.cellSize.y / g.cellSize.x, g.cellSize.x / g.cellSize.y);
  const auto add = [&](const Link& link, int lowCell, int highCell) {  // cells by index, -1 outside
    if (lowCell >= 0) diagonal[static_cast<Index>(lowCell)] += link.between + link.groundLow;
    if (highCell >= 0) diagonal[static_cast<Index>(highCell)] += link.between + link.groundHigh;
  };
  for (int k = 0; k < g.height; ++k) {
    for (int i = 0; i <= g.width; ++i) {
      const Index f = at(i, k, g.width + 1);
      const Link link = linkOf(g.openX[f], i, g.columns, grid.xMin, grid.xMax);
      level.cx[f] = static_cast<float>(link.between);
      level.shareX[f] = static_cast<float>(g.openX[f] / g.rows[static_cast<Index>(k)]);
      if (i == 0) level.groundX[2 * static_cast<Index>(k)] = static_cast<float>(link.groundHigh);
      if (i == g.width) level.groundX[2 * static_cast<Index>(k) + 1] = static_cast<float>(link.groundLow);
      add(link, i > 0 ? k * g.width + i - 1 : -1, i < g.width ? k * g.width + i : -1);
    }
  }
  for (int k = 0; k <= g.height; ++k) {
    for (int i = 0; i < g.width; ++i) {
      const Index f = at(i, k, g.width);
      const Link link = linkOf(g.openZ[f], k, g.rows, grid.zMin, grid.zMax);
      level.cz[f] = static_cast<float>(link.between);
      level.shareZ[f] = static_cast<float>(g.openZ[f] / g.columns[static_cast<Index>(i)]);
      if (k == 0) level.groundZ[2 * static_cast<Index>(i)] = static_cast<float>(link.groundHigh);
      if (k == g.height) level.groundZ[2 * static_cast<Index>(i) + 1] = static_cast<float>(link.groundLow);
      add(link, k > 0 ? (k - 1) * g.width + i : -1, k < g.height ? k * g.width + i : -1);
    }
  }
  level.inverseDiagonal.assign(diagonal.size(), 0);
  std::transform(diagonal.begin(), diagonal.end(), level.inverseDiagonal.begin(),
                 [](double d) { return d > 0 ? static_cast<float>(1 / d) : 0.0f; });
  return level;
}

/// By how much a level of this many cells of this nominal size is coarsened; (1, 1) for a single cell.
glm::ivec2 coarseningOf(glm::ivec2 cells, glm::dvec2 cellSizeM) {
  constexpr double kSimilar = 1.5;  // beyond this the smoother damps only the direction of the short cell size
  return {cells.x > 1 && (cells.y == 1 || cellSizeM.x <= kSimilar * cellSizeM.y) ? 2 : 1,
          cells.y > 1 && (cells.x == 1 || cellSizeM.y <= kSimilar * cellSizeM.x) ? 2 : 1};
}

}  // namespace

std::vector<PressureLevel> buildPressureLevels(const WindGrid& grid, FinestLevel finest) {
  std::vector<PressureLevel> levels;
  Geometry geometry = fineGeometry(grid);
  if (finest == FinestLevel::Full) {
    levels.push_back(levelOf(geometry, grid, {1, 1}));
  } else {
    levels.emplace_back();
    levels.back().width = geometry.width;
    levels.back().height = geometry.height;
    levels.back().scale =
        glm::vec2(geometry.cellSize.y / geometry.cellSize.x, geometry.cellSize.x / geometry.cellSize.y);
  }
  for (;;) {
    const glm::ivec2 factor = coarseningOf({geometry.width, geometry.height}, geometry.cellSize);
    const bool small = geometry.width * geometry.height <= WIND_DENSE_CELLS && levels.size() > 1;
    if (small || factor == glm::ivec2(1)) return levels;
    geometry = coarsen(geometry, factor);
    levels.push_back(levelOf(geometry, grid, factor));
  }
}

}  // namespace windloom
