#include "engine/gpu/shader_library.hpp"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "engine/gpu/buffer.hpp"
#include "shaders/shared/arrow_force.h"
#include "tests/gpu/gpu_test.hpp"

namespace windloom::gpu {
namespace {
namespace fs = std::filesystem;

/// A folder of shaders that lives for one test, with the real shared/ headers in it.
class ShaderLibraryTest : public windloom::testing::GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    std::string pattern = (fs::temp_directory_path() / "windloom-shaders-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    m_folder = pattern;
    fs::create_directory_symlink(shaders().folder() / "shared", m_folder / "shared");
    fs::create_directory(m_folder / "test");
  }
  void TearDown() override {
    fs::remove_all(m_folder);
    GpuTest::TearDown();
  }
  void write(const std::string& name, const std::string& text) {
    // Steps of file time are coarse; every write gets a later one.
    std::ofstream(m_folder / name) << text;
    fs::last_write_time(m_folder / name, fs::file_time_type::clock::now() + std::chrono::seconds(++m_writes));
  }
  float runToFloat(const Program& program) {
    auto buffer = Buffer::create("result", 4, BufferUse::Static);
    buffer->bindStorage(0);
    program.dispatch(1);
    float value = 0;
    buffer->read(&value, sizeof value);
    return value;
  }
  fs::path m_folder;
  int m_writes = 0;
};

const char* const kMain =
    "#version 450 core\n"
    "layout(local_size_x = 1) in;\n"
    "layout(std430, binding = 0) buffer Result { float result; };\n"
    "#include \"include_me.glsl\"\n"
    "void main() { result = included() + float(EXTRA); }\n";

TEST_F(ShaderLibraryTest, NamesFileAndLineOfAnIncludedError) {
  write("test/main.comp", kMain);
  write("test/include_me.glsl", "// first line\nfloat included() {\n  return nowhere;\n}\n");
  ShaderLibrary library(m_folder);
  const auto program = library.load({"broken", {"test/main.comp"}, "EXTRA=1"});
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().kind, ErrorKind::Machine);
  EXPECT_EQ(program.error().problems.front().file, "shaders/test/include_me.glsl");
  EXPECT_EQ(program.error().problems.front().pointer, "line 3");
  EXPECT_NE(program.error().text().find("nowhere"), std::string::npos);
}

TEST_F(ShaderLibraryTest, NamesTheLineAfterAnInclude) {
  write("test/main.comp", kMain);
  write("test/include_me.glsl", "float included() { return 1.0; }\n");
  ShaderLibrary library(m_folder);
  const auto program = library.load({"EXTRA is not defined", {"test/main.comp"}});
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().problems.front().file, "shaders/test/main.comp");
  EXPECT_EQ(program.error().problems.front().pointer, "line 5");
}

TEST_F(ShaderLibraryTest, NamesAMissingIncludeAndWhoAsked) {
  write("test/main.comp", kMain);
  ShaderLibrary library(m_folder);
  const auto program = library.load({"missing", {"test/main.comp"}});
  ASSERT_FALSE(program.ok());
  EXPECT_EQ(program.error().problems.front().file, "shaders/test/include_me.glsl");
  EXPECT_NE(program.error().text().find("shaders/test/main.comp: line 4"), std::string::npos);
}

TEST_F(ShaderLibraryTest, RefusesAFileWithoutVersion) {
  write("test/main.comp", "void main() {}\n");
  ShaderLibrary library(m_folder);
  const auto program = library.load({"no version", {"test/main.comp"}});
  ASSERT_FALSE(program.ok());
  EXPECT_NE(program.error().text().find("#version 450 core"), std::string::npos);
}

TEST_F(ShaderLibraryTest, VariantsDifferByDefinesAndAreCached) {
  write("test/main.comp", kMain);
  write("test/include_me.glsl", "float included() { return 10.0; }\n");
  ShaderLibrary library(m_folder);
  const ProgramSpec spec{"variant", {"test/main.comp"}, "EXTRA=1"};
  const auto one = library.load(spec), again = library.load(spec);
  const auto two = library.load({"variant", {"test/main.comp"}}, "EXTRA=2");
  ASSERT_TRUE(one.ok() && two.ok()) << one.error().text();
  EXPECT_EQ(*one, *again);
  EXPECT_EQ(runToFloat(**one), 11.0f);
  EXPECT_EQ(runToFloat(**two), 12.0f);
}

TEST_F(ShaderLibraryTest, ReloadSwapsOnSuccessAndKeepsTheOldOnError) {
  write("test/main.comp", kMain);
  write("test/include_me.glsl", "float included() { return 10.0; }\n");
  ShaderLibrary library(m_folder);
  const auto program = library.load({"reloaded", {"test/main.comp"}, "EXTRA=0"});
  ASSERT_TRUE(program.ok()) << program.error().text();
  EXPECT_EQ(library.reloadChanged().replaced, 0);

  write("test/include_me.glsl", "float included() { return broken; }\n");
  const ShaderLibrary::Reload failed = library.reloadChanged();
  EXPECT_EQ(failed.replaced, 0);
  ASSERT_FALSE(failed.problems.empty());
  EXPECT_EQ(failed.problems.front().file, "shaders/test/include_me.glsl");
  EXPECT_EQ(runToFloat(**program), 10.0f);
  EXPECT_TRUE(library.reloadChanged().problems.empty()) << "an error is reported once per change";

  write("test/include_me.glsl", "float included() { return 20.0; }\n");
  EXPECT_EQ(library.reloadChanged().replaced, 1);
  EXPECT_EQ(runToFloat(**program), 20.0f);
}

TEST_F(ShaderLibraryTest, ArrowForceHasTheLayoutOfTheShader) {
  write("test/layout.comp",
        "#version 450 core\n"
        "#include \"shaders/shared/arrow_force.h\"\n"
        "layout(local_size_x = 1) in;\n"
        "layout(std430, binding = 0) buffer Fields { float fields[]; };\n"
        "layout(std430, binding = 1) readonly buffer Arrows { ArrowForce arrows[]; };\n"
        "void main() {\n"
        "  ArrowForce a = arrows[1];\n"
        "  float all[12] = float[](a.from.x, a.from.y, a.to.x, a.to.y, a.direction.x, a.direction.y, a.radius,\n"
        "                          a.strength, a.response, a.swirl, float(a.drive), a.factor);\n"
        "  for (int i = 0; i < 12; ++i) fields[i] = all[i];\n"
        "}\n");
  ShaderLibrary library(m_folder);
  const auto program = library.load({"layout", {"test/layout.comp"}});
  ASSERT_TRUE(program.ok()) << program.error().text();
  const shared::ArrowForce second{{1, 2}, {3, 4}, {5, 6}, 7, 8, 9, 10, ARROW_DRIVE_FORCE, 12};
  const std::vector<shared::ArrowForce> arrows = {{}, second};
  auto fields = Buffer::create("fields", 12 * sizeof(float), BufferUse::Static);
  auto buffer = Buffer::create<shared::ArrowForce>("arrows", arrows);
  ASSERT_TRUE(fields.ok() && buffer.ok());
  fields->bindStorage(0);
  buffer->bindStorage(1);
  (*program)->dispatch(1);
  std::vector<float> values(12);
  fields->read(values.data(), values.size() * sizeof(float));
  EXPECT_EQ(values, (std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 1, 12}));
}

}  // namespace
}  // namespace windloom::gpu
