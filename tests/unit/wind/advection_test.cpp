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

}  // namespace
}  // namespace windloom::testing
