// The levels of the pressure solve: the exact solve of the last one, and the regions that hold nothing but air.
#include <gtest/gtest.h>

#include <random>

#include "engine/wind/dense_inverse.hpp"
#include "engine/wind/gpu_levels.hpp"

namespace windloom {
namespace {

WindGrid gridOf(glm::ivec2 cells, Border border) {
  FieldSettings field;
  field.resolution = cells;
  field.size = glm::vec2(cells);
  field.centre = field.size / 2.0f;
  field.xMin = field.xMax = field.zMin = field.zMax = border;
  return makeWindGrid(field, {});
}

/// (A d) of cell (i, k), from the level's own conductances.
double applied(const PressureLevel& level, const std::vector<double>& d, int i, int k) {
  const int w = level.width, h = level.height;
  const auto at = [&](int x, int z) { return d[std::size_t(((z + h) % h) * w + (x + w) % w)]; };
  const double own = at(i, k);
  const auto cx = [&](int x) { return double(level.cx[std::size_t(k * (w + 1) + x)]); };
  const auto cz = [&](int z) { return double(level.cz[std::size_t(z * w + i)]); };
  double sum = cx(i) * (at(i - 1, k) - own) + cx(i + 1) * (at(i + 1, k) - own);
  sum += cz(k) * (at(i, k - 1) - own) + cz(k + 1) * (at(i, k + 1) - own);
  if (i == 0) sum -= double(level.groundX[std::size_t(2 * k)]) * own;
  if (i == w - 1) sum -= double(level.groundX[std::size_t(2 * k + 1)]) * own;
  if (k == 0) sum -= double(level.groundZ[std::size_t(2 * i)]) * own;
  if (k == h - 1) sum -= double(level.groundZ[std::size_t(2 * i + 1)]) * own;
  return sum;
}

/// Solves the last level for a random right-hand side whose sum over each half of the field is 0, and gives back how
/// far A d is from it.
double errorOfLastLevel(const WindGrid& grid) {
  const PressureLevel level = buildPressureLevels(grid).back();
  const std::size_t count = cellCount(level);
  EXPECT_LE(count, std::size_t(WIND_DENSE_CELLS));
  EXPECT_GT(count, 8u);
  const std::vector<float> inverse = denseInverse(level);
  std::mt19937 random(3);
  std::vector<double> b(count, 0.0), d(count, 0.0);
  for (const bool right : {false, true}) {
    double sum = 0;
    std::size_t last = count;
    for (std::size_t c = 0; c < count; ++c) {
      const bool inHalf = (int(c) % level.width >= level.width / 2) == right;
      if (!inHalf || !(level.inverseDiagonal[c] > 0)) continue;
      b[c] = std::uniform_real_distribution(-1.0, 1.0)(random);
      sum += b[c];
      last = c;
    }
    if (last < count) b[last] -= sum;
  }
  for (std::size_t r = 0; r < count; ++r) {
    for (std::size_t c = 0; c < count; ++c) d[r] += double(inverse[r * count + c]) * b[c];
  }
  double worst = 0;
  for (std::size_t c = 0; c < count; ++c) {
    if (!(level.inverseDiagonal[c] > 0)) {
      EXPECT_EQ(d[c], 0.0) << "a cell without air";
      continue;
    }
    const int i = int(c) % level.width, k = int(c) / level.width;
    worst = std::max(worst, std::abs(applied(level, d, i, k) - b[c]));
  }
  return worst;
}

TEST(WindLevels, TheLastOneIsSolvedExactly) {
  for (const Border border : {Border::Open, Border::Wall, Border::Periodic}) {
    EXPECT_LE(errorOfLastLevel(gridOf({60, 52}, border)), 2e-5);
  }
}

TEST(WindLevels, TheLastOneIsSolvedExactlyInRoomsWithoutAWayOut) {
  WindGrid grid = gridOf({64, 64}, Border::Wall);
  for (int k = 0; k < 64; ++k) {
    for (int i = 24; i < 40; ++i) grid.solid[std::size_t(k * 64 + i)] = 1;  // two rooms
  }
  EXPECT_LE(errorOfLastLevel(grid), 2e-5);
}

TEST(WindLevels, RegionsArePlainUnlessABorderOrASolidIsNear) {
  WindGrid grid = gridOf({100, 100}, Border::Open);
  grid.solid[50 * 100 + 70] = 1;
  const PlainCells cells(grid);
  EXPECT_TRUE(cells.all({1, 1}, {69, 50}));
  EXPECT_FALSE(cells.all({0, 1}, {20, 20})) << "the border's own cells";
  EXPECT_FALSE(cells.all({-1, 1}, {20, 20})) << "outside";
  EXPECT_FALSE(cells.all({69, 50}, {70, 51})) << "beside the solid";
  EXPECT_TRUE(cells.all({69, 49}, {70, 50})) << "across its corner";
  const std::vector<shared::uint> kinds = kindsOf(cells, {{32, 32}, {4, 4}, {3, 3}, 40});
  EXPECT_EQ(kinds, (std::vector<shared::uint>{0, 0, 0, 0, 1, 0, 0, 0, 0}));
}

TEST(WindLevels, CoarseRegionsArePlainWhereTheirFacesAreWhole) {
  WindGrid grid = gridOf({101, 101}, Border::Wall);
  grid.solid[50 * 101 + 50] = 1;
  const std::vector<PressureLevel> levels = buildPressureLevels(grid);
  const PlainCells cells(levels[1], packFaces(levels[1]));
  EXPECT_TRUE(cells.all({1, 1}, {24, 49}));
  EXPECT_FALSE(cells.all({25, 25}, {26, 26})) << "holds the solid";
  EXPECT_FALSE(cells.all({1, 1}, {24, 51})) << "the last row is half as high";
}

}  // namespace
}  // namespace windloom
