// Polygon obstacles stop the air as boxes and circles do.
#include <gtest/gtest.h>

#include "engine/model/outline.hpp"
#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {

Obstacle asPolygon(Obstacle obstacle, int pieces = 48) {
  const std::vector<glm::vec2> corners = outlineOf(obstacle, pieces);
  obstacle.points.clear();
  for (const glm::vec2 corner : corners) obstacle.points.push_back(toOwn(obstacle, corner));
  obstacle.shape = ObstacleShape::Polygon;
  return obstacle;
}

WindSetup channel(std::vector<Obstacle> obstacles) {
  WindSetup setup = bareSetup({96, 64}, 0.25f, Border::Open, 1.0f / 60);
  setup.ambient.speed = 5;
  setup.obstacles = std::move(obstacles);
  return setup;
}

std::vector<glm::vec2> windAfter(const WindSetup& setup, int steps) {
  auto solver = makeCpuWindSolver(setup, 1);
  for (int n = 0; n < steps; ++n) (*solver)->step({}, n * static_cast<double>(setup.field.timeStep));
  std::vector<glm::vec2> cells;
  (*solver)->readVelocity(cells);
  return cells;
}

double relativeDifference(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += std::pow(static_cast<double>(glm::distance(a[i], b[i])), 2);
    size += std::pow(static_cast<double>(glm::length(a[i])), 2);
  }
  return std::sqrt(difference / size);
}

Obstacle box(float rotation) {
  Obstacle obstacle;
  obstacle.shape = ObstacleShape::Box;
  obstacle.centre = {10.03f, 8.04f};
  obstacle.size = {4.1f, 2.3f};
  obstacle.rotation = rotation;
  return obstacle;
}

TEST(PolygonSolids, ARectangleFillsTheCellsOfABox) {
  for (const float rotation : {0.0f, 30.0f, 77.0f}) {
    const WindGrid a = makeWindGrid(channel({}).field, std::vector{box(rotation)});
    const WindGrid b = makeWindGrid(channel({}).field, std::vector{asPolygon(box(rotation))});
    EXPECT_EQ(a.solid, b.solid) << rotation;
    EXPECT_LT(a.airCells, a.solid.size());
  }
}

TEST(PolygonSolids, EveryCellAgreesWithTheInsideTest) {
  Obstacle star;
  star.shape = ObstacleShape::Polygon;
  star.centre = {12, 8};
  star.rotation = 20;
  for (int i = 0; i < 14; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / 14;
    star.points.push_back((i % 2 == 0 ? 6.0f : 2.0f) * glm::vec2(std::cos(angle), std::sin(angle)));
  }
  const WindGrid grid = makeWindGrid(channel({}).field, std::vector{star});
  for (int k = 0; k < grid.height; ++k)
    for (int i = 0; i < grid.width; ++i)
      EXPECT_EQ(grid.solidAt(i, k),
                isInside(star, cellCentreToWorld(glm::vec2(i, k), grid.mapping.minCorner, grid.mapping.cellSize)))
          << i << ", " << k;
}

TEST(PolygonSolids, ARectangleTurnsTheWindAsABoxDoes) {
  const auto byBox = windAfter(channel({box(30)}), 60), byPolygon = windAfter(channel({asPolygon(box(30))}), 60);
  EXPECT_EQ(relativeDifference(byBox, byPolygon), 0.0);
}

TEST(PolygonSolids, AHexagonTurnsTheWindNearlyAsItsCircleDoes) {
  Obstacle circle;
  circle.centre = {10, 8};
  circle.radius = 2;
  Obstacle round = circle;
  round.radius = 2.2f;  // a hexagon of the circle's area
  const auto free = windAfter(channel({}), 120), byCircle = windAfter(channel({circle}), 120);
  const auto byHexagon = windAfter(channel({asPolygon(round, 6)}), 120);
  EXPECT_GT(relativeDifference(free, byCircle), 0.2);
  EXPECT_LT(relativeDifference(byCircle, byHexagon), 0.12);
}

TEST(PolygonSolids, AMutedPolygonLetsTheAirThrough) {
  Obstacle muted = asPolygon(box(0));
  muted.muted = true;
  EXPECT_EQ(makeWindGrid(channel({}).field, std::vector{muted}).airCells, 96u * 64u);
}

}  // namespace windloom::testing
