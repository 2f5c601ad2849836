#include "engine/gpu/context.hpp"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/gpu/context_info.hpp"
#include "tests/gpu/gpu_test.hpp"

namespace windloom::gpu {
namespace {

class GpuContext : public windloom::testing::GpuTest {};

TEST_F(GpuContext, IsOpenGl45CoreAndSaysWhatItFound) {
  EXPECT_GE(epoxy_gl_version(), 45);
  EXPECT_FALSE(context().info().renderer.empty());
  EXPECT_FALSE(context().info().platform.empty());
  EXPECT_EQ(context().info().software, isSoftwareRenderer(context().info().renderer));
}

TEST(SoftwareRenderer, KnowsLlvmpipeSoftpipeAndSwiftShader) {
  EXPECT_TRUE(isSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
  EXPECT_TRUE(isSoftwareRenderer("softpipe"));
  EXPECT_TRUE(isSoftwareRenderer("ANGLE (Google, SwiftShader Device)"));
  EXPECT_FALSE(isSoftwareRenderer("NVIDIA H200/PCIe/SSE2"));
}

TEST(OffscreenContext, RefusesAMissingDeviceSayingWhatIsNeeded) {
  ::setenv("WINDLOOM_EGL_DEVICE", "977", 1);
  const auto made = createOffscreenContext();
  ::unsetenv("WINDLOOM_EGL_DEVICE");
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().kind, ErrorKind::Machine);
  EXPECT_NE(made.error().text().find("OpenGL 4.5"), std::string::npos);
  EXPECT_NE(made.error().text().find("977"), std::string::npos);
}

TEST(OffscreenContext, CountsOpenGlErrors) {
  const auto made = createOffscreenContext(DebugMode::Strict);
  ASSERT_TRUE(made.ok()) << made.error().text();
  glNamedBufferSubData(12345, 0, 4, nullptr);
  EXPECT_EQ((*made)->debugErrorCount(), 1);
  EXPECT_FALSE((*made)->lastDebugError().empty());
}

TEST(OffscreenContext, TwoTakeTurnsInOneThread) {
  const auto first = createOffscreenContext(), second = createOffscreenContext();
  ASSERT_TRUE(first.ok() && second.ok());
  (*first)->makeCurrent();
  GLuint name = 0;
  glCreateBuffers(1, &name);
  (*second)->makeCurrent();
  EXPECT_EQ(glIsBuffer(name), GL_FALSE);
  (*first)->makeCurrent();
  EXPECT_EQ(glIsBuffer(name), GL_TRUE);
}

}  // namespace
}  // namespace windloom::gpu
