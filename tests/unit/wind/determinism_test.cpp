// The same bytes for any number of threads, any instruction set and any run.
#include <gtest/gtest.h>

#include <hwy/highway.h>
#include <cstring>

#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

WindSetup livelySetup() {
  WindSetup setup;
  setup.field.resolution = {203, 149};
  setup.field.zMin = Border::Wall;
  setup.ambient.speed = 4;
  setup.ambient.direction = 20;
  setup.ambient.gustStrength = 0.4f;
  setup.solver.viscosity = 0.01f;
  Obstacle o;
  o.centre = {8, -6};
  o.radius = 6;
  setup.obstacles = {o};
  return setup;
}

std::vector<ArrowForce> livelyArrows() {
  std::vector<ArrowForce> arrows = {arrow({-40, 0}, {-10, 5}, 11, 5), arrow({40, 10}, {15, 5}, 9, 4)};
  arrows[1].swirl = 5;
  return arrows;
}

std::vector<glm::vec2> fieldAfter(CpuWindSolver& solver, int steps) {
  run(solver, steps, livelyArrows());
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  return cells;
}

bool sameBytes(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec2)) == 0;
}

TEST(WindDeterminism, InstructionSetsDoNotChangeAByte) {
  CpuWindSolver best(livelySetup(), 1);
  const std::vector<glm::vec2> expected = fieldAfter(best, 15);
  const auto targets = hwy::SupportedAndGeneratedTargets();
  EXPECT_FALSE(targets.empty());
  for (const auto target : targets) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    CpuWindSolver solver(livelySetup(), 1);
    EXPECT_TRUE(sameBytes(expected, fieldAfter(solver, 15))) << hwy::TargetName(target);
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

TEST(WindDeterminism, ReadingTheFieldChangesNothing) {
  CpuWindSolver watched(livelySetup(), 2), alone(livelySetup(), 2);
  std::vector<glm::vec2> cells;
  const std::vector<ArrowForce> arrows = livelyArrows();
  for (int n = 0; n < 20; ++n) {
    watched.step(arrows, n / 60.0);
    watched.readVelocity(cells);
  }
  EXPECT_TRUE(sameBytes(cells, fieldAfter(alone, 20)));
}

}  // namespace
}  // namespace windloom::testing
