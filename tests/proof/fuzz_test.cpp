// Any legal project keeps its wind finite and below its limit.
#include "tests/proof/cell_fields.hpp"
#include "tests/proof/proof_fixture.hpp"
#include "tests/proof/random_setup.hpp"

namespace windloom::testing {
namespace {

class WindFuzz : public WindProof {
 protected:
  /// Runs the random project with this seed, and looks at every cell after every step.
  static void expectSurvival(int seed, int steps) {
    RandomSetup random(seed);
    const WindSetup setup = random.setup();
    const auto solver = make(setup);
    std::vector<ArrowForce> arrows;
    for (int n = random.whole(0, 12); n > 0; --n) arrows.push_back(random.force(setup.field));
    CellField cells;
    for (int n = 0; n < steps; ++n) {
      solver->step(arrows, n * double(setup.field.timeStep));
      solver->readVelocity(cells);
      for (std::size_t c = 0; c < cells.size(); ++c) {
        ASSERT_TRUE(glm::length(cells[c]) <= setup.solver.maxSpeed * 1.0001f)
            << "seed " << seed << ", step " << n << ", cell " << c;
      }
      ASSERT_TRUE(std::isfinite(solver->diagnostics().divergenceAfter)) << "seed " << seed << ", step " << n;
    }
    EXPECT_EQ(solver->diagnostics().nonFiniteCells, 0) << "seed " << seed;
  }
};
INSTANTIATE_TEST_SUITE_P(Cpu, WindFuzz, ::testing::Values(Form{Backend::Cpu, Extent::Short}));
INSTANTIATE_TEST_SUITE_P(CpuFull, WindFuzz, ::testing::Values(Form{Backend::Cpu, Extent::Full}));
INSTANTIATE_TEST_SUITE_P(Gpu, WindFuzz, ::testing::Values(Form{Backend::Gpu, Extent::Short}));
INSTANTIATE_TEST_SUITE_P(GpuFull, WindFuzz, ::testing::Values(Form{Backend::Gpu, Extent::Full}));

TEST_P(WindFuzz, RandomLegalProjectsStayFiniteAndWithinTheLimit) {
  if (full()) {
    for (int n = 1000; n < 2000; ++n) expectSurvival(n, 200);
  } else {
    const int projects = onGpu() ? 14 : 60;
    for (int n = 0; n < projects; ++n) expectSurvival(n, onGpu() ? 25 : 40);
  }
}

}  // namespace
}  // namespace windloom::testing
