// The solver against flows that are known exactly.
#include <gtest/gtest.h>

#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

/// Steady vortices with the given number of half waves across a square of `size`: curls between walls at 1.
std::function<glm::dvec2(double, double)> taylorGreen(double size, double halfWaves, double peak) {
  return [=](double x, double z) {
    const double k = kPi * halfWaves / size;
    return glm::dvec2(peak * std::sin(k * x) * std::cos(k * z), -peak * std::cos(k * x) * std::sin(k * z));
  };
}

TEST(WindPhysics, KeepsASteadyInviscidVortexBetweenSlipWalls) {
  constexpr int kCells = 256, kSteps = 200;
  CpuWindSolver solver(bareSetup({kCells, kCells}, 1, Border::Wall, 0.1f), 0);
  const auto exact = taylorGreen(kCells, 1, 10);  // 10 m/s x 0.1 s: one cell a step
  setFaces(solver, exact);
  const double before = faceEnergy(solver.fields());
  run(solver, kSteps);
  const double kept = faceEnergy(solver.fields()) / before;
  const double error = faceError(solver.fields(), exact);
  RecordProperty("kept", std::to_string(kept));
  RecordProperty("error", std::to_string(error));
  EXPECT_GE(kept, 0.98);
  EXPECT_LE(kept, 1.0);
  EXPECT_LE(error, 0.05);
  printf("kept %g error %g\n", kept, error);
}

}  // namespace
}  // namespace windloom::testing
