// Polygon obstacles in the project file.
#include <gtest/gtest.h>

#include "engine/io/project_json.hpp"

namespace windloom {
namespace {

std::string withObstacle(const std::string& record) {
  return R"({"format": "windloom-project", "version": 1, "obstacles": [)" + record + "]}";
}

std::vector<std::string> problems(const std::string& record) {
  const Result<LoadedProject> loaded = parseProject(withObstacle(record), "x");
  std::vector<std::string> pointers;
  if (!loaded)
    for (const Problem& problem : loaded.error().problems) pointers.push_back(problem.pointer);
  return pointers;
}

TEST(PolygonJson, IsReadAndWrittenOnOneLine) {
  const std::string line =
      R"({"id": 3, "shape": "polygon", "centre": [5, -8], "rotation": 30, "points": [[-1, -1], [2, 0], [0.5, 1.25]]})";
  const Result<LoadedProject> loaded = parseProject(withObstacle(line), "x");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  EXPECT_TRUE(loaded->warnings.empty());
  const Obstacle& obstacle = loaded->project.obstacles->front();
  EXPECT_EQ(obstacle.shape, ObstacleShape::Polygon);
  EXPECT_EQ(obstacle.points, (std::vector<glm::vec2>{{-1, -1}, {2, 0}, {0.5f, 1.25f}}));
  const std::string text = writeProject(loaded->project);
  EXPECT_NE(text.find("\n    " + line + "\n"), std::string::npos) << text;
  EXPECT_EQ(writeProject(parseProject(text, "x")->project), text);
}

TEST(PolygonJson, RefusesWithThePlace) {
  using Pointers = std::vector<std::string>;
  const auto polygon = [](const std::string& points) {
    return R"({"id": 3, "shape": "polygon", "centre": [0, 0], "points": )" + points + "}";
  };
  EXPECT_EQ(problems(R"({"id": 3, "shape": "polygon", "centre": [0, 0]})"), Pointers{"/obstacles/0/points"});
  EXPECT_EQ(problems(polygon("7")), Pointers{"/obstacles/0/points"});
  EXPECT_EQ(problems(polygon("[[0, 0], [1, 0]]")), Pointers{"/obstacles/0/points"});
  EXPECT_EQ(problems(polygon("[[0, 0], [1, 0], \"x\"]")), Pointers{"/obstacles/0/points/2"});
  EXPECT_EQ(problems(polygon("[[0, 0], [1, 0], [1e9, 1]]")), Pointers{"/obstacles/0/points/2"});
  EXPECT_EQ(problems(polygon("[[0, 0], [1, 1], [1, 0], [0, 1]]")), Pointers{"/obstacles/0/points"});
  EXPECT_EQ(problems(polygon("[[0, 0], [1, 0], [2, 0]]")), Pointers{"/obstacles/0/points"});
}

TEST(PolygonJson, ACircleMayKeepLegalCornersForLater) {
  EXPECT_TRUE(problems(R"({"id": 3, "centre": [0, 0], "points": [[0, 0], [1, 0], [0, 1]]})").empty());
  EXPECT_FALSE(problems(R"({"id": 3, "centre": [0, 0], "points": [[0, 0], [1, 0], [2, 0]]})").empty());
}

}  // namespace
}  // namespace windloom
