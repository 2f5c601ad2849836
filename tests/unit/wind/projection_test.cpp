// The pressure solve: what it removes, what it leaves, on any grid.
#include <gtest/gtest.h>

#include "engine/wind/solver_presets.hpp"
#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

Obstacle circle(glm::vec2 centre, float radius) {
  Obstacle o;
  o.centre = centre;
  o.radius = radius;
  return o;
}

Obstacle box(glm::vec2 centre, glm::vec2 size, float rotation) {
  Obstacle o;
  o.shape = ObstacleShape::Box;
  o.centre = centre;
  o.size = size;
  o.rotation = rotation;
  return o;
}

/// Four arrows of different directions inside a field of `size` m around the origin.
std::vector<ArrowForce> someArrows(glm::vec2 size) {
  const float r = 0.06f * std::min(size.x, size.y);
  return {arrow(size * glm::vec2(-0.3f, -0.2f), size * glm::vec2(-0.1f, -0.25f), 9, r),
          arrow(size * glm::vec2(0.2f, 0.3f), size * glm::vec2(0.1f, 0.1f), 7, r),
          arrow(size * glm::vec2(0.3f, -0.3f), size * glm::vec2(0.1f, -0.2f), 8, r),
          arrow(size * glm::vec2(-0.2f, 0.3f), size * glm::vec2(-0.3f, 0.1f), 6, r)};
}

void expectToleranceKept(const WindSetup& setup, int steps) {
  CpuWindSolver solver(setup, 1);
  const std::vector<ArrowForce> arrows = someArrows(setup.field.size);
  for (int n = 0; n < steps; ++n) {
    solver.step(arrows, n / 60.0);
    const WindDiagnostics& d = solver.diagnostics();
    ASSERT_LE(d.divergenceAfter, 1e-3 * d.divergenceBefore) << "step " << n << ", cycles " << d.cycles;
    ASSERT_GT(d.divergenceBefore, 0);
  }
}

TEST(WindProjection, KeepsTheToleranceEveryStepAtTheDefaultResolution) {
  expectToleranceKept({}, 12);
}

TEST(WindProjection, KeepsTheToleranceAroundSolidsFromTheFirstStep) {
  WindSetup setup;
  setup.ambient.speed = 6;
  setup.obstacles = {circle({-20, 0}, 6), circle({5, 14}, 3), box({10, -12}, {16, 3}, 30), box({28, 8}, {4, 20}, 0),
                     circle({30, 30}, 0.4f)};
  expectToleranceKept(setup, 8);
}

struct GridCase {
  glm::ivec2 cells;
  Border xMin, xMax, zMin, zMax;
};

class WindProjectionGrid : public ::testing::TestWithParam<GridCase> {};

TEST_P(WindProjectionGrid, KeepsTheTolerance) {
  const GridCase& c = GetParam();
  WindSetup setup;
  setup.field.resolution = c.cells;
  setup.field.size = glm::vec2(c.cells) * 0.25f;
  setup.field.xMin = c.xMin;
  setup.field.xMax = c.xMax;
  setup.field.zMin = c.zMin;
  setup.field.zMax = c.zMax;
  expectToleranceKept(setup, 10);
  setup.obstacles = {circle(setup.field.size * 0.15f, 0.1f * std::min(setup.field.size.x, setup.field.size.y))};
  expectToleranceKept(setup, 10);
}

constexpr Border O = Border::Open, L = Border::Wall, P = Border::Periodic;
INSTANTIATE_TEST_SUITE_P(AnyResolutionAndBorders, WindProjectionGrid,
                         ::testing::Values(GridCase{{257, 257}, O, O, O, O}, GridCase{{200, 200}, L, L, L, L},
                                           GridCase{{33, 770}, O, L, L, O}, GridCase{{33, 770}, L, L, P, P},
                                           GridCase{{8, 8}, L, L, L, L}, GridCase{{8, 8}, P, P, P, P},
                                           GridCase{{97, 8}, P, P, O, L}, GridCase{{129, 65}, P, P, P, P},
                                           GridCase{{65, 250}, O, O, L, L}));

