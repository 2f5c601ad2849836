#include "engine/model/calibration_card.hpp"

#include <gtest/gtest.h>

#include "engine/model/templates.hpp"
#include "engine/session/simulation.hpp"

namespace windloom {
namespace {

std::unique_ptr<Simulation> start(const Project& project) {
  SimulationOptions options;
  options.backend = Backend::Cpu;
  options.threads = 1;
  auto simulation = Simulation::create(project, options);
  EXPECT_TRUE(simulation.ok());
  return std::move(*simulation);
}

Project card() {
  return findTemplate("calibration")->make();
}

/// Largest difference between the simulation's air and the card at `seconds`, m/s.
float offCard(Simulation& simulation, double seconds) {
  const glm::ivec2 resolution = simulation.solver().grid().resolution;
  float worst = 0;
  for (int k = 0; k < resolution.y; ++k) {
    for (int i = 0; i < resolution.x; ++i) {
      const glm::vec2 cell = simulation.velocity()[static_cast<std::size_t>(k * resolution.x + i)];
      worst = std::max(worst, glm::length(cell - cardWind((glm::vec2(i, k) + 0.5f) / glm::vec2(resolution), seconds)));
    }
  }
  return worst;
}

}  // namespace

TEST(CalibrationCard, TurnsOnceInItsPeriodAndTellsThePlace) {
  const glm::vec2 middle = cardWind({0.5f, 0.875f}, 0);  // where the code along x is 0
  EXPECT_NEAR(middle.x, kCardSpeed, 1e-5f);
  EXPECT_NEAR(cardWind({0.4375f, 0.5f}, 1).y, kCardSpeed, 1e-5f) << "after a quarter along +z";
  EXPECT_NEAR(glm::length(cardWind({0.3f, 0.2f}, 1.3) - cardWind({0.3f, 0.2f}, 1.3 + 3 * double(kCardPeriod))), 0,
              1e-5);
  EXPECT_NEAR(glm::length(cardWind({0, 0.2f}, 1) - cardWind({1, 0.2f}, 1)), 0, 1e-5) << "periodic";
  float fastest = 0;
  for (int n = 0; n < 10'000; ++n) {
    const auto part = static_cast<float>(n % 100) / 100.0f;
    fastest = std::max(fastest, glm::length(cardWind({part, static_cast<float>(n) / 10'000.0f}, n * 0.0037)));
  }
  EXPECT_LE(fastest, kCardFastest);
  EXPECT_GT(fastest, 0.95f * kCardFastest);
}

TEST(CalibrationCard, IsTheAirOfItsProjectAtEveryTime) {
  const auto simulation = start(card());
  EXPECT_EQ(offCard(*simulation, 0), 0);
  simulation->runTo(1.5);
  EXPECT_EQ(offCard(*simulation, simulation->time()), 0);
  EXPECT_NEAR(simulation->time(), 1.5, 1e-6);
  simulation->goTowards(6);
  simulation->runTo(0.2);
  EXPECT_EQ(offCard(*simulation, simulation->time()), 0) << "also back in time";
  ASSERT_TRUE(simulation->setResolution(glm::ivec2(48, 40)));
  EXPECT_EQ(simulation->solver().grid().resolution, glm::ivec2(48, 40));
  EXPECT_EQ(offCard(*simulation, simulation->time()), 0);
  simulation->restart();
  EXPECT_EQ(offCard(*simulation, 0), 0);
}

TEST(CalibrationCard, ReachesWhatIsDrawn) {
  const auto simulation = start(card());
  simulation->runTo(0.5);
  std::vector<glm::vec2> drawn;
  simulation->solver().readVelocity(drawn);
  // The solver keeps speeds between the cells, so its centres are means of neighbours.
  for (std::size_t i = 0; i < drawn.size(); ++i)
    ASSERT_LT(glm::length(drawn[i] - simulation->velocity()[i]), 0.02f) << i;
}

TEST(CalibrationCard, ComesAndGoesWithItsSetting) {
  Project project = card();
  SolverSettings solver = *project.solver;
  solver.source = WindSource::Solved;
  project.solver = std::make_shared<SolverSettings>(solver);
  const auto simulation = start(project);
  simulation->runTo(0.5);
  EXPECT_GT(offCard(*simulation, simulation->time()), 1.0f);
  ASSERT_TRUE(simulation->setProject(card()));
  EXPECT_EQ(offCard(*simulation, simulation->time()), 0);
  ASSERT_TRUE(simulation->setProject(project));
  simulation->step();
  EXPECT_GT(offCard(*simulation, simulation->time()), 1.0f) << "no air of the card stays";
}

TEST(CalibrationCard, TakesNoInitialField) {
  const auto simulation = start(card());
  const std::vector<glm::vec2> still(128 * 96);
  const Status set = simulation->setInitialField({128, 96}, still);
  ASSERT_FALSE(set.ok());
  EXPECT_NE(set.error().text().find("calibration card"), std::string::npos);
}

}  // namespace windloom
