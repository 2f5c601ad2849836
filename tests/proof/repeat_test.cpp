// The same wind again: mirrored, after a restart, on any number of threads.
#include "tests/proof/cell_fields.hpp"
#include "tests/proof/proof_fixture.hpp"
#include "tests/proof/solids.hpp"

namespace windloom::testing {
namespace {

/// Everything on: gusts, solids, viscosity, mixed borders.
WindSetup livelySetup(glm::ivec2 cells) {
  WindSetup setup;
  setup.field.resolution = cells;
  setup.field.zMin = Border::Wall;
  setup.ambient.speed = 4;
  setup.ambient.direction = 20;
  setup.ambient.gustStrength = 0.4f;
  setup.solver.viscosity = 0.01f;
  setup.obstacles = {circle({8, -6}, 6)};
  return setup;
}

CellField livelyField(WindSolver& solver, int steps) {
  std::vector<ArrowForce> arrows = {arrow({-40, 0}, {-10, 5}, 11, 5), arrow({40, 10}, {15, 5}, 9, 4)};
  arrows[1].swirl = 5;
  run(solver, steps / 2);  // the arrows come later: the solve gets harder on the way
  for (int n = steps / 2; n < steps; ++n) solver.step(arrows, n / 60.0);
  return readCells(solver);
}

class WindRepeat : public WindProof {};
WINDLOOM_PROVE(WindRepeat);

TEST_P(WindRepeat, OppositeArrowsKeepTheFieldMirrorSymmetric) {
  WindSetup setup;
  setup.field.resolution = {128, 128};
  const auto solver = make(setup);
  const ArrowForce arrows[] = {arrow({-30, 3}, {-10, 3}, 9, 4), arrow({30, 3}, {10, 3}, 9, 4)};
  run(*solver, 90, arrows);
  const CellField cells = readCells(*solver);
  CellField mirrored(cells.size());
  for (std::size_t k = 0; k < 128; ++k) {
    for (std::size_t i = 0; i < 128; ++i) mirrored[k * 128 + i] = cells[k * 128 + 127 - i] * glm::vec2(-1, 1);
  }
  const double difference = relativeDifference(mirrored, cells);
  note("difference", difference);
  EXPECT_LE(difference, 1e-4);
  EXPECT_GE(std::abs(cells[79 * 128 + 64].y), 1.0f) << "the two winds deflect each other";
}

TEST_P(WindRepeat, ARestartGivesTheSameBytes) {
  const auto solver = make(livelySetup(full() ? glm::ivec2(203, 149) : glm::ivec2(81, 60)));
  const CellField first = livelyField(*solver, 40);
  solver->reset();
  EXPECT_EQ(solver->diagnostics().step, 0);
  EXPECT_TRUE(sameBytes(first, livelyField(*solver, 40)));
  EXPECT_FALSE(sameBytes(first, livelyField(*solver, 1)));
}

TEST_P(WindRepeat, ASecondSolverGivesTheSameBytes) {
  const WindSetup setup = livelySetup(full() ? glm::ivec2(203, 149) : glm::ivec2(81, 60));
  const CellField first = livelyField(*make(setup), 30);
  EXPECT_TRUE(sameBytes(first, livelyField(*make(setup), 30)));
}

TEST_P(WindRepeat, ASavedStateGoesOnWithTheSameBytes) {
  const auto solver = make(livelySetup(full() ? glm::ivec2(203, 149) : glm::ivec2(81, 60)));
  std::vector<ArrowForce> arrows = {arrow({-40, 0}, {-10, 5}, 11, 5), arrow({40, 10}, {15, 5}, 9, 4)};
  const auto forward = [&](int from, int to) {  // arrows come at step 20, and one goes at step 40
    for (int n = from; n < to; ++n) {
      const std::span<const ArrowForce> blowing(arrows.data(), n < 20 ? 0u : n < 40 ? 2u : 1u);
      solver->step(blowing, n / 60.0);
    }
  };
  // Near the start, right before and after the arrows come, while the reports of steps are on their way.
  for (const int kept : {1, 20, 22}) {
    solver->reset();
    forward(0, kept);
    auto state = solver->save();
    ASSERT_TRUE(state.ok()) << state.error().text();
    EXPECT_GT((*state)->bytes(), std::size_t{81 * 60 * 4 * 4});
    const CellField then = readCells(*solver);
    forward(kept, 50);
    const CellField once = readCells(*solver);
    const long steps = solver->diagnostics().step;
    arrows[0].strength = 30;  // something else altogether
    forward(10, 45);
    arrows[0].strength = 11;
    for (int again = 0; again < 2; ++again) {
      solver->restore(**state);
      EXPECT_TRUE(sameBytes(then, readCells(*solver))) << kept;
      forward(kept, 50);
      EXPECT_TRUE(sameBytes(once, readCells(*solver))) << kept;
      EXPECT_EQ(solver->diagnostics().step, steps) << kept;
    }
  }
}

TEST(WindThreads, DoNotChangeAByteOfTheCpuBackend) {
  const WindSetup setup = livelySetup({203, 149});
  CpuWindSolver one(setup, 1), two(setup, 2), seven(setup, 7);
  const CellField expected = livelyField(one, 40);
  EXPECT_TRUE(sameBytes(expected, livelyField(two, 40)));
  EXPECT_TRUE(sameBytes(expected, livelyField(seven, 40)));
  EXPECT_EQ(one.diagnostics().divergenceAfter, seven.diagnostics().divergenceAfter);
}

}  // namespace
}  // namespace windloom::testing
