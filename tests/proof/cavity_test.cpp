// The lid-driven cavity against the literature.
#include "tests/proof/ghia.hpp"
#include "tests/proof/proof_fixture.hpp"

namespace windloom::testing {
namespace {

class WindCavity : public WindProof {
 protected:
  static void advance(WindSolver& solver, const WindSetup& setup, double seconds) {
    run(solver, static_cast<int>(seconds / double(setup.field.timeStep)));
  }

  static void expectGhia(const CellField& field, int cells, double reynolds) {
    double worst = 0;
    int compared = 0;
    for (const GhiaPoint& p : ghiaTable()) {
      if (p.reynolds != reynolds) continue;
      const double found = onCentreLine(field, cells, p.profile, p.coordinate);
      EXPECT_NEAR(found, p.value, 0.025) << p.profile << "(" << p.coordinate << ") at Re " << reynolds;
      worst = std::max(worst, std::abs(found - p.value));
      ++compared;
    }
    EXPECT_GE(compared, 30);
    note("worst", worst);
  }
};
WINDLOOM_PROVE(WindCavity);

TEST_P(WindCavity, MatchesGhiaAtReynolds100) {
  const int cells = full() ? 64 : 48;
  const WindSetup setup = cavitySetup(cells, 100);
  const auto solver = make(setup);
  advance(*solver, setup, full() ? 15 : 12);
  expectGhia(readCells(*solver), cells, 100);
}

TEST_P(WindCavity, MatchesGhiaAtReynolds400) {
  constexpr int kCells = 96;
  const WindSetup setup = cavitySetup(kCells, 400);
  const auto solver = make(setup);
  if (full()) {
    advance(*solver, setup, 30);
  } else {  // 3,600 steps are too many for software OpenGL: it takes over what the CPU found, and has to hold it
    CpuWindSolver cpu(setup, 1);
    advance(cpu, setup, 30);
    ASSERT_TRUE(solver->setVelocity(readCells(cpu)).ok());
    advance(*solver, setup, 2);
  }
  expectGhia(readCells(*solver), kCells, 400);
}

}  // namespace
}  // namespace windloom::testing
