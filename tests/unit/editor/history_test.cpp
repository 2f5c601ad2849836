#include "editor/core/history.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "editor/core/selection.hpp"

namespace windloom::editor {
namespace {

/// The project with a graph of `points` points.
Project withPoints(Project project, std::size_t points) {
  auto graph = std::make_shared<WindGraph>();
  graph->points.resize(points);
  for (std::size_t i = 0; i < points; ++i) graph->points[i].id = static_cast<Id>(i + 1);
  project.graph = graph;
  return project;
}

std::size_t pointsOf(const History& history) {
  return history.current().graph->points.size();
}

}  // namespace

TEST(History, UndoAndRedoWalkTheEntries) {
  History history{Project{}};
  for (std::size_t i = 1; i <= 3; ++i) history.push(withPoints(history.current(), i), "Step");
  EXPECT_FALSE(history.canRedo());
  EXPECT_TRUE(history.undo());
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(pointsOf(history), 1u);
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(pointsOf(history), 2u);
  EXPECT_TRUE(history.jump(0));
  EXPECT_EQ(pointsOf(history), 0u);
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.jump(4));
}

TEST(History, PushAfterUndoDropsWhatCouldBeRedone) {
  History history{Project{}};
  history.push(withPoints(history.current(), 1), "One");
  history.push(withPoints(history.current(), 2), "Two");
  history.undo();
  history.push(withPoints(history.current(), 5), "Five");
  EXPECT_FALSE(history.canRedo());
  ASSERT_EQ(history.entries().size(), 3u);
  EXPECT_EQ(history.entries()[2].label, "Five");
}

TEST(History, SameMergeKeyIsOneStep) {
  History history{Project{}};
  for (std::size_t i = 1; i <= 5; ++i) history.push(withPoints(history.current(), i), "Slide", "radius");
  EXPECT_EQ(history.entries().size(), 2u);
  EXPECT_EQ(pointsOf(history), 5u);
  history.push(withPoints(history.current(), 6), "Slide", "strength");
  EXPECT_EQ(history.entries().size(), 3u);
  history.push(withPoints(history.current(), 7), "Plain");
  history.push(withPoints(history.current(), 8), "Plain");
  EXPECT_EQ(history.entries().size(), 5u);
  history.jump(1);
  history.undo();
  EXPECT_EQ(pointsOf(history), 0u);
}

TEST(History, SealUndoAndSaveEndMerging) {
  History history{Project{}};
  history.push(withPoints(history.current(), 1), "Slide", "radius");
  history.seal();
  history.push(withPoints(history.current(), 2), "Slide", "radius");
  EXPECT_EQ(history.entries().size(), 3u);
  history.undo();
  history.redo();
  history.push(withPoints(history.current(), 3), "Slide", "radius");
  EXPECT_EQ(history.entries().size(), 4u);
  history.markSaved();
  history.push(withPoints(history.current(), 4), "Slide", "radius");
  EXPECT_TRUE(history.dirty());
  history.undo();
  EXPECT_FALSE(history.dirty());
  EXPECT_EQ(pointsOf(history), 3u);
}

TEST(History, IsCleanOnlyAtTheSavedEntry) {
  History history{Project{}};
  EXPECT_FALSE(history.dirty());
  history.push(withPoints(history.current(), 1), "One");
  EXPECT_TRUE(history.dirty());
  history.markSaved();
  EXPECT_FALSE(history.dirty());
  history.undo();
  EXPECT_TRUE(history.dirty());
  history.redo();
  EXPECT_FALSE(history.dirty());
  history.markUnsaved();
  EXPECT_TRUE(history.dirty());
}

TEST(History, SharedPartsAreCountedOnce) {
  const std::size_t one = History(withPoints(Project{}, 1000)).bytes();
  EXPECT_GE(one, 1000 * sizeof(Point));
  History history(withPoints(Project{}, 1000));
  for (int i = 0; i < 100; ++i) {
    Project next = history.current();
    next.ambient = std::make_shared<AmbientWind>();
    history.push(std::move(next), "Ambient");
  }
  EXPECT_LT(history.bytes(), 2 * one);
}

TEST(History, KeepsTwoHundredStepsWhateverTheirSize) {
  HistoryLimits limits;
  limits.bytes = 1;
  History history(Project{}, limits);
  for (std::size_t i = 1; i <= 300; ++i) history.push(withPoints(history.current(), i), "Step");
  EXPECT_EQ(history.entries().size(), 201u);
  std::size_t undone = 0;
  while (history.undo()) ++undone;
  EXPECT_EQ(undone, 200u);
  EXPECT_EQ(pointsOf(history), 100u);
}

TEST(History, DropsOldStepsOverTheByteBudgetAndKeepsTheCountRight) {
  HistoryLimits limits;
  limits.bytes = 40 * 1000 * sizeof(Point);
  limits.keepSteps = 5;
  History history(Project{}, limits);
  for (int i = 0; i < 100; ++i) history.push(withPoints(history.current(), 1000), "Step");
  EXPECT_LE(history.bytes(), limits.bytes);
  EXPECT_GT(history.entries().size(), 20u);
  EXPECT_EQ(history.position(), history.entries().size() - 1);
  std::size_t sum = 0;
  for (const History::Entry& entry : history.entries()) sum += entry.project.graph->points.capacity() * sizeof(Point);
  EXPECT_GE(history.bytes(), sum);
}

TEST(Selection, ModesCombine) {
  Selection selection;
  select(selection, std::vector<Id>{1, 2, 2, 0}, SelectMode::Replace);
  EXPECT_EQ(selection.size(), 2u);
  select(selection, std::vector<Id>{1, 3}, SelectMode::Add);
  EXPECT_EQ(selection.size(), 3u);
  EXPECT_EQ(selection.active(), 3u);
  select(selection, std::vector<Id>{3, 4}, SelectMode::Toggle);
  EXPECT_FALSE(selection.contains(3));
  EXPECT_EQ(selection.active(), 4u);
}

TEST(Selection, RepairDropsWhatIsGone) {
  const Project project = withPoints(Project{}, 2);
  Selection selection;
  selection.replace({1, 7, 2});
  EXPECT_TRUE(selection.repair(project));
  EXPECT_EQ(std::vector<Id>(selection.ids().begin(), selection.ids().end()), (std::vector<Id>{1, 2}));
  EXPECT_FALSE(selection.repair(project));
}

}  // namespace windloom::editor
