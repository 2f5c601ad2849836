#pragma once
// A case of the proof runs on both backends, and on the GPU at two sizes: software OpenGL can't do the full one in
// time.

#include <cstdio>
#include <ostream>
#include <string>

#include "tests/gpu/gpu_test.hpp"
#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {

enum class Extent { Short, Full };  ///< a grid for software OpenGL, or what the case is stated for

struct Form {
  Backend backend = Backend::Cpu;
  Extent extent = Extent::Full;

  friend std::ostream& operator<<(std::ostream& out, const Form& form) {
    return out << (form.backend == Backend::Gpu ? "GPU" : "CPU") << (form.extent == Extent::Full ? "" : ", short form");
  }
};

/// Makes solvers of the backend under test. OpenGL is started by the first test that needs it, so that the proof of the
/// CPU backend needs none.
class WindProof : public GpuTest, public ::testing::WithParamInterface<Form> {
 public:
  static void SetUpTestSuite() {}
  static void TearDownTestSuite() {
    GpuTest::TearDownTestSuite();
    s_hasContext = false;
  }

 protected:
  void SetUp() override {
    if (!onGpu()) return;
    if (!s_hasContext) GpuTest::SetUpTestSuite();
    s_hasContext = true;
    GpuTest::SetUp();
  }
  void TearDown() override {
    if (onGpu()) GpuTest::TearDown();
  }

  [[nodiscard]] static bool onGpu() { return GetParam().backend == Backend::Gpu; }
  [[nodiscard]] static bool full() { return GetParam().extent == Extent::Full; }

  /// Keeps a measured number in the XML that --gtest_output=xml:FILE writes; docs/solver.md quotes them.
  static void note(const std::string& name, double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    RecordProperty(name, text);
  }

  /// Never null: where no solver can be made the test ends here.
  static std::unique_ptr<WindSolver> make(const WindSetup& setup) {
    auto made = onGpu() ? makeGpuWindSolver(setup, context(), shaders()) : makeCpuWindSolver(setup, 1);
    WL_REQUIRE(made.ok(), "the proof's setups are legal");
    return std::move(*made);
  }

 private:
  static inline bool s_hasContext = false;
};

}  // namespace windloom::testing

/// The forms of a suite whose full size the CPU does in seconds.
#define WINDLOOM_PROVE(Suite)                                                                 \
  INSTANTIATE_TEST_SUITE_P(Cpu, Suite, ::testing::Values(Form{Backend::Cpu, Extent::Full}));  \
  INSTANTIATE_TEST_SUITE_P(Gpu, Suite, ::testing::Values(Form{Backend::Gpu, Extent::Short})); \
  INSTANTIATE_TEST_SUITE_P(GpuFull, Suite, ::testing::Values(Form{Backend::Gpu, Extent::Full}))
