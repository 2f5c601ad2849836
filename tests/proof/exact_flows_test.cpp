// Flows that are known exactly: carried, decaying, steady, and passing through.
#include "tests/proof/cell_fields.hpp"
#include "tests/proof/proof_fixture.hpp"

namespace windloom::testing {
namespace {

class WindExactFlow : public WindProof {};
WINDLOOM_PROVE(WindExactFlow);

TEST_P(WindExactFlow, UniformPeriodicFlowStaysAsItIs) {
  const WindSetup setup = bareSetup({96, 57}, 0.3f, Border::Periodic, 1.0f / 60);
  const auto solver = make(setup);
  const glm::vec2 wind(11.3f, -7.9f);
  ASSERT_TRUE(solver->setVelocity(CellField(96 * 57, wind)).ok());
  run(*solver, 50);
  const double difference = greatestDifference(readCells(*solver), wind);
  note("difference", difference);
  EXPECT_LE(difference, 2e-5) << "20 units in the last place";
}

/// Relative error of a Taylor-Green vortex of wavelength 1 m that decays for half a second, at so many cells a side. It
/// is compared with itself at the start, which the grid holds exactly but for its size.
double decayError(WindSolver& solver, const WindSetup& setup, int steps) {
  EXPECT_TRUE(solver.setVelocity(cellsOf(setup, taylorGreen(1, 2, 1))).ok());
  const CellField start = readCells(solver);
  run(solver, steps);
  const double k = 2 * kPi, seconds = steps * double(setup.field.timeStep);
  return relativeDifference(readCells(solver),
                            scaled(start, std::exp(-2 * double(setup.solver.viscosity) * k * k * seconds)));
}

TEST_P(WindExactFlow, TaylorGreenVortexDecaysAtTheExactRateWithSecondOrder) {
  std::vector<double> errors;
  for (int cells = 32; cells <= (full() ? 128 : 64); cells *= 2) {
    const int steps = 16 * (cells / 16) * (cells / 16);  // the time step falls as the square of the cell size
    WindSetup setup =
        bareSetup({cells, cells}, 1.0f / static_cast<float>(cells), Border::Periodic, 0.5f / static_cast<float>(steps));
    setup.solver.viscosity = 0.01f;
    setup.solver.divergenceTolerance = 1e-5f;
    errors.push_back(decayError(*make(setup), setup, steps));
    if (errors.size() < 2) continue;
    const double before = errors[errors.size() - 2], after = errors.back();
    note("order" + std::to_string(cells), std::log2(before / after));
    EXPECT_GE(std::log2(before / after), 1.8) << before << " at half of " << cells << " cells, then " << after;
  }
  note("finestError", errors.back());
  EXPECT_LE(errors[1], 0.01) << "at 64 cells";
}

TEST_P(WindExactFlow, SteadyInviscidCellBetweenSlipWallsKeepsItsEnergyAndShape) {
  constexpr int kCells = 256;
  const int steps = full() ? 200 : 50;
  const double part = steps / 200.0;
  const WindSetup setup = bareSetup({kCells, kCells}, 1, Border::Wall, 0.1f);
  const auto solver = make(setup);
  const CellField exact = cellsOf(setup, taylorGreen(kCells, 1, 10));  // 10 m/s for 0.1 s: one cell a step
  ASSERT_TRUE(solver->setVelocity(exact).ok());
  run(*solver, steps);
  const CellField after = readCells(*solver);
  const double kept = energyOf(after) / energyOf(exact), error = relativeDifference(after, exact);
  note("energyKept", kept);
  note("error", error);
  EXPECT_GE(kept, 1 - 0.02 * part);
  EXPECT_LE(kept, 1.0);
  EXPECT_LE(error, 0.02 * part) << "0.05 is the bar, far above";
}

/// Kinetic energy left of a vortex of a few cells after it turned once.
double energyKept(WindSolver& solver, const WindSetup& setup) {
  constexpr double kRadius = 3, kTurn = 2 * kPi;  // cells; steps of 0.1 s at 10 rad/s
  const auto whirl = [&](double x, double z) {    // a Gaussian vortex, its field free of divergence
    const double dx = x - 32, dz = z - 32, g = std::exp(-(dx * dx + dz * dz) / (2 * kRadius * kRadius));
    return glm::dvec2(-dz * g, dx * g);
  };
  EXPECT_TRUE(solver.setVelocity(cellsOf(setup, whirl)).ok());
  const double before = energyOf(readCells(solver));
  run(solver, static_cast<int>(std::ceil(kTurn / double(setup.field.timeStep))));
  return energyOf(readCells(solver)) / before;
}

TEST_P(WindExactFlow, MacCormackKeepsMoreThanTwiceTheEnergyOfSemiLagrangianOverOneTurn) {
  WindSetup setup = bareSetup({64, 64}, 1, Border::Periodic, 0.1f);
  const double sharp = energyKept(*make(setup), setup);
  setup.solver.advection = Advection::SemiLagrangian;
  const double soft = energyKept(*make(setup), setup);
  note("keptMacCormack", sharp);
  note("keptSemiLagrangian", soft);
  EXPECT_LE(sharp, 1.0);
  EXPECT_GT(sharp, 2 * soft) << "kept " << sharp << " and " << soft;
}

TEST_P(WindExactFlow, AmbientWindPassesThroughAnOpenField) {
  for (const float direction : {0.0f, 37.0f}) {
    WindSetup setup;  // default solver: confinement, dissipation and all
    setup.field.resolution = full() ? glm::ivec2(200, 120) : glm::ivec2(100, 60);
    setup.ambient.speed = 8;
    setup.ambient.direction = direction;
    const auto solver = make(setup);
    run(*solver, full() ? 120 : 60);
    const float turn = glm::radians(direction);
    const double difference = greatestDifference(readCells(*solver), 8.0f * glm::vec2(std::cos(turn), std::sin(turn)));
    note("difference" + std::to_string(static_cast<int>(direction)), difference);
    EXPECT_LE(difference, 0.001) << "far less than 1% at " << direction << " degrees";
  }
}

TEST_P(WindExactFlow, AmbientWindReturnsAfterADisturbanceLeft) {
  WindSetup setup =
      bareSetup(full() ? glm::ivec2(160, 96) : glm::ivec2(80, 48), full() ? 0.5f : 1.0f, Border::Open, 1.0f / 30);
  setup.ambient.speed = 8;
  const auto solver = make(setup);
  const ArrowForce gust[] = {arrow({20, 20}, {24, 28}, 14, 4)};
  run(*solver, 30, gust, 1.0 / 30);
  EXPECT_GE(greatestDifference(readCells(*solver), {8, 0}), 2.0) << "the arrow should have disturbed it";
  run(*solver, full() ? 900 : 450, {}, 1.0 / 30);
  const double difference = greatestDifference(readCells(*solver), {8, 0});
  note("difference", difference);
  EXPECT_LE(difference, 0.08) << "1%";
}

}  // namespace
}  // namespace windloom::testing