TEST(WindProjection, SolvesLongCellsAsWellAsSquareOnes) {
  WindSetup setup;
  setup.field.resolution = {400, 50};  // cells of 0.25 m x 2 m
  expectToleranceKept(setup, 10);
}

/// How much of a divergent plane of waves stays, in velocity, after one projection.
double partLeft(Border border, double wavelengthCells) {
  constexpr int kCells = 1000;
  WindSetup setup = bareSetup({kCells, kCells}, 0.1f, border, 1e-4f);
  CpuWindSolver solver(setup, 1);
  const double k = 2 * kPi / (wavelengthCells * 0.1);
  setFaces(solver, [&](double x, double z) {  // a gradient, of a potential that each border allows
    if (border == Border::Open) return glm::dvec2(std::cos(k * x) * std::sin(k * z), std::sin(k * x) * std::cos(k * z));
    return glm::dvec2(std::sin(k * x) * std::cos(k * z), std::cos(k * x) * std::sin(k * z));
  });
  const double before = faceEnergy(solver.fields());
  run(solver, 1);
  return std::sqrt(faceEnergy(solver.fields()) / before);
}

TEST(WindProjection, RemovesDivergentWavesOfAnyLength) {
  for (const double wavelength : {2000.0, 500.0, 125.0, 31.25}) {
    EXPECT_LE(partLeft(Border::Wall, wavelength), 1e-3) << "walls, wavelength " << wavelength;
    EXPECT_LE(partLeft(Border::Open, wavelength), 1e-3) << "open, wavelength " << wavelength;
    if (wavelength <= 1000) {
      EXPECT_LE(partLeft(Border::Periodic, wavelength), 1e-3) << "periodic, wavelength " << wavelength;
    }
  }
}

TEST(WindProjection, LeavesSolenoidalWavesAlone) {
  constexpr int kCells = 1000;
  for (const double wavelength : {2000.0, 500.0, 125.0, 31.25}) {
    CpuWindSolver solver(bareSetup({kCells, kCells}, 0.1f, Border::Wall, 1e-4f), 0);
    const auto waves = taylorGreen(0.1 * wavelength / 2, 1, 1);
    setFaces(solver, waves);
    run(solver, 1);
    EXPECT_LE(faceError(solver.fields(), waves), 1e-3) << "wavelength " << wavelength;
  }
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

TEST(WindSolids, LetNothingThroughAndConserveMass) {
  WindSetup setup;
  setup.field.resolution = {240, 160};
  setup.field.size = {60, 40};
  setup.ambient.speed = 8;
  setup.ambient.direction = 10;
  setup.obstacles = {circle({-10, 0}, 5), box({10, 3}, {3, 14}, 20)};
  CpuWindSolver solver(setup, 1);
  run(solver, 120);
  const CpuFields& f = solver.fields();
  ASSERT_FALSE(f.blockedX.runs.empty());
  for (const CpuRun& r : f.blockedX.runs) {
    for (int i = r.begin; i < r.end; ++i) ASSERT_EQ(f.velocity.u.at(i, r.row), 0.0f);
  }
  for (const CpuRun& r : f.blockedZ.runs) {
    for (int i = r.begin; i < r.end; ++i) ASSERT_EQ(f.velocity.w.at(i, r.row), 0.0f);
  }
  double out = 0, through = 0;
  for (int k = 0; k < 160; ++k) {
    out += double(f.velocity.u.at(240, k)) - double(f.velocity.u.at(0, k));
    through += std::abs(double(f.velocity.u.at(240, k)));
  }
  for (int i = 0; i < 240; ++i) out += double(f.velocity.w.at(i, 160)) - double(f.velocity.w.at(i, 0));
  EXPECT_LE(std::abs(out), 1e-4 * through);
  EXPECT_LE(double(f.velocity.u.at(79, 80)), 6.0) << "the air slows before the disc";
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
