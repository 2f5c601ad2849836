// Arrows, gusts, confinement, dissipation.
#include <gtest/gtest.h>

#include "engine/wind/arrow_tiles.hpp"
#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

glm::vec2 cellAt(CpuWindSolver& solver, glm::vec2 world) {
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  const glm::ivec2 cell = cellOf(solver.grid(), world);
  return cells[static_cast<std::size_t>(cell.y * solver.grid().resolution.x + cell.x)];
}

WindSetup meadow(int cells = 200) {
  WindSetup setup;
  setup.field.resolution = {cells, cells};
  return setup;
}

TEST(WindForces, SpeedDriveReachesItsSpeedAlongTheArrowAndNeverMore) {
  CpuWindSolver solver(meadow(), 1);
  const ArrowForce arrows[] = {arrow({-20, 0}, {20, 20}, 9, 5)};
  run(solver, 300, arrows);
  const glm::vec2 wind = cellAt(solver, {0, 10});
  EXPECT_NEAR(glm::length(wind), 9, 0.9f);
  EXPECT_GE(glm::dot(glm::normalize(wind), arrows[0].direction), 0.995f);
  EXPECT_LE(solver.diagnostics().maxSpeed, 10.5);
}

TEST(WindForces, SpeedDriveDoesNotBrakeFasterAirAlongItself) {
  WindSetup setup = bareSetup({64, 64}, 1, Border::Periodic, 1.0f / 60);
  CpuWindSolver solver(setup, 1);
  const std::vector<glm::vec2> fast(64 * 64, glm::vec2(12, 0));
  ASSERT_TRUE(solver.setVelocity(fast));
  const ArrowForce arrows[] = {arrow({20, 32}, {44, 32}, 5, 8)};
  run(solver, 60, arrows);
  EXPECT_NEAR(cellAt(solver, {32, 32}).x, 12, 1e-3f);
}

TEST(WindForces, SpeedDriveNeverOvershootsHoweverShortItsResponse) {
  CpuWindSolver solver(meadow(100), 1);
  ArrowForce a = arrow({-30, 0}, {30, 0}, 10, 10);
  a.response = 1e-6f;
  run(solver, 60, std::span(&a, 1));
  EXPECT_LE(solver.diagnostics().maxSpeed, 13);
  EXPECT_GE(cellAt(solver, {0, 0}).x, 8.5f);
}

TEST(WindForces, ForceDriveAcceleratesByItsStrength) {
  // Across a periodic field a drive that is the same everywhere along x has nothing to push against.
  CpuWindSolver solver(bareSetup({64, 64}, 1, Border::Periodic, 0.01f), 1);
  ArrowForce a = arrow({-1000, 32}, {1000, 32}, 3, 6);
  a.drive = ARROW_DRIVE_FORCE;
  run(solver, 50, std::span(&a, 1), 0.01);
  EXPECT_NEAR(cellAt(solver, {32.5f, 32.5f}).x, 3 * 0.5 * std::exp(-2 * 0.25 / 36), 0.02f);
  EXPECT_NEAR(cellAt(solver, {32.5f, 45.5f}).x, 0, 1e-4f) << "outside its radius";
}

TEST(WindForces, EndDiscActsOnlyAroundTheEndPoint) {
  CpuWindSolver solver(meadow(), 1);
  ArrowForce a = arrow({-20, 0}, {20, 0}, 9, 4);
  a.from = a.to;
  run(solver, 10, std::span(&a, 1));
  EXPECT_GE(cellAt(solver, {20, 0}).x, 1.5f);
  EXPECT_LE(std::abs(cellAt(solver, {-15, 0}).x), 0.1f);
}

