#include "engine/model/edit.hpp"

#include <gtest/gtest.h>

#include "engine/model/validate.hpp"
#include "tests/unit/model/model_fixture.hpp"

namespace windloom {

TEST(Edit, LeavesTheOldProjectAndOtherPartsAlone) {
  const Project before = projectOf(smallTree());
  const Result<Project> after = applyEdit(before, moveEdit(before, std::vector<Id>{2}, {0, 5}));
  ASSERT_TRUE(after.ok());
  EXPECT_EQ(findPoint(*before.graph, 2)->position, glm::vec2(10, 0));
  EXPECT_EQ(findPoint(*after->graph, 2)->position, glm::vec2(10, 5));
  EXPECT_NE(after->graph, before.graph);
  EXPECT_EQ(after->field, before.field);
  EXPECT_EQ(after->obstacles, before.obstacles);
  EXPECT_FALSE(after->sameAs(before));
}

TEST(Edit, EraseTakesArrowsAndSignalWithThePoint) {
  WindGraph graph = smallTree();
  graph.signals.resize(1);
  graph.signals[0].root = 1;
  const Project before = projectOf(graph);
  const Result<Project> after = applyEdit(before, eraseEdit({1}));
  ASSERT_TRUE(after.ok());
  EXPECT_EQ(after->graph->points.size(), 3u);
  EXPECT_EQ(after->graph->arrows.size(), 2u);
  EXPECT_TRUE(after->graph->signals.empty());
  EXPECT_TRUE(validate(*after).empty());
}

TEST(Edit, TreeAndBranchMakeValidGraphsWithFreshIds) {
  Project project;
  const TreeResult tree = treeEdit(project, {0, 0}, {10, 0}, Arrow{});
  project = applyEdit(project, tree.edit).value();
  const BranchResult branch = branchEdit(project, tree.end, {20, 5}, Arrow{});
  project = applyEdit(project, branch.edit).value();
  EXPECT_EQ(project.graph->points.size(), 3u);
  ASSERT_EQ(project.graph->arrows.size(), 2u);
  EXPECT_EQ(findArrow(*project.graph, branch.arrow)->from, tree.end);
  EXPECT_EQ(findRoots(*project.graph), (std::vector<Id>{tree.root}));
  EXPECT_TRUE(validate(project).empty());
}

TEST(Edit, RefusesWhatWouldBreakTheProject) {
  const Project before = projectOf(smallTree());
  const auto refused = [&](const EditStep& step) { return !applyEdit(before, Edit{"bad", {step}, ""}).ok(); };
  EXPECT_TRUE(refused(Put<Arrow>{arrowBetween(50, 1, 99)}));
  EXPECT_TRUE(refused(Put<Arrow>{arrowBetween(50, 1, 1)}));
  EXPECT_TRUE(refused(Put<Point>{pointAt(2, {0, 0})}));  // on top of point 1: a zero-length arrow
  EXPECT_TRUE(refused(Put<Point>{pointAt(10, {5, 5})}));  // 10 is an arrow
  FieldSettings field;
  field.resolution = {0, 1000};
  EXPECT_TRUE(refused(Set<FieldSettings>{field}));
  Obstacle obstacle;
  obstacle.id = 77;
  obstacle.radius = -1;
  EXPECT_TRUE(refused(Put<Obstacle>{obstacle}));
  EXPECT_FALSE(refused(Put<Arrow>{arrowBetween(50, 4, 3)}));
}

TEST(Edit, PutReplacesTheRecordWithTheSameId) {
  const Project before = projectOf(smallTree());
  Arrow stronger = before.graph->arrows[1];
  stronger.strength = 20;
  const Project after = applyEdit(before, Edit{"Strength", {Put<Arrow>{stronger}}, ""}).value();
  ASSERT_EQ(after.graph->arrows.size(), 3u);
  EXPECT_EQ(after.graph->arrows[1].strength, 20);
}

}  // namespace windloom
