// How many sweeps the implicit viscosity takes.
#include <gtest/gtest.h>

#include "engine/wind/cpu_viscosity.hpp"

namespace windloom::testing {
namespace {

TEST(WindViscosity, TakesMoreSweepsTheStifferItIsButNeverTooMany) {
  EXPECT_EQ(viscositySweeps(1.0), 2);
  EXPECT_LT(viscositySweeps(1.5), viscositySweeps(10));
  EXPECT_EQ(viscositySweeps(1e9), WIND_VISCOSITY_SWEEPS);
}

}  // namespace
}  // namespace windloom::testing
