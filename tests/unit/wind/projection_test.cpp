// The pressure solve: what it removes, what it leaves, on any grid.
#include <gtest/gtest.h>

#include "engine/wind/solver_presets.hpp"
#include "tests/proof/solids.hpp"
#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

/// Four arrows of different directions inside a field of `size` m around the origin.
std::vector<ArrowForce> someArrows(glm::vec2 size) {
  const float r = 0.06f * std::min(size.x, size.y);
  return {arrow(size * glm::vec2(-0.3f, -0.2f), size * glm::vec2(-0.1f, -0.25f), 9, r),
          arrow(size * glm::vec2(0.2f, 0.3f), size * glm::vec2(0.1f, 0.1f), 7, r),
          arrow(size * glm::vec2(0.3f, -0.3f), size * glm::vec2(0.1f, -0.2f), 8, r),
          arrow(size * glm::vec2(-0.2f, 0.3f), size * glm::vec2(-0.3f, 0.1f), 6, r)};
}

TEST(WindProjection, SolvesAClosedRoomInsideASolidRing) {
  WindSetup setup;
  setup.field.resolution = {160, 160};
  setup.solver.maxCycles = 40;
  for (int n = 0; n < 48; ++n) {  // a ring of discs two cells wide
    const float angle = static_cast<float>(n) * 2 * static_cast<float>(kPi) / 48;
    setup.obstacles.push_back(circle(25.0f * glm::vec2(std::cos(angle), std::sin(angle)), 2.2f));
  }
  CpuWindSolver solver(setup, 1);
  const std::vector<ArrowForce> arrows = {arrow({-8, 0}, {8, 3}, 9, 4), arrow({-40, -40}, {-30, -40}, 9, 4)};
  for (int n = 0; n < 60; ++n) {
    solver.step(arrows, n / 60.0);
    ASSERT_LE(solver.diagnostics().divergenceAfter, 1e-3 * solver.diagnostics().divergenceBefore) << "step " << n;
  }
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  EXPECT_GE(cells[80 * 160 + 80].x, 3.0f) << "the arrow in the room turns its air";
  EXPECT_TRUE(std::isfinite(solver.fields().phi.at(80, 80)));
}

TEST(WindProjection, StopsAtTheCycleLimitAndSaysWhatItReached) {
  WindSetup setup;
  setup.field.resolution = {128, 128};
  setup.solver.divergenceTolerance = 1e-7f;
  setup.solver.maxCycles = 1;
  CpuWindSolver solver(setup, 1);
  run(solver, 3, someArrows(setup.field.size));
  const WindDiagnostics& d = solver.diagnostics();
  EXPECT_EQ(d.cycles, 1);
  EXPECT_GT(d.divergenceAfter, 1e-7 * d.divergenceBefore);
  EXPECT_LT(d.divergenceAfter, 0.2 * d.divergenceBefore);
  EXPECT_GE(d.maxDivergenceBefore, d.divergenceBefore);
  EXPECT_GE(d.maxDivergenceAfter, d.divergenceAfter);
}

TEST(WindProjection, JacobiDoesItsSweepsAndLeavesMoreDivergence) {
  WindSetup setup;
  setup.field.resolution = {128, 128};
  setup.solver.pressure = Pressure::Jacobi;
  setup.solver.jacobiSweeps = 20;
  CpuWindSolver jacobi(setup, 1);
  run(jacobi, 10, someArrows(setup.field.size));
  setup.solver.pressure = Pressure::Multigrid;
  CpuWindSolver multigrid(setup, 1);
  run(multigrid, 10, someArrows(setup.field.size));
  EXPECT_EQ(jacobi.diagnostics().cycles, 20);
  EXPECT_LT(jacobi.diagnostics().divergenceAfter, jacobi.diagnostics().divergenceBefore);
  EXPECT_GT(jacobi.diagnostics().divergenceAfter, 10 * multigrid.diagnostics().divergenceAfter);
}

TEST(WindPresets, CwdSimIsThePapersSchemeAndRuns) {
  const auto preset = findSolverPreset("cwd-sim");
  ASSERT_TRUE(preset.has_value());
  EXPECT_FALSE(findSolverPreset("no such").has_value());
  WindSetup setup;
  setup.field.resolution = {96, 96};
  setup.solver = *preset;
  CpuWindSolver solver(setup, 1);
  run(solver, 30, someArrows(setup.field.size));
  EXPECT_EQ(solver.diagnostics().cycles, 20);
  EXPECT_GT(solver.diagnostics().maxSpeed, 2);
}

TEST(WindSolids, StopTheAirWhenTheyAppearAndLetItGoWhenTheyLeave) {
  WindSetup setup;
  setup.field.resolution = {100, 100};
  setup.ambient.speed = 5;
  CpuWindSolver solver(setup, 1);
  run(solver, 5);
  WindSetup blocked = setup;
  blocked.obstacles = {circle({0, 0}, 10)};
  solver.configure(blocked);
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  EXPECT_EQ(cells[50 * 100 + 50], glm::vec2(0));
  EXPECT_NEAR(cells[5 * 100 + 50].x, 5, 0.01f) << "the rest keeps moving";
  run(solver, 5);
  solver.configure(setup);
  run(solver, 480);
  solver.readVelocity(cells);
  EXPECT_GE(cells[50 * 100 + 50].x, 4.0f);
}

TEST(WindSolids, MutedObstaclesLetTheAirPass) {
  WindSetup setup;
  setup.field.resolution = {64, 64};
  setup.ambient.speed = 5;
  setup.obstacles = {circle({0, 0}, 20)};
  setup.obstacles[0].muted = true;
  CpuWindSolver solver(setup, 1);
  run(solver, 3);
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  EXPECT_NEAR(cells[32 * 64 + 32].x, 5, 1e-3f);
}

}  // namespace
}  // namespace windloom::testing
