#include "engine/wind/gpu_cycles.hpp"

#include <gtest/gtest.h>

namespace windloom {
namespace {

TEST(GpuCycles, RecordsTheLimitUntilItKnowsWhatAStepNeeds) {
  GpuCycles cycles;
  cycles.forget(1);
  EXPECT_EQ(cycles.plan(1, 8), 8);
  cycles.learn(1, 2, 0.1);
  EXPECT_EQ(cycles.plan(1 + GpuCycles::kDelay - 1, 8), 8);
  EXPECT_EQ(cycles.plan(1 + GpuCycles::kDelay, 8), 2);
}

TEST(GpuCycles, DependsOnlyOnStepsOldEnoughToBeKnownAnyway) {
  GpuCycles early, late;
  for (GpuCycles* cycles : {&early, &late}) {
    cycles->forget(1);
    cycles->learn(1, 2, 0.1);
  }
  early.learn(2, 5, 0.1);  // arrived sooner
  EXPECT_EQ(early.plan(1 + GpuCycles::kDelay, 8), late.plan(1 + GpuCycles::kDelay, 8));
}

TEST(GpuCycles, GoesUpWhereAStepDidNotConvergeAndDownAgainLater) {
  GpuCycles cycles;
  cycles.forget(1);
  cycles.learn(1, 3, 1.5);
  EXPECT_EQ(cycles.plan(5, 8), 5);
  for (long step = 2; step < 60; ++step) cycles.learn(step, 1, 0.1);
  EXPECT_EQ(cycles.plan(60, 8), 1);
  EXPECT_EQ(cycles.plan(60, 1), 1);
}

TEST(GpuCycles, HasOneToSpareWhereItWasClose) {
  GpuCycles cycles;
  cycles.forget(1);
  cycles.learn(1, 2, 0.9);
  EXPECT_EQ(cycles.plan(1 + GpuCycles::kDelay, 8), 3);
}

TEST(GpuCycles, ForgetsStepsBeforeARestart) {
  GpuCycles cycles;
  cycles.forget(1);
  cycles.learn(1, 2, 0.1);
  cycles.forget(10);
  cycles.learn(2, 2, 0.1);
  EXPECT_EQ(cycles.plan(20, 8), 8);
}

}  // namespace
}  // namespace windloom