TEST(WindForces, SwirlTurnsFromXTowardsZWhenPositive) {
  CpuWindSolver solver(meadow(), 1);
  ArrowForce a = arrow({-8, 0}, {0, 0}, 0, 8);
  a.swirl = 6;
  run(solver, 240, std::span(&a, 1));
  EXPECT_NEAR(cellAt(solver, {4, 0}).y, 6, 1.0f);
  EXPECT_NEAR(cellAt(solver, {0, 4}).x, -6, 1.0f);
  a.swirl = -6;
  run(solver, 600, std::span(&a, 1));
  EXPECT_LE(cellAt(solver, {4, 0}).y, -4.5f);
}

TEST(WindForces, AFadingSignalLetsGoOfTheAir) {
  WindSetup setup = bareSetup({64, 64}, 1, Border::Periodic, 1.0f / 60);
  CpuWindSolver solver(setup, 1);
  const std::vector<glm::vec2> across(64 * 64, glm::vec2(0, 6));
  ASSERT_TRUE(solver.setVelocity(across));
  ArrowForce a = arrow({0, 32}, {64, 32}, 0.001f, 10);
  a.factor = 1e-4f;
  run(solver, 30, std::span(&a, 1));
  EXPECT_NEAR(cellAt(solver, {32, 32}).y, 6, 0.01f);
}

TEST(WindForces, TilesNameEveryArrowThatReachesACell) {
  const WindGrid grid = makeWindGrid(meadow(150).field, {});
  std::vector<ArrowForce> arrows;
  for (int n = 0; n < 60; ++n) {
    const float a = static_cast<float>(n);
    arrows.push_back(arrow({50 * std::sin(a), 50 * std::cos(1.7f * a)},
                           {45 * std::cos(2.3f * a), 60 * std::sin(0.9f * a)}, 5, 0.2f + 0.2f * a));
  }
  ArrowTiles tiles;
  binArrows(grid, arrows, tiles);
  int reached = 0;
  for (int k = 0; k < 150; k += 3) {
    for (int i = 0; i < 150; i += 3) {
      const glm::vec2 centre = cellCentreToWorld(glm::vec2(i, k), grid.mapping.minCorner, grid.mapping.cellSize);
      const int t = (k / tiles.cellsPerSide) * tiles.columns + i / tiles.cellsPerSide;
      const auto begin = tiles.indices.begin() + tiles.start[static_cast<std::size_t>(t)];
      const auto end = tiles.indices.begin() + tiles.start[static_cast<std::size_t>(t) + 1];
      for (std::uint32_t n = 0; n < arrows.size(); ++n) {
        const ArrowForce& a = arrows[n];
        const glm::vec2 along = a.to - a.from;
        const float s = std::clamp(glm::dot(centre - a.from, along) / glm::dot(along, along), 0.0f, 1.0f);
        if (glm::length(centre - a.from - s * along) >= a.radius) continue;
        ++reached;
        ASSERT_TRUE(std::binary_search(begin, end, n)) << "arrow " << n << " at cell " << i << ", " << k;
      }
    }
  }
  EXPECT_GT(reached, 1000);
  EXPECT_LT(tiles.indices.size(), arrows.size() * static_cast<std::size_t>(tiles.columns * tiles.rows) / 2);
}

TEST(WindForces, TilesFollowArrowsAndFieldsThatMove) {
  WindSetup setup = meadow(150);
  std::vector<ArrowForce> arrows = {arrow({-20, 3}, {10, 9}, 5, 4), arrow({0, -30}, {0, 30}, 5, 2)};
  ArrowTiles tiles;
  const auto expectFresh = [&] {
    const WindGrid grid = makeWindGrid(setup.field, {});
    ArrowTiles fresh;
    binArrows(grid, arrows, tiles);
    binArrows(grid, arrows, fresh);
    EXPECT_EQ(tiles.start, fresh.start);
    EXPECT_EQ(tiles.indices, fresh.indices);
  };
  expectFresh();
  arrows[1].to = {25, 30};
  expectFresh();
  arrows[0].radius = 9;
  expectFresh();
  setup.field.centre = {12, 0};
  expectFresh();
  arrows.pop_back();
  expectFresh();
}

