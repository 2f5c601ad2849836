// What a projection leaves of the divergence: on any grid, between any borders, at any wavelength.
#include <array>

#include "tests/proof/cell_fields.hpp"
#include "tests/proof/proof_fixture.hpp"
#include "tests/proof/solids.hpp"

namespace windloom::testing {
namespace {

class WindDivergence : public WindProof {
 protected:
  void SetUp() override {
    WindProof::SetUp();
    s_worst = 0;
    s_cycles = 0;
  }

  static void expectToleranceKept(const WindSetup& setup, int steps) {
    const auto solver = make(setup);
    const std::vector<ArrowForce> arrows = arrowsAround(setup.field);
    CellField cells;
    for (int n = 0; n < steps; ++n) {
      solver->step(arrows, n / 60.0);
      solver->readVelocity(cells);  // the GPU's diagnostics are of this step then
      const WindDiagnostics& d = solver->diagnostics();
      ASSERT_EQ(d.step, n + 1);
      ASSERT_GT(d.divergenceBefore, 0);
      EXPECT_LE(d.divergenceAfter, 1e-3 * d.divergenceBefore)
          << "ratio " << d.divergenceAfter / d.divergenceBefore << ", step " << n << ", cycles " << d.cycles;
      s_worst = std::max(s_worst, d.divergenceAfter / d.divergenceBefore);
      s_cycles = std::max(s_cycles, d.cycles);
    }
    note("worstRatio", s_worst);
    note("mostCycles", s_cycles);
  }

 private:
  /// Four arrows of different directions.
  static std::vector<ArrowForce> arrowsAround(const FieldSettings& field) {
    const float r = 0.06f * std::min(field.size.x, field.size.y);
    const auto at = [&](float x, float z) { return field.centre + field.size * glm::vec2(x, z); };
    return {arrow(at(-0.3f, -0.2f), at(-0.1f, -0.25f), 9, r), arrow(at(0.2f, 0.3f), at(0.1f, 0.1f), 7, r),
            arrow(at(0.3f, -0.3f), at(0.1f, -0.2f), 8, r), arrow(at(-0.2f, 0.3f), at(-0.3f, 0.1f), 6, r)};
  }
  static inline double s_worst = 0;  // of the test so far
  static inline int s_cycles = 0;
};
WINDLOOM_PROVE(WindDivergence);

TEST_P(WindDivergence, FallsToAThousandthEveryStepAtTheDefaultResolution) {
  WindSetup setup;
  if (!full()) setup.field.resolution = {200, 200};
  expectToleranceKept(setup, full() ? 12 : 6);
}

TEST_P(WindDivergence, FallsToAThousandthAroundSolidsFromTheFirstStep) {
  WindSetup setup;
  if (!full()) setup.field.resolution = {200, 200};
  setup.ambient.speed = 6;
  setup.obstacles = {circle({-20, 0}, 6), circle({5, 14}, 3), box({10, -12}, {16, 3}, 30), box({28, 8}, {4, 20}, 0),
                     circle({30, 30}, 0.4f)};
  expectToleranceKept(setup, full() ? 12 : 6);
}

TEST_P(WindDivergence, FallsToAThousandthOnOddGridsBetweenEveryMixOfBorders) {
  constexpr Border O = Border::Open, L = Border::Wall, P = Border::Periodic;
  constexpr std::array<std::pair<Border, Border>, 5> kPairs = {{{O, O}, {O, L}, {L, O}, {L, L}, {P, P}}};
  const std::vector<glm::ivec2> grids = full() ? std::vector<glm::ivec2>{{200, 200}, {257, 257}, {33, 770}}
                                               : std::vector<glm::ivec2>{{65, 65}, {17, 194}};
  for (const glm::ivec2 cells : grids) {
    for (std::size_t mix = 0; mix < kPairs.size() * kPairs.size(); ++mix) {
      const auto [xMin, xMax] = kPairs[mix % kPairs.size()];
      const auto [zMin, zMax] = kPairs[mix / kPairs.size()];
      WindSetup setup = bareSetup(cells, 0.25f, O, 1.0f / 60);
      setup.solver = SolverSettings{};
      setup.field.xMin = xMin;
      setup.field.xMax = xMax;
      setup.field.zMin = zMin;
      setup.field.zMax = zMax;
      SCOPED_TRACE(std::to_string(cells.x) + " x " + std::to_string(cells.y) + ", mix " + std::to_string(mix));
      expectToleranceKept(setup, full() ? 10 : 3);
      setup.obstacles = {circle(setup.field.size * 0.65f, 0.1f * std::min(setup.field.size.x, setup.field.size.y))};
      SCOPED_TRACE("with a solid");
      expectToleranceKept(setup, full() ? 10 : 3);
    }
  }
}

TEST_P(WindDivergence, FallsToAThousandthOnTinyGridsAndLongCells) {
  for (const glm::ivec2 cells : {glm::ivec2(8, 8), {97, 8}, {400, 50}}) {  // the last: cells of 0.25 m x 2 m
    for (const Border border : {Border::Open, Border::Wall, Border::Periodic}) {
      WindSetup setup = bareSetup(cells, 0.25f, border, 1.0f / 60);
      setup.solver = SolverSettings{};
      if (cells.x == 400) setup.field.size = {100, 100};
      SCOPED_TRACE(std::to_string(cells.x) + " x " + std::to_string(cells.y) + ", border " +
                   std::to_string(static_cast<int>(border)));
      expectToleranceKept(setup, 10);
    }
  }
}

TEST(WindDivergenceOfFaces, IsWhatTheCpuBackendReports) {
  WindSetup setup = bareSetup({120, 90}, 0.25f, Border::Open, 1.0f / 60);
  setup.obstacles = {circle({20, 12}, 3)};
  CpuWindSolver solver(setup, 1);
  const ArrowForce arrows[] = {arrow({5, 5}, {14, 12}, 9, 3)};
  run(solver, 20, arrows);
  const CpuFields& f = solver.fields();
  double sum = 0, most = 0;
  for (int k = 0; k < f.height(); ++k) {
    for (int i = 0; i < f.width(); ++i) {
      const double along = double(f.velocity.u.at(i + 1, k)) - double(f.velocity.u.at(i, k)),
                   across = double(f.velocity.w.at(i, k + 1)) - double(f.velocity.w.at(i, k)),
                   divergence = (along + across) / 0.25;
      sum += divergence * divergence;
      most = std::max(most, std::abs(divergence));
    }
  }
  const WindDiagnostics& d = solver.diagnostics();
  const double rms = std::sqrt(sum / double(f.grid.airCells));
  EXPECT_NEAR(d.divergenceAfter, rms, 0.01 * rms);
  EXPECT_NEAR(d.maxDivergenceAfter, most, 0.01 * most);
}

/// One projection of a field on a square of 0.1 m cells; so short a step that advection does nothing.
class WindModes : public WindProof {
 protected:
  [[nodiscard]] static int side() { return full() ? 1000 : 250; }

