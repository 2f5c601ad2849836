// Advection against flows that are known exactly.
#include <gtest/gtest.h>

#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

float greatestDifference(std::span<const glm::vec2> cells, glm::vec2 expected) {
  float greatest = 0;
  for (const glm::vec2 v : cells)
    greatest = std::max({greatest, std::abs(v.x - expected.x), std::abs(v.y - expected.y)});
  return greatest;
}

TEST(WindAdvection, LeavesUniformPeriodicFlowUnchanged) {
  CpuWindSolver solver(bareSetup({96, 57}, 0.3f, Border::Periodic, 1.0f / 60), 1);
  const std::vector<glm::vec2> start(96 * 57, glm::vec2(11.3f, -7.9f));
  ASSERT_TRUE(solver.setVelocity(start));
  run(solver, 50);
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  EXPECT_LE(greatestDifference(cells, start[0]), 2e-5f);
  EXPECT_EQ(solver.diagnostics().cycles, 0) << "there is nothing to project";
}

TEST(WindAdvection, LetsAmbientWindPassThroughAnOpenField) {
  WindSetup setup;  // default solver: confinement, dissipation and all
  setup.field.resolution = {200, 120};
  setup.ambient.speed = 8;
  CpuWindSolver solver(setup, 1);
  run(solver, 120);
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  EXPECT_LE(greatestDifference(cells, {8, 0}), 0.001f);
}

TEST(WindAdvection, ReturnsToTheAmbientWindAfterADisturbanceLeft) {
  WindSetup setup = bareSetup({160, 96}, 0.5f, Border::Open, 1.0f / 30);
  setup.ambient.speed = 8;
  CpuWindSolver solver(setup, 1);
  const ArrowForce gust[] = {arrow({20, 20}, {24, 28}, 14, 4)};
  run(solver, 30, gust, 1.0 / 30);
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  EXPECT_GE(greatestDifference(cells, {8, 0}), 2.0f) << "the arrow should have disturbed it";
  run(solver, 900, {}, 1.0 / 30);
  solver.readVelocity(cells);
  EXPECT_LE(greatestDifference(cells, {8, 0}), 0.08f);
}

TEST(WindAdvection, KeepsASteadyInviscidVortexBetweenSlipWalls) {
  constexpr int kCells = 256, kSteps = 200;
  CpuWindSolver solver(bareSetup({kCells, kCells}, 1, Border::Wall, 0.1f), 1);
  const auto exact = taylorGreen(kCells, 1, 10);  // 10 m/s for 0.1 s: one cell a step
  setFaces(solver, exact);
  const double before = faceEnergy(solver.fields());
  run(solver, kSteps);
  const double kept = faceEnergy(solver.fields()) / before;
  EXPECT_GE(kept, 0.98);
  EXPECT_LE(kept, 1.0);
  EXPECT_LE(faceError(solver.fields(), exact), 0.02);
}

/// Kinetic energy that is left of a vortex of a few cells after it was carried once across a periodic field.
double energyKept(Advection advection) {
  constexpr int kCells = 64;
  WindSetup setup = bareSetup({kCells, kCells}, 1, Border::Periodic, 0.1f);
  setup.solver.advection = advection;
  CpuWindSolver solver(setup, 1);
  const auto whirl = [](double x, double z) {  // a Gaussian vortex, its field free of divergence
    const double dx = x - 32, dz = z - 32, g = std::exp(-(dx * dx + dz * dz) / 18);
    return glm::dvec2(-dz * g, dx * g);
  };
  setFaces(solver, whirl);
  const double before = faceEnergy(solver.fields());
  run(solver, 300);  // it turns once in 2 pi / 0.1 = 63 steps at its middle
  return faceEnergy(solver.fields()) / before;
}

TEST(WindAdvection, MacCormackKeepsMoreThanTwiceTheEnergyOfSemiLagrangian) {
  const double sharp = energyKept(Advection::MacCormack), soft = energyKept(Advection::SemiLagrangian);
  EXPECT_LE(sharp, 1.0);
  EXPECT_GT(sharp, 2 * soft) << "kept " << sharp << " and " << soft;
}

TEST(WindAdvection, NeverOvershootsWhatItCarries) {
  WindSetup setup = bareSetup({64, 64}, 1, Border::Periodic, 0.5f);
  CpuWindSolver solver(setup, 1);
  CpuFields& f = solver.fields();
  for (int k = 0; k < 64; ++k) {
    for (int i = 0; i <= 64; ++i) f.velocity.u.at(i, k) = 3;
    for (int i = 0; i < 64; ++i) f.velocity.w.at(i, k) = i >= 20 && i < 40 ? 5.0f : -2.0f;  // a front, carried along x
  }
  for (int i = 0; i < 64; ++i) f.velocity.w.at(i, 64) = f.velocity.w.at(i, 0);
  run(solver, 40);
  for (int k = 0; k < 64; ++k) {
    for (int i = 0; i < 64; ++i) {
      ASSERT_LE(f.velocity.w.at(i, k), 5.001f);
      ASSERT_GE(f.velocity.w.at(i, k), -2.001f);
    }
  }
}

TEST(WindAdvection, AirThatAnObstacleStopsAtTheInflowMovesAsOne) {
  WindSetup setup = bareSetup({120, 120}, 0.2f, Border::Wall, 1.0f / 60);
  setup.field.xMin = setup.field.xMax = Border::Open;
  setup.ambient.speed = 5;
  setup.ambient.gustStrength = 0.2f;
  Obstacle box;  // a pocket of 6 m between the wall and the inflow
  box.shape = ObstacleShape::Box;
  box.centre = {11, 21};
  box.size = {6, 6.2f};
  setup.obstacles = {box};
  CpuWindSolver solver(setup, 1);
  run(solver, 900);
  const CpuPlane& u = solver.fields().velocity.u;
  int turns = 0;
  for (int k = 1; k < 120; ++k) turns += (u.at(0, k) > 0) != (u.at(0, k - 1) > 0) ? 1 : 0;
  EXPECT_LE(turns, 3);
  EXPECT_NEAR(u.at(0, 20), 5, 1.5f) << "in front of no obstacle the ambient wind comes in";
}

}  // namespace
}  // namespace windloom::testing
