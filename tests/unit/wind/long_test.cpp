// What takes minutes: the whole fuzz, and the cavity on a fine grid.
#include <gtest/gtest.h>

#include "tests/unit/wind/random_setup.hpp"

namespace windloom::testing {
namespace {

TEST(WindFuzz, AThousandRandomLegalProjectsStayFinite) {
  for (int n = 1000; n < 2000; ++n) expectSurvival(n, 200);
}

}  // namespace
}  // namespace windloom::testing
