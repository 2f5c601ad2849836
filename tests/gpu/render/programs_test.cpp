#include "engine/grass/grass_programs.hpp"
#include "engine/render/render_programs.hpp"
#include "engine/session/wind_sampler.hpp"
#include "tests/gpu/gpu_test.hpp"

namespace windloom {
namespace {

class RenderPrograms : public testing::GpuTest {};

TEST_F(RenderPrograms, AllOfGrassCompile) {
  const Status loaded = shaders().loadAll(grassPrograms());
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
}

TEST_F(RenderPrograms, AllOfRenderCompile) {
  const Status loaded = shaders().loadAll(renderPrograms());
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
}

TEST_F(RenderPrograms, AllOfSessionCompile) {
  const Status loaded = shaders().loadAll(sessionPrograms());
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
}

}  // namespace
}  // namespace windloom
