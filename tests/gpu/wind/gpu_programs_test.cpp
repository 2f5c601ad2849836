#include "engine/wind/gpu_programs.hpp"

#include "tests/gpu/gpu_test.hpp"

namespace windloom {
namespace {

class WindPrograms : public windloom::testing::GpuTest {};

TEST_F(WindPrograms, AllCompile) {
  const Status loaded = shaders().loadAll(windPrograms());
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
}

}  // namespace
}  // namespace windloom
