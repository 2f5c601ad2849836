#include "engine/session/frame_tap.hpp"

#include "engine/session/resample.hpp"
#include "tests/gpu/gpu_test.hpp"

namespace windloom {
namespace {

class FrameTapTest : public testing::GpuTest {
 protected:
  static Project project(bool periodic) {
    Project project;
    FieldSettings field;
    field.resolution = {50, 36};
    field.size = {50, 36};
    if (periodic) field.xMin = field.xMax = Border::Periodic;
    project.field = std::make_shared<FieldSettings>(field);
    AmbientWind ambient;
    ambient.speed = 3;
    ambient.gustStrength = 0.8f;
    project.ambient = std::make_shared<AmbientWind>(ambient);
    return project;
  }

  std::unique_ptr<Simulation> start(bool periodic, Backend backend = Backend::Gpu) {
    SimulationOptions options;
    options.backend = backend;
    options.context = &context();
    options.shaders = &shaders();
    auto made = Simulation::create(project(periodic), options);
    EXPECT_TRUE(made.ok());
    return std::move(*made);
  }
};

TEST_F(FrameTapTest, ProgramsCompile) {
  const Status loaded = shaders().loadAll(frameTapPrograms());
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
}

TEST_F(FrameTapTest, FiltersAsTheProcessorDoes) {
  for (const bool periodic : {false, true}) {
    for (const glm::ivec2 resolution : {glm::ivec2(50, 36), {25, 12}, {17, 7}, {1, 1}, {80, 60}, {64, 9}}) {
      const auto simulation = start(periodic);
      for (int n = 0; n < 10; ++n) simulation->step();
      auto tap = makeFrameTap(*simulation, resolution);
      ASSERT_TRUE(tap.ok());
      ASSERT_TRUE((*tap)->ask(5));
      const auto frame = (*tap)->take(FrameTap::Wait::Yes);
      ASSERT_TRUE(frame);
      EXPECT_EQ(frame->number, 5);
      std::vector<glm::vec2> expected;
      Resampler({50, 36}, resolution, {periodic, false}).apply(simulation->velocity(), expected);
      ASSERT_EQ(frame->cells.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_LT(glm::length(frame->cells[i] - expected[i]), 2e-5f) << resolution.x << ", cell " << i;
    }
  }
}

TEST_F(FrameTapTest, GivesEveryFrameInOrderHoweverManyAreOnTheirWay) {
  const auto simulation = start(false);
  auto tap = makeFrameTap(*simulation, {10, 9});
  ASSERT_TRUE(tap.ok());
  std::vector<int> numbers;
  std::vector<glm::vec2> first, expected;
  const auto note = [&](const FrameTap::Frame& frame) {
    numbers.push_back(frame.number);
    first.push_back(frame.cells[0]);
  };
  for (int n = 0; n < 20; ++n) {
    simulation->step();
    while (!(*tap)->ask(n)) note((*tap)->take(FrameTap::Wait::Yes).value());
    std::vector<glm::vec2> cells;
    Resampler({50, 36}, {10, 9}).apply(simulation->velocity(), cells);
    expected.push_back(cells[0]);
  }
  while (const auto frame = (*tap)->take(FrameTap::Wait::Yes)) note(*frame);
  ASSERT_EQ(numbers.size(), 20u);
  for (int n = 0; n < 20; ++n) {
    EXPECT_EQ(numbers[static_cast<std::size_t>(n)], n);
    EXPECT_LT(glm::length(first[static_cast<std::size_t>(n)] - expected[static_cast<std::size_t>(n)]), 2e-5f) << n;
  }
  EXPECT_FALSE((*tap)->take(FrameTap::Wait::Yes));
}

TEST_F(FrameTapTest, TakesTheCardExactly) {
  const auto simulation = start(false);
  Project card = project(true);
  SolverSettings solver;
  solver.source = WindSource::Card;
  card.solver = std::make_shared<SolverSettings>(solver);
  ASSERT_TRUE(simulation->setProject(card));
  auto tap = makeFrameTap(*simulation, {50, 36});
  ASSERT_TRUE((*tap)->ask(0));
  const auto frame = (*tap)->take(FrameTap::Wait::Yes);
  for (std::size_t i = 0; i < frame->cells.size(); ++i) ASSERT_EQ(frame->cells[i], simulation->velocity()[i]);
}

}  // namespace
}  // namespace windloom
