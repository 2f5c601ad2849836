#include "engine/session/simulation.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace windloom {
namespace {

Project smallProject() {
  Project project;
  FieldSettings field;
  field.resolution = {40, 32};
  project.field = std::make_shared<FieldSettings>(field);
  auto graph = std::make_shared<WindGraph>();
  graph->points.resize(2);
  graph->points[0].id = 1;
  graph->points[0].position = {-30, 0};
  graph->points[1].id = 2;
  graph->points[1].position = {20, 10};
  Arrow arrow;
  arrow.id = 3;
  arrow.from = 1;
  arrow.to = 2;
  graph->arrows = {arrow};
  Signal gusts;
  gusts.root = 1;
  gusts.kind = SignalKind::Gusts;
  graph->signals = {gusts};
  project.graph = graph;
  return project;
}

std::unique_ptr<Simulation> start(const Project& project, std::size_t bytes = 256u << 20) {
  SimulationOptions options;
  options.backend = Backend::Cpu;
  options.threads = 1;
  options.checkpoints = true;
  options.checkpointBytes = bytes;
  auto simulation = Simulation::create(project, options);
  EXPECT_TRUE(simulation.ok());
  return std::move(*simulation);
}

bool sameBytes(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

std::vector<glm::vec2> fieldAt(Simulation& simulation, double seconds) {
  simulation.goTowards(simulation.stepAt(seconds));
  simulation.runTo(seconds);
  EXPECT_EQ(simulation.steps(), simulation.stepAt(seconds));
  return simulation.velocity();
}

Project withSpeed(const Project& project, float speed) {
  Project changed = project;
  AmbientWind ambient = *project.ambient;
  ambient.speed = speed;
  changed.ambient = std::make_shared<AmbientWind>(ambient);
  return changed;
}

/// A state that is nothing but so many bytes.
struct Weight : WindState {
  explicit Weight(std::size_t weight) : size(weight) {}
  [[nodiscard]] std::size_t bytes() const override { return size; }
  std::size_t size;
};

}  // namespace

TEST(Seeking, BackAndForthGivesTheSameBytes) {
  const auto simulation = start(smallProject());
  simulation->runTo(3);
  const std::vector<glm::vec2> third = simulation->velocity();
  EXPECT_EQ(simulation->checkpoints().count(), 3u);
  simulation->goTowards(simulation->stepAt(1.4));
  EXPECT_EQ(simulation->steps(), 60) << "the checkpoint before it, not the start";
  const std::vector<glm::vec2> early = fieldAt(*simulation, 1.4);
  EXPECT_FALSE(sameBytes(early, third));
  simulation->runTo(3);
  EXPECT_TRUE(sameBytes(simulation->velocity(), third));
  EXPECT_TRUE(sameBytes(fieldAt(*start(smallProject()), 1.4), early)) << "as if it had never been later";
  EXPECT_TRUE(sameBytes(fieldAt(*simulation, 3), third)) << "forward over a checkpoint";
}

TEST(Seeking, AheadTakesTheLatestCheckpointBefore) {
  const auto simulation = start(smallProject());
  simulation->runTo(3.5);
  simulation->goTowards(0);
  EXPECT_EQ(simulation->steps(), 0);
  simulation->goTowards(simulation->stepAt(2.9));
  EXPECT_EQ(simulation->steps(), 120);
  simulation->goTowards(simulation->stepAt(2.95));
  EXPECT_EQ(simulation->steps(), 120) << "no step back for a target ahead";
}

TEST(Seeking, AfterAnEditBeginsAtTheStartWithTheNewProject) {
  const Project before = smallProject(), after = withSpeed(before, 7);
  const auto simulation = start(before);
  simulation->runTo(2.5);
  ASSERT_TRUE(simulation->setProject(after).ok());
  EXPECT_EQ(simulation->checkpoints().count(), 0u);
  EXPECT_NEAR(simulation->time(), 2.5, 1e-3) << "the air goes on";
  simulation->runTo(4.5);
  EXPECT_EQ(simulation->checkpoints().count(), 0u) << "this air comes from before the edit";
  simulation->goTowards(simulation->stepAt(2));
  EXPECT_EQ(simulation->steps(), 0);
  simulation->runTo(2);
  EXPECT_TRUE(sameBytes(simulation->velocity(), fieldAt(*start(after), 2)));
}

TEST(Seeking, AnEditOfTheGrassKeepsCheckpoints) {
  const auto simulation = start(smallProject());
  simulation->runTo(2.5);
  Project other = simulation->project();
  other.name = "Other";
  GrassSettings grass = *other.grass;
  grass.height = 2;
  other.grass = std::make_shared<GrassSettings>(grass);
  ASSERT_TRUE(simulation->setProject(other).ok());
  EXPECT_EQ(simulation->checkpoints().count(), 2u);
}

TEST(Seeking, AnotherResolutionDropsCheckpoints) {
  const auto simulation = start(smallProject());
  simulation->runTo(2);
  ASSERT_TRUE(simulation->setResolution(glm::ivec2(32, 24)).ok());
  EXPECT_EQ(simulation->checkpoints().count(), 0u);
  simulation->goTowards(simulation->stepAt(1));
  EXPECT_EQ(simulation->steps(), 0);
}

TEST(Seeking, AnotherTimeStepKeepsTheTime) {
  const auto simulation = start(smallProject());
  simulation->runTo(2);
  Project other = simulation->project();
  FieldSettings field = *other.field;
  field.timeStep *= 0.5f;
  other.field = std::make_shared<FieldSettings>(field);
  ASSERT_TRUE(simulation->setProject(other).ok());
  simulation->goTowards(simulation->stepAt(3));
  simulation->runTo(3);
  EXPECT_EQ(simulation->steps(), simulation->stepAt(3));
  EXPECT_NEAR(simulation->time(), 3, 0.01);
}

TEST(Checkpoints, ThinOutWithinTheirBudget) {
  Checkpoints kept({.bytes = 1000, .everySteps = 10});
  kept.pin(35);
  for (long step = 1; step <= 400; ++step)
    kept.offer(step, 0, [] { return Result<std::unique_ptr<WindState>>(std::make_unique<Weight>(100)); });
  EXPECT_LE(kept.bytes(), 1000u);
  EXPECT_GE(kept.count(), 5u);
  EXPECT_EQ(kept.everySteps(), 80);
  EXPECT_EQ(kept.newestUpTo(36)->first, 35) << "the pinned one stays";
  EXPECT_EQ(kept.newestUpTo(34), nullptr);
  EXPECT_EQ(kept.newestUpTo(300)->first, 240);
  kept.clear();
  EXPECT_EQ(kept.count(), 0u);
  EXPECT_EQ(kept.everySteps(), 10);
}

TEST(Checkpoints, KeepNoneWhereNotOneFits) {
  Checkpoints kept({.bytes = 50, .everySteps = 10});
  int saved = 0;
  for (long step = 1; step <= 100; ++step)
    kept.offer(step, 0, [&] { return ++saved, Result<std::unique_ptr<WindState>>(std::make_unique<Weight>(100)); });
  EXPECT_EQ(kept.count(), 0u);
  EXPECT_EQ(saved, 1) << "and don't try again with every step";
}

TEST(Checkpoints, GoOnWithoutWhereSavingFails) {
  Checkpoints kept({.bytes = 1000, .everySteps = 10});
  kept.offer(10, 0, []() -> Result<std::unique_ptr<WindState>> { return makeError(ErrorKind::Machine, "full"); });
  EXPECT_EQ(kept.count(), 0u);
  EXPECT_EQ(kept.newestUpTo(20), nullptr);
}

}  // namespace windloom
