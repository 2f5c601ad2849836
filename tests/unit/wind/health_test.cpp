// Bad input and settings at their limits: refused or survived, never a field that isn't finite.
#include <gtest/gtest.h>

#include <limits>

#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(WindHealth, ResetsCellsThatAreNotFiniteAndReportsTheFirst) {
  WindSetup setup = bareSetup({64, 48}, 0.5f, Border::Open, 1.0f / 60);
  setup.ambient.speed = 3;
  CpuWindSolver solver(setup, 2);
  run(solver, 2);
  EXPECT_EQ(solver.diagnostics().nonFiniteCells, 0);
  EXPECT_EQ(solver.diagnostics().firstNonFinite, glm::ivec2(-1));
  solver.fields().velocity.u.at(30, 20) = kNan;
  solver.fields().velocity.w.at(50, 40) = std::numeric_limits<float>::infinity();
  run(solver, 2);
  const WindDiagnostics& d = solver.diagnostics();
  EXPECT_GT(d.nonFiniteCells, 0);
  EXPECT_NEAR(d.firstNonFinite.x, 30, 4);
  EXPECT_NEAR(d.firstNonFinite.y, 20, 4);
  const long counted = d.nonFiniteCells;
  run(solver, 20);
  EXPECT_EQ(solver.diagnostics().nonFiniteCells, counted) << "it does not spread";
  std::vector<glm::vec2> cells;
  solver.readVelocity(cells);
  for (const glm::vec2 v : cells) ASSERT_NEAR(v.x, 3, 1.5f);
}

TEST(WindHealth, RefusesAnInitialFieldWithNumbersThatAreNotFinite) {
  CpuWindSolver solver(bareSetup({16, 12}, 1, Border::Open, 0.01f), 1);
  std::vector<glm::vec2> cells(16 * 12, glm::vec2(1, 2));
  cells[5 * 16 + 7].y = kNan;
  const Status status = solver.setVelocity(cells);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::BadInput);
  EXPECT_NE(status.error().text().find("(7, 5)"), std::string::npos) << status.error().text();
}

TEST(WindHealth, RefusesAnInitialFieldOfTheWrongSize) {
  CpuWindSolver solver(bareSetup({16, 12}, 1, Border::Open, 0.01f), 1);
  const std::vector<glm::vec2> cells(16 * 13, glm::vec2(1, 2));
  const Status status = solver.setVelocity(cells);
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().text().find("16 x 12"), std::string::npos) << status.error().text();
}

TEST(WindHealth, GivesBackTheInitialFieldItWasGiven) {
  constexpr int kCells = 128;
  CpuWindSolver solver(bareSetup({kCells, kCells}, 1, Border::Periodic, 0.01f), 1);
  std::vector<glm::vec2> cells;
  for (int k = 0; k < kCells; ++k) {
    for (int i = 0; i < kCells; ++i) {
      const float a = 2 * float(kPi) / 32 * (float(i) + 0.5f), b = 2 * float(kPi) / 32 * (float(k) + 0.5f);
      cells.emplace_back(std::sin(a) * std::cos(b), -std::cos(a) * std::sin(b));
    }
  }
  ASSERT_TRUE(solver.setVelocity(cells));
  std::vector<glm::vec2> back;
  solver.readVelocity(back);
  double difference = 0, size = 0;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    difference += double(glm::dot(back[n] - cells[n], back[n] - cells[n]));
    size += double(glm::dot(cells[n], cells[n]));
  }
  EXPECT_LE(std::sqrt(difference / size), 2e-4) << "waves of 32 cells";
}

TEST(WindHealth, RefusesSetupsNoGridCanBeMadeOf) {
  const auto refused = [](auto change) {
    WindSetup setup = bareSetup({16, 16}, 1, Border::Open, 0.01f);
    change(setup.field);
    const auto solver = makeCpuWindSolver(setup, 1);
    return !solver && solver.error().kind == ErrorKind::BadInput;
  };
  EXPECT_FALSE(refused([](FieldSettings&) {}));
  EXPECT_TRUE(refused([](FieldSettings& f) { f.resolution.x = 0; }));
  EXPECT_TRUE(refused([](FieldSettings& f) { f.resolution.y = 1'000'000'000; }));
  EXPECT_TRUE(refused([](FieldSettings& f) { f.size.x = -1; }));
  EXPECT_TRUE(refused([](FieldSettings& f) { f.size.y = kNan; }));
  EXPECT_TRUE(refused([](FieldSettings& f) { f.timeStep = 0; }));
  EXPECT_TRUE(refused([](FieldSettings& f) { f.xMin = Border::Periodic; }));
}

TEST(WindHealth, NoCellIsEverFasterThanTheLimit) {
  WindSetup setup = bareSetup({64, 64}, 0.5f, Border::Open, 1.0f / 30);
  setup.solver.maxSpeed = 6;
  CpuWindSolver solver(setup, 1);
  ArrowForce a = arrow({4, 4}, {28, 28}, 90, 6);
  a.drive = ARROW_DRIVE_FORCE;
  std::vector<glm::vec2> cells;
  for (int n = 0; n < 60; ++n) {
    solver.step(std::span(&a, 1), n / 30.0);
    solver.readVelocity(cells);
    for (const glm::vec2 v : cells) ASSERT_LE(glm::length(v), 6.0001f);
    ASSERT_LE(solver.diagnostics().maxSpeed, 6.0001);
  }
  EXPECT_GE(solver.diagnostics().maxSpeed, 5.5);
}

}  // namespace
}  // namespace windloom::testing