  static CellField projected(const WindSetup& setup, const CellField& before) {
    const auto solver = make(setup);
    EXPECT_TRUE(solver->setVelocity(before).ok());
    run(*solver, 1);
    return readCells(*solver);
  }
  static WindSetup square(Border border) { return bareSetup({side(), side()}, 0.1f, border, 1e-4f); }
  /// Wavelengths in cells; the longest is twice the side: half a wave.
  [[nodiscard]] static std::vector<double> wavelengths() {
    if (full()) return {2000, 500, 125, 31.25};
    return {500, 125, 31.25};
  }
};
WINDLOOM_PROVE(WindModes);

TEST_P(WindModes, DivergentOnesGoToATenthOfAPercentAtAnyWavelength) {
  double worst = 0;
  for (const Border border : {Border::Wall, Border::Open, Border::Periodic}) {
    for (const double wavelength : wavelengths()) {
      if (border == Border::Periodic && wavelength > side()) continue;
      const WindSetup setup = square(border);
      const double k = 2 * kPi / (wavelength * 0.1);
      // A gradient, of a potential that the border allows: level at walls, 0 at open borders.
      const CellField mode = cellsOf(setup, [&](double x, double z) {
        if (border == Border::Open)
          return glm::dvec2(std::cos(k * x) * std::sin(k * z), std::sin(k * x) * std::cos(k * z));
        return glm::dvec2(std::sin(k * x) * std::cos(k * z), std::cos(k * x) * std::sin(k * z));
      });
      const double left = std::sqrt(energyOf(projected(setup, mode)) / energyOf(mode));
      worst = std::max(worst, left);
      EXPECT_LE(left, 1e-3) << "wavelength " << wavelength << ", border " << static_cast<int>(border);
    }
  }
  note("worst", worst);
}

TEST_P(WindModes, SolenoidalOnesPassUnchangedToATenthOfAPercent) {
  double worst = 0;
  for (const Border border : {Border::Wall, Border::Periodic}) {
    for (const double wavelength : wavelengths()) {
      if (border == Border::Periodic && wavelength > side()) continue;
      const WindSetup setup = square(border);
      const CellField mode = cellsOf(setup, taylorGreen(0.1 * wavelength / 2, 1, 1));
      const double difference = relativeDifference(projected(setup, mode), mode);
      worst = std::max(worst, difference);
      EXPECT_LE(difference, 1e-3) << "wavelength " << wavelength << ", border " << static_cast<int>(border);
    }
  }
  note("worst", worst);
}

}  // namespace
}  // namespace windloom::testing
