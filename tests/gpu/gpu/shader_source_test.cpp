#include "engine/gpu/shader_source.hpp"

#include <gtest/gtest.h>

namespace windloom::gpu {
namespace {

/// Line 3 of the text is line 12 of b.glsl.
ShaderSource source() {
  return {"", {"shaders/a.comp", "shaders/b.glsl"}, {{0, 1}, {0, 2}, {1, 12}, {0, 4}}};
}

TEST(ShaderLog, ReadsTheFormsOfMesaNvidiaAndOthers) {
  const auto mesa = problemsOfLog("0:3(5): error: `x' undeclared\n", source());
  ASSERT_EQ(mesa.size(), 1u);
  EXPECT_EQ(mesa[0].text(), "shaders/b.glsl: line 12: error: `x' undeclared");
  const auto nvidia = problemsOfLog("0(3) : error C1503: undefined variable \"x\"\n", source());
  ASSERT_EQ(nvidia.size(), 1u);
  EXPECT_EQ(nvidia[0].text(), "shaders/b.glsl: line 12: error C1503: undefined variable \"x\"");
  const auto other = problemsOfLog("ERROR: 0:1: 'x' : undeclared identifier\nERROR: 0:4: again\n", source());
  ASSERT_EQ(other.size(), 2u);
  EXPECT_EQ(other[0].text(), "shaders/a.comp: line 1: 'x' : undeclared identifier");
  EXPECT_EQ(other[1].pointer, "line 4");
}

TEST(ShaderLog, KeepsLinesItDoesNotKnow) {
  const auto problems = problemsOfLog("internal trouble\nmore of it\n", source());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message, "internal trouble more of it");
  EXPECT_EQ(problemsOfLog("", source()).size(), 1u);
  EXPECT_EQ(problemsOfLog("0:99(1): error: beyond the text\n", source()).front().file, "shaders/a.comp");
}

}  // namespace
}  // namespace windloom::gpu
