#include "engine/model/templates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "engine/model/evaluate.hpp"
#include "engine/model/validate.hpp"

namespace windloom {

class Templates : public testing::TestWithParam<ProjectTemplate> {};

TEST_P(Templates, IsValid) {
  for (const Problem& problem : validate(GetParam().make())) ADD_FAILURE() << problem.text();
}

TEST_P(Templates, HasTheCamerasHeroAndTop) {
  std::set<std::string> names;
  const Project project = GetParam().make();
  for (const Camera& camera : *project.cameras) names.insert(camera.name);
  EXPECT_TRUE(names.contains("hero"));
  EXPECT_TRUE(names.contains("top"));
}

TEST_P(Templates, EveryArrowIsReachedWithinHalfAMinute) {
  const Project project = GetParam().make();
  const GraphEvaluator evaluator(*project.graph);
  for (const Arrival& arrival : evaluator.arrivals()) EXPECT_LT(arrival.time, 30);
}

TEST_P(Templates, ArrowsLieInsideTheField) {
  const Project project = GetParam().make();
  const glm::vec2 half = project.field->size * 0.5f;
  for (const Point& point : project.graph->points) {
    const glm::vec2 away = glm::abs(point.position - project.field->centre);
    EXPECT_TRUE(away.x < half.x && away.y < half.y) << point.id;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Templates, testing::ValuesIn(projectTemplates().begin(), projectTemplates().end()),
                         [](const auto& chosen) {
                           std::string name(chosen.param.name);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(FindTemplate, GivesNullForUnknownNames) {
  EXPECT_EQ(findTemplate("nope"), nullptr);
  ASSERT_NE(findTemplate("meadow"), nullptr);
  EXPECT_EQ(findTemplate("meadow")->title, "Meadow");
}

TEST(CollidingWinds, IsMirrorSymmetric) {
  const Project project = findTemplate("colliding-winds")->make();
  for (const Point& point : project.graph->points) {
    EXPECT_TRUE(std::ranges::any_of(project.graph->points, [&](const Point& other) {
      return other.position == glm::vec2(-point.position.x, point.position.y);
    })) << point.id;
  }
}

}  // namespace windloom
