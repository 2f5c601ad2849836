#pragma once
// What GPU tests share: one offscreen context for the test program, and a fixture that fails a test on any
// OpenGL error or high-severity message.

#include <gtest/gtest.h>

#include <memory>

#include "engine/gpu/context.hpp"
#include "engine/gpu/shader_library.hpp"

namespace windloom::testing {

class GpuTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = gpu::createOffscreenContext(gpu::DebugMode::Strict);
    ASSERT_TRUE(made.ok()) << made.error().text();
    s_context = std::move(*made);
    auto library = gpu::ShaderLibrary::create();
    ASSERT_TRUE(library.ok()) << library.error().text();
    s_shaders = std::move(*library);
  }
  static void TearDownTestSuite() {
    s_shaders.reset();
    s_context.reset();
  }

  void SetUp() override {
    ASSERT_NE(s_context, nullptr);
    s_context->makeCurrent();
    m_errorsBefore = s_context->debugErrorCount();
  }
  void TearDown() override {
    if (s_context == nullptr) return;
    EXPECT_EQ(s_context->debugErrorCount(), m_errorsBefore) << s_context->lastDebugError();
  }

  static gpu::Context& context() { return *s_context; }
  static gpu::ShaderLibrary& shaders() { return *s_shaders; }

 private:
  static inline std::unique_ptr<gpu::Context> s_context;
  static inline std::unique_ptr<gpu::ShaderLibrary> s_shaders;
  long m_errorsBefore = 0;
};

}  // namespace windloom::testing
