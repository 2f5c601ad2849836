#include "engine/session/live_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windloom {
namespace {

/// Steps of a machine that takes so long for a million cells; the longer side it ends on.
int settle(LiveGridControl& grid, double msPerMillionCells, int steps = 4000) {
  for (int i = 0; i < steps; ++i) {
    const glm::ivec2 cells = grid.resolution();
    grid.stepDone(msPerMillionCells * 1e-6 * static_cast<double>(cells.x) * static_cast<double>(cells.y));
  }
  return std::max(grid.resolution().x, grid.resolution().y);
}

TEST(LiveGrid, StartsCoarseAndKeepsTheFieldsShape) {
  FieldSettings field;
  field.resolution = {1000, 500};
  const LiveGridControl grid(field);
  EXPECT_EQ(grid.resolution(), glm::ivec2(256, 128));
}

TEST(LiveGrid, NeverGoesFinerThanTheProject) {
  FieldSettings field;
  field.resolution = {120, 200};
  LiveGridControl grid(field);
  EXPECT_EQ(grid.resolution(), field.resolution);
  settle(grid, 0.01);
  EXPECT_EQ(grid.resolution(), field.resolution);
}

TEST(LiveGrid, ReachesTheProjectsGridOnAFastMachine) {
  LiveGridControl grid{FieldSettings{}};
  settle(grid, 1.0);
  EXPECT_EQ(grid.resolution(), FieldSettings{}.resolution);
}

TEST(LiveGrid, HoldsRealTimeOnASlowMachine) {
  LiveGridControl grid{FieldSettings{}};
  const int side = settle(grid, 400.0);
  const double stepMs = 400.0 * 1e-6 * side * side;
  EXPECT_LT(stepMs, 0.5 * 1000.0 / 60.0);
  EXPECT_LT(side, LiveGridControl::kFirstSide);
}

TEST(LiveGrid, LeavesTheProjectsGridOnlyWhereItIsTooSlow) {
  LiveGridControl fast(FieldSettings{}, LiveGridStart::Project);
  EXPECT_EQ(fast.resolution(), FieldSettings{}.resolution);
  EXPECT_EQ(settle(fast, 2.0), 1000);
  LiveGridControl slow(FieldSettings{}, LiveGridStart::Project);
  EXPECT_LT(settle(slow, 40.0), 500);
}

TEST(LiveGrid, ComesToRest) {
  LiveGridControl grid{FieldSettings{}};
  settle(grid, 60.0);
  const glm::ivec2 before = grid.resolution();
  int changes = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::ivec2 cells = grid.resolution();
    changes += grid.stepDone(60.0 * 1e-6 * static_cast<double>(cells.x) * static_cast<double>(cells.y)) ? 1 : 0;
  }
  EXPECT_EQ(changes, 0);
  EXPECT_EQ(grid.resolution(), before);
}

TEST(LiveGrid, KeepsAtLeastEightCellsOnNarrowFields) {
  EXPECT_EQ(shrinkResolution({4096, 16}, 256), glm::ivec2(256, 8));
}

}  // namespace
}  // namespace windloom
