// What advection may not do; flows that are known exactly are in tests/proof.
#include <gtest/gtest.h>

#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {
namespace {

TEST(WindAdvection, NeverOvershootsWhatItCarries) {
  WindSetup setup = bareSetup({64, 64}, 1, Border::Periodic, 0.5f);
  CpuWindSolver solver(setup, 1);
  CpuFields& f = solver.fields();
  for (int k = 0; k < 64; ++k) {
    for (int i = 0; i <= 64; ++i) f.velocity.u.at(i, k) = 3;
    for (int i = 0; i < 64; ++i) f.velocity.w.at(i, k) = i >= 20 && i < 40 ? 5.0f : -2.0f;  // a front, carried along x
  }
  for (int i = 0; i < 64; ++i) f.velocity.w.at(i, 64) = f.velocity.w.at(i, 0);
  run(solver, 40);
  for (int k = 0; k < 64; ++k) {
    for (int i = 0; i < 64; ++i) {
      ASSERT_LE(f.velocity.w.at(i, k), 5.001f);
      ASSERT_GE(f.velocity.w.at(i, k), -2.001f);
    }
  }
}

TEST(WindAdvection, AirThatAnObstacleStopsAtTheInflowMovesAsOne) {
  WindSetup setup = bareSetup({120, 120}, 0.2f, Border::Wall, 1.0f / 60);
  setup.field.xMin = setup.field.xMax = Border::Open;
  setup.ambient.speed = 5;
  setup.ambient.gustStrength = 0.2f;
  Obstacle box;  // a pocket of 6 m between the wall and the inflow
  box.shape = ObstacleShape::Box;
  box.centre = {11, 21};
  box.size = {6, 6.2f};
  setup.obstacles = {box};
  CpuWindSolver solver(setup, 1);
  run(solver, 900);
  const CpuPlane& u = solver.fields().velocity.u;
  int turns = 0;
  for (int k = 1; k < 120; ++k) turns += (u.at(0, k) > 0) != (u.at(0, k - 1) > 0) ? 1 : 0;
  EXPECT_LE(turns, 3);
  EXPECT_NEAR(u.at(0, 20), 5, 1.5f) << "in front of no obstacle the ambient wind comes in";
}

}  // namespace
}  // namespace windloom::testing
