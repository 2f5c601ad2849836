// Solids in a stream: nothing passes through them, and what comes in goes out.
#include "tests/proof/solids.hpp"
#include "tests/proof/cell_fields.hpp"
#include "tests/proof/proof_fixture.hpp"

namespace windloom::testing {
namespace {

/// A disc, a turned box, and a plate one cell thick.
std::vector<Obstacle> solidsIn(glm::vec2 size, float cellSizeM) {
  return {circle(size * glm::vec2(-0.17f, 0), 0.12f * size.y),
          box(size * glm::vec2(0.17f, 0.08f), size * glm::vec2(0.05f, 0.35f), 20),
          box(size * glm::vec2(0.3f, -0.25f) + 0.01f, {cellSizeM, 0.2f * size.y}, 0)};
}

class WindSolids : public WindProof {};
WINDLOOM_PROVE(WindSolids);

TEST_P(WindSolids, AreTightAndAsMuchAirLeavesAsComes) {
  const glm::ivec2 n = full() ? glm::ivec2(240, 160) : glm::ivec2(120, 80);
  WindSetup setup;
  setup.field.resolution = n;
  setup.field.size = {60, 40};
  setup.field.zMin = setup.field.zMax = Border::Wall;
  setup.ambient.speed = 8;
  setup.obstacles = solidsIn(setup.field.size, 60.0f / static_cast<float>(n.x));
  const auto solver = make(setup);
  run(*solver, full() ? 120 : 60);
  const CellField cells = readCells(*solver);
  const WindGrid grid = makeWindGrid(setup.field, setup.obstacles);
  // Each face of a solid is one of two that a solid cell's velocity is the mean of.
  std::size_t solid = 0;
  std::vector<double> through(static_cast<std::size_t>(n.x));
  for (int k = 0; k < n.y; ++k) {
    for (int i = 0; i < n.x; ++i) {
      const glm::vec2 v = cells[static_cast<std::size_t>(k * n.x + i)];
      through[static_cast<std::size_t>(i)] += double(v.x);
      if (!grid.solidAt(i, k)) continue;
      ++solid;
      ASSERT_EQ(v, glm::vec2(0)) << i << ", " << k;
    }
  }
  EXPECT_GT(solid, static_cast<std::size_t>(n.x * n.y / 50));
  // Between walls every column of faces carries the same air; a column of cells is the mean of two.
  EXPECT_GT(through.front(), 4.0 * n.y);
  double worst = 0;
  for (const double column : through) worst = std::max(worst, std::abs(column / through.front() - 1));
  note("massError", worst);
  for (const double column : through) EXPECT_NEAR(column, through.front(), 1e-4 * through.front());
}

TEST_P(WindSolids, SlowTheAirBeforeThemAndSpeedItUpBesideThem) {
  WindSetup setup;
  setup.field.resolution = {120, 80};
  setup.field.size = {60, 40};
  setup.ambient.speed = 8;
  setup.obstacles = {circle({-10, 0}, 5)};
  const auto solver = make(setup);
  run(*solver, 60);
  const CellField cells = readCells(*solver);
  const auto at = [&](glm::vec2 world) {
    const glm::ivec2 cell = cellOf(solver->grid(), world);
    return cells[static_cast<std::size_t>(cell.y * 120 + cell.x)];
  };
  EXPECT_LE(at({-16, 0.2f}).x, 3.0f);
  EXPECT_GE(at({-10, 6}).x, 9.0f);
  EXPECT_GE(at({-10, -6}).x, 9.0f);
}

TEST(WindSolidFaces, OfTheCpuBackendAreExactlyStillAndTheBordersBalance) {
  WindSetup setup;  // the wind comes in askew through all four borders
  setup.field.resolution = {240, 160};
  setup.field.size = {60, 40};
  setup.ambient.speed = 8;
  setup.ambient.direction = 10;
  setup.obstacles = solidsIn(setup.field.size, 0.25f);
  CpuWindSolver solver(setup, 1);
  run(solver, 120);
  const CpuFields& f = solver.fields();
  const WindGrid& grid = f.grid;
  int blocked = 0;
  double out = 0, through = 0;
  for (int k = 0; k < 160; ++k) {
    for (int i = 0; i <= 240; ++i) {
      if (!grid.blockedX(i, k)) continue;
      ++blocked;
      ASSERT_EQ(f.velocity.u.at(i, k), 0.0f);
    }
    out += double(f.velocity.u.at(240, k)) - double(f.velocity.u.at(0, k));
    through += std::abs(double(f.velocity.u.at(240, k)));
  }
  for (int i = 0; i < 240; ++i) {
    for (int k = 0; k <= 160; ++k) {
      if (!grid.blockedZ(i, k)) continue;
      ++blocked;
      ASSERT_EQ(f.velocity.w.at(i, k), 0.0f);
    }
    out += double(f.velocity.w.at(i, 160)) - double(f.velocity.w.at(i, 0));
  }
  EXPECT_GT(blocked, 1000);
  EXPECT_LE(std::abs(out), 1e-4 * through);
}

}  // namespace
}  // namespace windloom::testing
