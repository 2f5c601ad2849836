#include "editor/core/graph_edits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "editor_bench.hpp"
#include "engine/model/validate.hpp"

namespace windloom::editor {
namespace {

/// Points 1..n at (10 i, 0); arrows 101, 102, ... from the pairs given.
Project graphOf(int points, std::vector<std::pair<Id, Id>> arrows, std::vector<Signal> signals = {}) {
  auto graph = std::make_shared<WindGraph>();
  for (int i = 1; i <= points; ++i) {
    Point point;
    point.id = static_cast<Id>(i);
    point.position = {10.0f * static_cast<float>(i), 0.0f};
    graph->points.push_back(point);
  }
  Id id = 101;
  for (const auto& [from, to] : arrows) {
    Arrow arrow;
    arrow.id = id++;
    arrow.from = from;
    arrow.to = to;
    graph->arrows.push_back(arrow);
  }
  graph->signals = std::move(signals);
  Project project;
  project.graph = graph;
  return project;
}

Project after(const Project& project, const Edit& edit) {
  const Result<Project> result = applyEdit(project, edit);
  EXPECT_TRUE(result) << (result ? "" : result.error().text());
  if (!result) return project;
  EXPECT_TRUE(validate(*result).empty());
  return *result;
}

std::vector<std::pair<Id, Id>> ends(const Project& project) {
  std::vector<std::pair<Id, Id>> list;
  for (const Arrow& arrow : project.graph->arrows) list.emplace_back(arrow.from, arrow.to);
  return list;
}
using Ends = std::vector<std::pair<Id, Id>>;
using Ids = std::vector<Id>;

Signal pulseAt(Id root) {
  Signal signal;
  signal.root = root;
  signal.kind = SignalKind::Pulse;
  return signal;
}

}  // namespace

TEST(GraphEdits, MergeJoinsFlowsAndDropsLoopsAndDoubles) {
  // 1 -> 2 -> 3, 1 -> 4: merging 2, 3 and 4 leaves one arrow.
  const Project project = graphOf(4, {{1, 2}, {2, 3}, {1, 4}});
  const Project merged = after(project, mergePointsEdit(project, Ids{2, 4, 3}));
  EXPECT_EQ(ends(merged), (Ends{{1, 3}}));
  ASSERT_EQ(merged.graph->points.size(), 2u);
  expectNear(findPoint(*merged.graph, 3)->position, {30, 0});
}

TEST(GraphEdits, MergeOfTwoTipsKeepsBothArrows) {
  const Project project = graphOf(5, {{1, 2}, {5, 4}});
  const Project merged = after(project, mergePointsEdit(project, Ids{2, 4}));
  EXPECT_EQ(ends(merged), (Ends{{1, 4}, {5, 4}}));
  expectNear(findPoint(*merged.graph, 4)->position, {30, 0});
}

TEST(GraphEdits, MergeMovesTheSignalOfARoot) {
  const Project project = graphOf(3, {{1, 2}, {3, 2}}, {pulseAt(1)});
  const Project merged = after(project, mergeIntoEdit(project, 1, 3));
  EXPECT_EQ(ends(merged), (Ends{{3, 2}}));
  ASSERT_EQ(merged.graph->signals.size(), 1u);
  EXPECT_EQ(merged.graph->signals[0].root, 3u);
  expectNear(findPoint(*merged.graph, 3)->position, {30, 0});
}

TEST(GraphEdits, MergeNeedsTwoPoints) {
  const Project project = graphOf(2, {{1, 2}});
  EXPECT_TRUE(mergePointsEdit(project, Ids{1, 1, 101}).steps.empty());
  EXPECT_TRUE(mergeIntoEdit(project, 1, 1).steps.empty());
  EXPECT_TRUE(mergeIntoEdit(project, 1, 77).steps.empty());
}

TEST(GraphEdits, SplitGivesEachFurtherArrowItsOwnPoint) {
  const Project project = graphOf(4, {{2, 3}, {1, 2}, {2, 4}});
  const SplitResult split = splitEdit(project, Ids{2});
  const Project result = after(project, split.edit);
  EXPECT_EQ(split.points, (Ids{104, 105}));
  EXPECT_EQ(ends(result), (Ends{{104, 3}, {1, 2}, {105, 4}}));
  expectNear(findPoint(*result.graph, 104)->position, {20, 0});
}

TEST(GraphEdits, SplitOfAnArrowCutsItOffAtItsStart) {
  const Project project = graphOf(4, {{1, 2}, {2, 3}, {2, 4}});
  const SplitResult split = splitEdit(project, Ids{102});
  EXPECT_EQ(ends(after(project, split.edit)), (Ends{{1, 2}, {104, 3}, {2, 4}}));
  EXPECT_TRUE(splitEdit(project, Ids{101}).points.empty());  // a root with one arrow
  EXPECT_TRUE(splitEdit(project, Ids{3}).points.empty());
}

TEST(GraphEdits, InsertPutsAPointBetween) {
  const Project project = graphOf(2, {{1, 2}});
  const InsertResult insert = insertPointEdit(project, 101, 0.25f);
  const Project result = after(project, insert.edit);
  EXPECT_EQ(ends(result), (Ends{{1, insert.point}, {insert.point, 2}}));
  expectNear(findPoint(*result.graph, insert.point)->position, {12.5f, 0});
  EXPECT_TRUE(insertPointEdit(project, 999, 0.5f).edit.steps.empty());
}

TEST(GraphEdits, DissolveJoinsTheArrowsAround) {
  const Project project = graphOf(4, {{1, 2}, {2, 3}, {3, 4}});
  EXPECT_EQ(ends(after(project, dissolveEdit(project, Ids{2}))), (Ends{{1, 3}, {3, 4}}));
  const Project both = after(project, dissolveEdit(project, Ids{3, 2}));
  EXPECT_EQ(ends(both), (Ends{{1, 4}}));
  EXPECT_EQ(both.graph->points.size(), 2u);
  const Project tip = after(project, dissolveEdit(project, Ids{4}));
  EXPECT_EQ(ends(tip), (Ends{{1, 2}, {2, 3}}));
}

TEST(GraphEdits, DissolveInATriangleMakesNoDouble) {
  const Project project = graphOf(3, {{1, 2}, {2, 3}, {1, 3}});
  EXPECT_EQ(ends(after(project, dissolveEdit(project, Ids{2}))), (Ends{{1, 3}}));
  const Project pair = graphOf(2, {{1, 2}, {2, 1}});
  EXPECT_EQ(ends(after(pair, dissolveEdit(pair, Ids{2}))), Ends{});
}

TEST(GraphEdits, ReverseTurnsATreeAroundAndTakesItsSignalAlong) {
  const Project project = graphOf(3, {{1, 2}, {2, 3}}, {pulseAt(1)});
  const Project result = after(project, reverseEdit(project, Ids{101, 102}));
  EXPECT_EQ(ends(result), (Ends{{2, 1}, {3, 2}}));
  ASSERT_EQ(result.graph->signals.size(), 1u);
  EXPECT_EQ(result.graph->signals[0].root, 3u);
  EXPECT_EQ(result.graph->signals[0].kind, SignalKind::Pulse);
  EXPECT_EQ(ends(after(result, reverseEdit(result, Ids{1, 2, 3}))), ends(project));
}

TEST(GraphEdits, ReverseOfOneArrowThatLeavesTheRootKeepsTheSignal) {
  const Project project = graphOf(3, {{1, 2}, {2, 3}}, {pulseAt(1)});
  const Project result = after(project, reverseEdit(project, Ids{102}));
  ASSERT_EQ(result.graph->signals.size(), 1u);
  EXPECT_EQ(result.graph->signals[0].root, 1u);
}

TEST(GraphEdits, ReparentHangsPointsOnTheLastOne) {
  const Project project = graphOf(5, {{1, 2}, {2, 3}, {1, 4}});
  EXPECT_EQ(ends(after(project, reparentEdit(project, Ids{3, 4}))), (Ends{{1, 2}, {4, 3}, {1, 4}}));
  EXPECT_TRUE(reparentEdit(project, Ids{3}).steps.empty());
  EXPECT_TRUE(reparentEdit(project, Ids{1, 4}).steps.empty());  // a root has no arrow to it
}

TEST(ObjectEdits, DuplicateCopiesATreeWithItsSignal) {
  const Project project = graphOf(2, {{1, 2}}, {pulseAt(1)});
  const DuplicateResult copy = duplicateEdit(project, Ids{1, 2, 101}, {0, 5});
  const Project result = after(project, copy.edit);
  ASSERT_EQ(result.graph->arrows.size(), 2u);
  EXPECT_EQ(result.graph->points.size(), 4u);
  ASSERT_EQ(copy.ids.size(), 3u);
  EXPECT_EQ(findArrow(*result.graph, copy.ids[2])->from, copy.ids[0]);
  expectNear(findPoint(*result.graph, copy.ids[1])->position, {20, 5});
  ASSERT_EQ(result.graph->signals.size(), 2u);
  EXPECT_EQ(result.graph->signals[1].root, copy.ids[0]);
}

TEST(ObjectEdits, DuplicateOfAnArrowTakesItsEndsAlong) {
  const Project project = graphOf(3, {{1, 2}, {2, 3}});
  const DuplicateResult copy = duplicateEdit(project, Ids{102}, {0, 5});
  const Project result = after(project, copy.edit);
  EXPECT_EQ(result.graph->points.size(), 5u);
  EXPECT_EQ(result.graph->arrows.size(), 3u);
  EXPECT_EQ(copy.ids.size(), 1u);
}

TEST(ObjectEdits, DeleteTakesLoneEndsButNoSharedPoint) {
  const Project project = graphOf(4, {{1, 2}, {2, 3}, {2, 4}});
  const Project result = after(project, deleteEdit(project, Ids{102}));
  EXPECT_EQ(ends(result), (Ends{{1, 2}, {2, 4}}));
  EXPECT_FALSE(findPoint(*result.graph, 3));
  const Project none = after(project, deleteEdit(project, Ids{2}));
  EXPECT_TRUE(none.graph->points.empty());
  EXPECT_TRUE(deleteEdit(project, Ids{999}).steps.empty());
}

TEST(ObjectEdits, DeleteLeavesPointsThatWereAloneBefore) {
  const Project project = graphOf(3, {{1, 2}});
  const Project result = after(project, deleteEdit(project, Ids{101}));
  ASSERT_EQ(result.graph->points.size(), 1u);
  EXPECT_EQ(result.graph->points[0].id, 3u);
}

TEST(ObjectEdits, FlagsOfPointsGoToTheirArrows) {
  const Project project = graphOf(3, {{1, 2}, {2, 3}});
  const Project both = after(project, flagEdit(project, Ids{1, 2}, Flag::Muted, true));
  EXPECT_TRUE(both.graph->arrows[0].muted);
  EXPECT_FALSE(both.graph->arrows[1].muted);
  const Project touching = after(project, flagEdit(project, Ids{2}, Flag::Muted, true));
  EXPECT_TRUE(touching.graph->arrows[0].muted && touching.graph->arrows[1].muted);
  EXPECT_TRUE(allFlagged(touching, Ids{2}, Flag::Muted));
  EXPECT_FALSE(allFlagged(both, Ids{1, 2, 3}, Flag::Muted));
  EXPECT_FALSE(after(touching, clearFlagEdit(touching, Flag::Muted)).graph->arrows[0].muted);
}

TEST(ObjectEdits, IsolateHidesTheRest) {
  const Project project = graphOf(3, {{1, 2}, {2, 3}});
  const Project result = after(project, isolateEdit(project, Ids{101}));
  EXPECT_FALSE(result.graph->arrows[0].hidden);
  EXPECT_TRUE(result.graph->arrows[1].hidden);
  EXPECT_TRUE(isolateEdit(result, Ids{101}).steps.empty());
}

TEST(ObjectEdits, LockedThingsDoNotMove) {
  const Project project = graphOf(3, {{1, 2}, {2, 3}});
  const Project locked = after(project, flagEdit(project, Ids{102}, Flag::Locked, true));
  EXPECT_EQ(movableIds(locked, Ids{101, 102}), (Ids{1, 2}));
  EXPECT_TRUE(movableIds(locked, Ids{3, 102}).empty());
}

TEST(ObjectEdits, StrengthStepsStayInRangeAndMerge) {
  const Project project = graphOf(2, {{1, 2}});
  const Edit edit = scaleStrengthEdit(project, Ids{1}, 1000.0f);
  EXPECT_FLOAT_EQ(after(project, edit).graph->arrows[0].strength, 100.0f);
  EXPECT_EQ(edit.mergeKey, scaleStrengthEdit(project, Ids{2}, 2.0f).mergeKey);
  EXPECT_NE(edit.mergeKey, scaleRadiusEdit(project, Ids{1}, 2.0f).mergeKey);
}

TEST(ObjectEdits, RenameToTheSameNameIsNothing) {
  const Project project = graphOf(2, {{1, 2}});
  const Project named = after(project, renameEdit(project, 1, "gate"));
  EXPECT_EQ(named.graph->points[0].name, "gate");
  EXPECT_TRUE(renameEdit(named, 1, "gate").steps.empty());
  EXPECT_EQ(describeIds(named, Ids{1}), "Point 1 (gate)");
  EXPECT_EQ(describeIds(named, Ids{1, 2, 101}), "2 points, 1 arrow");
}

TEST(ObjectEdits, LinkedIsTheWholeTree) {
  const Project project = graphOf(5, {{1, 2}, {3, 2}, {4, 5}});
  std::vector<Id> linked = linkedIds(project, Ids{101});
  std::sort(linked.begin(), linked.end());
  EXPECT_EQ(linked, (Ids{1, 2, 3, 101, 102}));
}

TEST(GraphEdits, GoOnWhereTheHighestIdIsTaken) {
  Project project = graphOf(4, {{1, 2}, {2, 3}, {2, 4}});
  auto graph = std::make_shared<WindGraph>(*project.graph);
  graph->arrows.back().id = kMaxId;
  graph->points[3].position.y = 5;
  project.graph = graph;
  const Arrow model;
  after(project, connectEdit(project, 3, 4, model).edit);
  after(project, feedEdit(project, {0, 30}, 1, model).edit);
  after(project, insertPointEdit(project, kMaxId, 0.5f).edit);
  EXPECT_EQ(after(project, splitEdit(project, Ids{2}).edit).graph->points.size(), 6u);
  const Project twice = after(project, duplicateEdit(project, Ids{1, 2, 3, 4, 101, 102, kMaxId}, {0, 50}).edit);
  EXPECT_EQ(twice.graph->points.size(), 8u);
  EXPECT_EQ(twice.graph->arrows.size(), 6u);
}

}  // namespace windloom::editor
