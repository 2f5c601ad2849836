// The two backends on every sample project.
#include <algorithm>
#include <filesystem>

#include "engine/io/project_json.hpp"
#include "engine/session/simulation.hpp"
#include "tests/proof/cell_fields.hpp"
#include "tests/proof/proof_fixture.hpp"

namespace windloom::testing {
namespace {

class WindSamples : public WindProof {
 protected:
  static std::unique_ptr<Simulation> simulate(const Project& project, Backend backend,
                                              std::optional<glm::ivec2> resolution) {
    SimulationOptions options;
    options.backend = backend;
    options.resolution = resolution;
    options.context = &context();
    options.shaders = &shaders();
    auto made = Simulation::create(project, options);
    EXPECT_TRUE(made.ok()) << made.error().text();
    return made ? std::move(*made) : nullptr;
  }
};
INSTANTIATE_TEST_SUITE_P(Gpu, WindSamples, ::testing::Values(Form{Backend::Gpu, Extent::Short}));
INSTANTIATE_TEST_SUITE_P(GpuFull, WindSamples, ::testing::Values(Form{Backend::Gpu, Extent::Full}));

TEST_P(WindSamples, BlowTheSameOnBothBackends) {
  int samples = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(WINDLOOM_PROJECTS)) {
    if (!entry.path().string().ends_with(".wind.json")) continue;
    SCOPED_TRACE(entry.path().filename().string());
    const auto loaded = loadProject(entry.path());
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    const glm::ivec2 whole = loaded->project.field->resolution;
    const std::optional<glm::ivec2> resolution =
        full() ? std::nullopt : std::optional(whole * 96 / std::max(whole.x, whole.y));
    const auto gpu = simulate(loaded->project, Backend::Gpu, resolution),
               cpu = simulate(loaded->project, Backend::Cpu, resolution);
    ASSERT_TRUE(gpu && cpu);
    ASSERT_EQ(gpu->solver().backend(), Backend::Gpu);
    ASSERT_EQ(cpu->solver().backend(), Backend::Cpu);
    // On a grid as coarse as the short form's the canyon is a matter of chance by then, to rounding; and so it is
    // whether an arrow blows in a cell whose centre lies exactly on its rim: with 96 cells none does.
    for (int n = 0; n < (full() ? 100 : 50); ++n) {
      gpu->step();
      cpu->step();
    }
    const double difference = relativeDifference(gpu->velocity(), cpu->velocity());
    note(entry.path().stem().stem().string(), difference);
    EXPECT_LE(difference, 1e-3);
    EXPECT_GT(cpu->solver().diagnostics().maxSpeed, 1.0) << "there is wind to compare";
    ++samples;
  }
  EXPECT_GE(samples, 3);
}

}  // namespace
}  // namespace windloom::testing
