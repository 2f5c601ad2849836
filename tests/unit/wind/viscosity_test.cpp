// Implicit viscosity and no-slip walls.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/wind/cpu_viscosity.hpp"
#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

/// Relative error of a decaying Taylor-Green vortex after 0.5 s at this many cells a side.
double decayError(int cells) {
  constexpr double kViscosity = 0.01, kSeconds = 0.5;
  const int steps = 16 * (cells / 16) * (cells / 16);  // the time step falls as the square of the cell size
  WindSetup setup = bareSetup({cells, cells}, 1.0f / static_cast<float>(cells), Border::Periodic,
                              static_cast<float>(kSeconds / steps));
  setup.solver.viscosity = static_cast<float>(kViscosity);
  setup.solver.divergenceTolerance = 1e-5f;
  CpuWindSolver solver(setup, 1);
  setFaces(solver, taylorGreen(1, 2, 1));
  run(solver, steps);
  const double decay = std::exp(-2 * kViscosity * 4 * kPi * kPi * kSeconds);
  return faceError(solver.fields(), taylorGreen(1, 2, decay));
}

TEST(WindViscosity, TaylorGreenVortexDecaysAtTheExactRateWithSecondOrder) {
  const double coarse = decayError(16), middle = decayError(32), fine = decayError(64);
  RecordProperty("errors", std::to_string(coarse) + " " + std::to_string(middle) + " " + std::to_string(fine));
  EXPECT_LE(fine, 0.01);
  EXPECT_GE(std::log2(coarse / middle), 1.7) << coarse << " " << middle;
  EXPECT_GE(std::log2(middle / fine), 1.7) << middle << " " << fine;
}

TEST(WindViscosity, TakesMoreSweepsTheStifferItIsButNeverTooMany) {
  EXPECT_EQ(viscositySweeps(1.0), 2);
  EXPECT_LT(viscositySweeps(1.5), viscositySweeps(10));
  EXPECT_EQ(viscositySweeps(1e9), WIND_VISCOSITY_SWEEPS);
}

struct ProfilePoint {
  std::string profile;
  double reynolds, coordinate, value;
};

std::vector<ProfilePoint> ghiaTable() {
  std::ifstream file(std::string(WINDLOOM_TEST_DATA) + "/reference/ghia-1982.csv");
  std::vector<ProfilePoint> points;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("profile")) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    ProfilePoint p;
    fields >> p.profile >> p.reynolds >> p.coordinate >> p.value;
    points.push_back(p);
  }
  return points;
}

/// A unit square of walls whose upper one (zMax) moves along x at 1 m/s, after `seconds`.
std::unique_ptr<CpuWindSolver> cavity(int cells, double reynolds, double seconds) {
  const float h = 1.0f / static_cast<float>(cells);
  WindSetup setup = bareSetup({cells, cells}, h, Border::Wall, 0.8f * h);
  setup.solver.viscosity = static_cast<float>(1 / reynolds);
  setup.noSlip = WallSpeeds{0, 0, 0, 1};
  auto solver = std::make_unique<CpuWindSolver>(setup, 1);
  run(*solver, static_cast<int>(seconds / static_cast<double>(setup.field.timeStep)));
  return solver;
}

/// u on the vertical, v on the horizontal centre line at a place 0..1; the walls themselves are known.
double onCentreLine(const CpuFields& f, const std::string& profile, double at) {
  const int n = f.width();
  const bool u = profile == "u";
  const auto value = [&](int j) {  // j-th row (u) or column (v) of cells
    if (j < 0) return 0.0;
    if (j >= n) return u ? 1.0 : 0.0;
    return double(u ? f.velocity.u.at(n / 2, j) : f.velocity.w.at(j, n / 2));
  };
  const auto place = [&](int j) { return j < 0 ? 0.0 : j >= n ? 1.0 : (j + 0.5) / n; };
  const int low = std::clamp(static_cast<int>(std::floor(at * n - 0.5)), -1, n - 1);
  const double t = (at - place(low)) / (place(low + 1) - place(low));
  return std::lerp(value(low), value(low + 1), t);
}

void expectGhia(int cells, double reynolds, double seconds) {
  const auto solver = cavity(cells, reynolds, seconds);
  int compared = 0;
  for (const ProfilePoint& p : ghiaTable()) {
    if (p.reynolds != reynolds) continue;
    EXPECT_NEAR(onCentreLine(solver->fields(), p.profile, p.coordinate), p.value, 0.025)
        << p.profile << "(" << p.coordinate << ") at Re " << reynolds;
    ++compared;
  }
  EXPECT_GE(compared, 30);
}

TEST(WindCavity, MatchesGhiaAtReynolds100) {
  expectGhia(64, 100, 15);
}
TEST(WindCavity, MatchesGhiaAtReynolds400) {
  expectGhia(96, 400, 30);
}

}  // namespace
}  // namespace windloom::testing
