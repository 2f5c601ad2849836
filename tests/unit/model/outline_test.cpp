#include "engine/model/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/model/edit.hpp"

namespace windloom {
namespace {

using Corners = std::vector<glm::vec2>;

const Corners kSquare{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
const Corners kArrowHead{{-2, -2}, {0, -1}, {2, -2}, {0, 2}};  // concave at (0, -1)

double areaOf(const Corners& corners, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  double sum = 0;
  for (const auto& t : triangles) {
    const float area = signedArea(Corners{corners[t[0]], corners[t[1]], corners[t[2]]});
    EXPECT_GE(area, 0.0f) << "triangles all turn the same way";
    sum += static_cast<double>(area);
  }
  return sum;
}

/// A star around the origin: simple for any radii.
Corners star(std::mt19937& random, int count) {
  std::uniform_real_distribution<float> radius(0.5f, 6.0f);
  Corners corners;
  for (int i = 0; i < count; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / static_cast<float>(count);
    corners.push_back(radius(random) * glm::vec2(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

Obstacle polygon(Corners points, glm::vec2 centre = {0, 0}, float rotation = 0) {
  Obstacle obstacle;
  obstacle.id = 30;
  obstacle.shape = ObstacleShape::Polygon;
  obstacle.points = std::move(points);
  obstacle.centre = centre;
  obstacle.rotation = rotation;
  return obstacle;
}

std::vector<std::string> refusals(Obstacle obstacle) {
  std::vector<std::string> pointers;
  Edit edit;
  edit.steps.emplace_back(Put<Obstacle>{std::move(obstacle)});
  const Result<Project> result = applyEdit(Project{}, edit);
  if (!result)
    for (const Problem& problem : result.error().problems) pointers.push_back(problem.pointer);
  return pointers;
}

TEST(Outline, TrianglesCoverAPolygonExactly) {
  std::mt19937 random(7);
  for (int count = 3; count <= 256; count += count < 20 ? 1 : 47) {
    Corners corners = star(random, count);
    if (count % 2 == 0) std::reverse(corners.begin(), corners.end());
    const auto triangles = triangulate(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    const double area = std::abs(static_cast<double>(signedArea(corners)));
    EXPECT_NEAR(areaOf(corners, triangles), area, 1e-4 * area) << count << " corners";
  }
}

TEST(Outline, TrianglesCoverACombWithStraightCorners) {
  Corners comb{{0, 0}, {10, 0}, {10, 5}};
  for (int tooth = 9; tooth >= 0; --tooth) {
    const float x = static_cast<float>(tooth);
    comb.insert(comb.end(), {{x + 0.5f, 5}, {x + 0.5f, 1}, {x, 1}});
    if (tooth > 0) comb.push_back({x, 5});
  }
  const auto triangles = triangulate(comb);
  const double area = std::abs(static_cast<double>(signedArea(comb)));
  ASSERT_FALSE(polygonProblem(comb)) << polygonProblem(comb)->message;
  EXPECT_NEAR(areaOf(comb, triangles), area, 1e-4 * area);
}

TEST(Outline, AConcavePolygonHoldsWhatIsInItOnly) {
  const Obstacle head = polygon(kArrowHead, {10, 5}, 90);
  EXPECT_TRUE(isInside(head, toWorld(head, {0, 0})));
  EXPECT_FALSE(isInside(head, toWorld(head, {0, -1.5f}))) << "the notch is outside";
  EXPECT_NEAR(toWorld(head, {0, 2}).x, 8.0f, 1e-5f) << "a quarter turn takes +z to -x";
  EXPECT_NEAR(toWorld(head, {0, 2}).y, 5.0f, 1e-5f);
}

TEST(Outline, TheCentroidAndAreaOfASquareAreThoseOfASquare) {
  Corners moved;
  for (const glm::vec2 corner : kSquare) moved.push_back(corner + glm::vec2(1000, -500));
  EXPECT_NEAR(signedArea(moved), 4.0f, 1e-4f);
  EXPECT_NEAR(centroidOf(moved).x, 1000.0f, 1e-3f);
  EXPECT_NEAR(centroidOf(moved).y, -500.0f, 1e-3f);
}

TEST(Outline, RefusesPolygonsThatEncloseNoPlainArea) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::pair<Corners, const char*> cases[] = {
      {{}, "/obstacles/0/points"},
      {{{0, 0}, {1, 0}}, "/obstacles/0/points"},
      {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, "/obstacles/0/points"},          // a bow tie
      {{{0, 0}, {1, 0}, {2, 0}}, "/obstacles/0/points"},                  // no area
      {{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}, "/obstacles/0/points"},  // touches its own side
      {{{0, 0}, {2, 0}, {4, 0}, {1, 0}, {1, 3}}, "/obstacles/0/points"},  // folds back
      {{{0, 0}, {1, nan}, {1, 1}}, "/obstacles/0/points/1"},
      {{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, "/obstacles/0/points/2"},  // twice the same
      {{{0, 0}, {20000, 0}, {1, 1}}, "/obstacles/0/points/1"},
      {Corners(300, {0, 0}), "/obstacles/0/points"}};
  for (const auto& [corners, pointer] : cases)
    EXPECT_EQ(refusals(polygon(corners)), std::vector<std::string>{pointer}) << corners.size() << " corners";
  EXPECT_TRUE(refusals(polygon(kSquare)).empty());
  EXPECT_TRUE(refusals(polygon(kArrowHead)).empty());
}

TEST(Reorder, MovesRecordsBeforeAnotherOrToTheEnd) {
  Project project;
  std::vector<Probe> probes(5);
  for (Id id = 1; id <= 5; ++id) probes[id - 1].id = id;
  project.probes = std::make_shared<std::vector<Probe>>(probes);
  const auto order = [&](std::vector<Id> ids, Id before) {
    const Result<Project> moved = applyEdit(project, Edit{"Reorder", {Reorder{std::move(ids), before}}, ""});
    std::string text;
    for (const Probe& probe : *moved->probes) text += std::to_string(probe.id);
    return text;
  };
  EXPECT_EQ(order({4}, 2), "14235");
  EXPECT_EQ(order({2}, 5), "13425");
  EXPECT_EQ(order({1, 3}, 0), "24513");
  EXPECT_EQ(order({5, 2}, 4), "13254") << "they keep their own order";
  EXPECT_EQ(order({2, 3}, 2), "12345") << "before one of themselves: they stay";
  EXPECT_EQ(order({3}, 99), "12345") << "no such record";
  EXPECT_EQ(order({99}, 1), "12345");
}

TEST(Reorder, TouchesNoOtherList) {
  Project project;
  std::vector<Probe> probes(2);
  probes[0].id = 1;
  probes[1].id = 2;
  project.probes = std::make_shared<std::vector<Probe>>(probes);
  const Result<Project> moved = applyEdit(project, Edit{"Reorder", {Reorder{{1}, 0}}, ""});
  EXPECT_EQ(moved->graph, project.graph);
  EXPECT_EQ(moved->obstacles, project.obstacles);
  EXPECT_NE(moved->probes, project.probes);
}

}  // namespace
}  // namespace windloom
