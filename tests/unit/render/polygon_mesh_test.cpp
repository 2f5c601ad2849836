#include "engine/render/polygon_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/render/solids.hpp"

namespace windloom {
namespace {

Obstacle notched() {
  Obstacle obstacle;
  obstacle.id = 1;
  obstacle.shape = ObstacleShape::Polygon;
  obstacle.centre = {10, -4};
  obstacle.height = 2;
  obstacle.points = {{-3, -3}, {3, -3}, {3, 3}, {0, 0}, {-3, 3}};
  return obstacle;
}

TEST(PolygonMesh, WallsAreClosedAndTheRoofLiesAtTheTop) {
  const std::vector<PolygonVertex> mesh = makePolygonMesh({notched()});
  ASSERT_EQ(mesh.size(), 3u * (5 * 4 + 3)) << "two triangles a side for wall and bevel each, three for the roof";
  double roof = 0;
  for (std::size_t i = 0; i < mesh.size(); i += 3) {
    const glm::vec3 face = glm::cross(mesh[i + 1].position - mesh[i].position, mesh[i + 2].position - mesh[i].position);
    EXPECT_GT(glm::length(face), 0.0f);
    if (mesh[i].normal == glm::vec3(0, 1, 0)) roof += 0.5 * static_cast<double>(std::abs(face.y));
  }
  EXPECT_GT(roof, 27.0 - 4.0) << "the whole outline less the bevel";
  EXPECT_LT(roof, 27.0);
  for (const PolygonVertex& vertex : mesh) {
    EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
    EXPECT_LE(vertex.position.y, 2.0f);
    EXPECT_EQ(vertex.height, 2.0f);
  }
}

TEST(PolygonMesh, NormalsPointOutwardsHoweverTheCornersGo) {
  Obstacle square = notched();
  square.points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (int turn = 0; turn < 2; ++turn) {
    for (const PolygonVertex& vertex : makePolygonMesh({square})) {
      const glm::vec3 out = vertex.position - glm::vec3(10, 0, -4);
      if (vertex.normal.y == 0.0f) {
        EXPECT_GT(glm::dot(out, vertex.normal), 0.0f);
      }
    }
    std::ranges::reverse(square.points);
  }
}

TEST(PolygonMesh, HiddenOnesAndOtherShapesHaveNone) {
  Obstacle hidden = notched();
  hidden.hidden = true;
  EXPECT_TRUE(makePolygonMesh({hidden, Obstacle{}}).empty());
}

TEST(Solids, APolygonFindsItsCornersInTheList) {
  Obstacle hidden = notched(), second = notched();
  hidden.hidden = true;
  second.points.resize(3);
  const std::vector<Obstacle> obstacles{notched(), hidden, Obstacle{}, second};
  const std::vector<Solid> solids = makeSolids(obstacles);
  ASSERT_EQ(solids.size(), 3u);
  EXPECT_EQ(solidCorners(obstacles).size(), 8u);
  EXPECT_EQ(glm::vec2(solids[0].level.z, solids[0].level.w), glm::vec2(0, 5));
  EXPECT_EQ(glm::vec2(solids[2].level.z, solids[2].level.w), glm::vec2(5, 3));
  EXPECT_EQ(solids[1].shape.w, SOLID_CIRCLE);
}

}  // namespace
}  // namespace windloom