TEST(WindForces, GustsChangeTheAmbientWindByAboutTheirStrength) {
  WindSetup setup = meadow(150);
  setup.ambient.speed = 5;
  setup.ambient.gustStrength = 0.3f;
  CpuWindSolver solver(setup, 1);
  run(solver, 300);
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  double mean = 0, variance = 0;
  for (const glm::vec2 v : cells) mean += double(v.x) / double(cells.size());
  for (const glm::vec2 v : cells)
    variance += double(glm::dot(v - glm::vec2(5, 0), v - glm::vec2(5, 0))) / double(cells.size());
  EXPECT_NEAR(mean, 5, 0.3);
  EXPECT_GE(std::sqrt(variance), 0.4 * 0.3 * 5);
  EXPECT_LE(std::sqrt(variance), 1.5 * 0.3 * 5);
}

TEST(WindForces, AnotherSeedGivesOtherGusts) {
  WindSetup setup = meadow(64);
  setup.ambient.speed = 5;
  setup.ambient.gustStrength = 0.3f;
  CpuWindSolver first(setup, 1);
  setup.solver.seed = 8;
  CpuWindSolver second(setup, 1);
  run(first, 60);
  run(second, 60);
  std::vector<glm::vec2> a, b;
  first.readVelocity(a);
  second.readVelocity(b);
  EXPECT_NE(a, b);
}

TEST(WindForces, GustTableIsFreeOfDivergenceAndOfUnitSize) {
  const std::vector<glm::vec2> table = makeGustTable(7);
  const int n = WIND_GUST_TABLE;
  const auto at = [&](int i, int k) { return table[static_cast<std::size_t>(((k + n) % n) * n + (i + n) % n)]; };
  double square = 0, divergence = 0, change = 0;
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) {
      square += double(glm::dot(at(i, k), at(i, k)));
      const float alongX = at(i + 1, k).x - at(i - 1, k).x, alongZ = at(i, k + 1).y - at(i, k - 1).y;
      divergence += std::pow(double(alongX + alongZ), 2);
      change += std::pow(double(alongX), 2);
    }
  }
  EXPECT_NEAR(square / (n * n), 1, 1e-4);
  EXPECT_LE(divergence, 1e-8 * change);
}

TEST(WindForces, ConfinementKeepsWhirlsAliveAndNoSettingBlowsUp) {
  WindSetup setup = bareSetup({96, 96}, 0.5f, Border::Wall, 1.0f / 60);
  const auto whirl = [](double x, double z) {
    const double dx = x - 24, dz = z - 24, g = std::exp(-(dx * dx + dz * dz) / 8);
    return glm::dvec2(-3 * dz * g, 3 * dx * g);
  };
  const auto energyLeft = [&](float confinement) {
    setup.solver.confinement = confinement;
    CpuWindSolver solver(setup, 1);
    setFaces(solver, whirl);
    const double before = faceEnergy(solver.fields());
    run(solver, 1200);
    return faceEnergy(solver.fields()) / before;
  };
  EXPECT_GT(energyLeft(0.2f), 1.2 * energyLeft(0));
  EXPECT_LE(energyLeft(0.2f), 1.2);
  EXPECT_LE(energyLeft(2), 1.2);
}

TEST(WindForces, DissipationRelaxesToTheAmbientWind) {
  WindSetup setup = bareSetup({32, 32}, 1, Border::Periodic, 0.05f);
  setup.solver.dissipation = 2;
  setup.ambient.speed = 3;
  CpuWindSolver solver(setup, 1);
  const std::vector<glm::vec2> still(32 * 32, glm::vec2(0));
  ASSERT_TRUE(solver.setVelocity(still));
  run(solver, 10);
  EXPECT_NEAR(cellAt(solver, {16, 16}).x, 3 * (1 - std::pow(1 / 1.1, 10)), 1e-4);
}

}  // namespace
}  // namespace windloom::testing
