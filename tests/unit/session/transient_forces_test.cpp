// Forces of the wind brush: beside the project's, gone when they are taken away.
#include <gtest/gtest.h>

#include "engine/session/simulation.hpp"

namespace windloom {
namespace {

Project stillProject() {
  Project project;
  FieldSettings field;
  field.size = {32, 32};
  field.resolution = {64, 64};
  project.field = std::make_shared<FieldSettings>(field);
  return project;
}

ArrowForce stroke() {
  ArrowForce force{};
  force.from = {-4, 0};
  force.to = {4, 0};
  force.direction = {1, 0};
  force.radius = 3;
  force.strength = 8;
  force.response = 0.05f;
  force.factor = 1;
  force.drive = ARROW_DRIVE_SPEED;
  return force;
}

std::unique_ptr<Simulation> simulate(const Project& project) {
  SimulationOptions options;
  options.backend = Backend::Cpu;
  options.threads = 1;
  auto made = Simulation::create(project, options);
  EXPECT_TRUE(made.ok());
  return std::move(*made);
}

TEST(TransientForces, PushTheAirUntilTheyAreTakenAway) {
  const auto simulation = simulate(stillProject());
  const ArrowForce force = stroke();
  simulation->setTransientForces({&force, 1});
  for (int i = 0; i < 30; ++i) simulation->step();
  const float pushed = simulation->windAt({0, 0}).x;
  EXPECT_GT(pushed, 3.0f);
  simulation->setTransientForces({});
  for (int i = 0; i < 240; ++i) simulation->step();
  EXPECT_LT(simulation->windAt({0, 0}).x, 0.5f * pushed);
}

TEST(TransientForces, LeaveNothingBehindInARunFromTheStart) {
  const auto brushed = simulate(stillProject()), untouched = simulate(stillProject());
  const ArrowForce force = stroke();
  brushed->setTransientForces({&force, 1});
  for (int i = 0; i < 10; ++i) brushed->step();
  brushed->setTransientForces({});
  brushed->restart();
  for (int i = 0; i < 10; ++i) {
    brushed->step();
    untouched->step();
  }
  EXPECT_EQ(brushed->velocity(), untouched->velocity());
}

}  // namespace
}  // namespace windloom
