#include "engine/core/grid_mapping.hpp"

#include <gtest/gtest.h>

namespace windloom {

TEST(GridMapping, CellCentresRoundTrip) {
  const GridMapping grid = makeGridMapping({5, -3}, {100, 40}, {257, 33});
  for (glm::vec2 cell : {glm::vec2(0, 0), glm::vec2(256, 32), glm::vec2(100, 7)}) {
    const glm::vec2 world = cellCentreToWorld(cell, grid.minCorner, grid.cellSize);
    const glm::vec2 back = worldToCell(world, grid.minCorner, grid.cellSize);
    EXPECT_NEAR(back.x, cell.x, 1e-3f);
    EXPECT_NEAR(back.y, cell.y, 1e-3f);
    EXPECT_EQ(cellOf(grid, world), glm::ivec2(cell));
  }
}

TEST(GridMapping, TexelCentreIsCellCentre) {
  const GridMapping grid = makeGridMapping({0, 0}, {8, 8}, {8, 8});
  const glm::vec2 uv = worldToUv(cellCentreToWorld({2, 5}, grid.minCorner, grid.cellSize), grid.minCorner, grid.size);
  EXPECT_FLOAT_EQ(uv.x * 8, 2.5f);
  EXPECT_FLOAT_EQ(uv.y * 8, 5.5f);
}

TEST(GridMapping, GroupsClampOutsideTheField) {
  const GridMapping grid = makeGridMapping({0, 0}, {100, 100}, {1000, 1000});
  EXPECT_EQ(cellOf(grid, {-50, -50}), glm::ivec2(0, 0));
  EXPECT_EQ(cellOf(grid, {50, 50}), glm::ivec2(999, 999));
  EXPECT_EQ(cellOf(grid, {1e30f, -1e30f}), glm::ivec2(999, 0));
}

}  // namespace windloom
