#pragma once
// A test with all that grass passes find bound in a frame.

#include <optional>
#include <string>

#include "tests/gpu/gpu_test.hpp"
#include "tests/gpu/grass/grass_scene.hpp"

namespace windloom::testing {

class GrassPassTest : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    m_scene.emplace(shaders());
  }
  void TearDown() override {
    m_scene.reset();
    GpuTest::TearDown();
  }

  /// A program of tests/data/shaders.
  gpu::Program& testProgram(const std::string& file) {
    const std::string path = std::string(WINDLOOM_TEST_DATA) + "/shaders/" + file;
    auto program = shaders().load({path, {path}});
    EXPECT_TRUE(program.ok()) << program.error().text();
    return **program;
  }

  std::optional<GrassScene> m_scene;
};

}  // namespace windloom::testing
