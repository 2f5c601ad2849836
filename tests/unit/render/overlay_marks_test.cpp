#include "engine/render/overlay_marks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

namespace windloom {
namespace {

/// 1 -> 2 -> 3, the second arrow hidden; both 10 m/s, 10 m long.
Project treeProject() {
  WindGraph graph;
  graph.points.resize(3);
  for (Id i = 0; i < 3; ++i) {
    graph.points[i].id = i + 1;
    graph.points[i].position = {-10.0f + 10.0f * static_cast<float>(i), 0.0f};
  }
  Arrow arrow;
  arrow.id = 10;
  arrow.from = 1;
  arrow.to = 2;
  arrow.strength = 6.0f;
  graph.arrows.push_back(arrow);
  arrow.id = 11;
  arrow.from = 2;
  arrow.to = 3;
  arrow.hidden = true;
  graph.arrows.push_back(arrow);
  Project project;
  project.graph = std::make_shared<WindGraph>(graph);
  return project;
}

Project changed(const Project& project, const std::function<void(WindGraph&)>& change) {
  WindGraph graph = *project.graph;
  change(graph);
  Project next = project;
  next.graph = std::make_shared<WindGraph>(graph);
  return next;
}

OverlayMarks marksOf(const Project& project, const Highlight& highlight = {}) {
  const GraphLinks links(*project.graph);
  OverlaySignals signals;
  signals.build(*project.graph, links, nullptr);
  return makeOverlayMarks(project, links, signals, highlight);
}

/// The factor that the shaders read at a share of an arrow.
float levelAt(const OverlaySignals& signals, std::size_t arrow, float share) {
  const OverlaySignals::Stretch stretch = signals.stretch(arrow);
  const float at = stretch.first + stretch.span * share;
  const auto low = static_cast<std::size_t>(at);
  return std::lerp(signals.levels()[low], signals.levels()[low + 1], at - static_cast<float>(low));
}

TEST(OverlayMarks, LeaveOutHiddenArrowsAndTheirLonePoints) {
  const OverlayMarks marks = marksOf(treeProject());
  ASSERT_EQ(marks.arrows.size(), 1u);
  EXPECT_EQ(marks.arrows[0].place, glm::vec4(-10.0f, 0.0f, 0.0f, 0.0f));
  EXPECT_FLOAT_EQ(marks.arrows[0].look.y, 6.0f) << "m/s";
  EXPECT_EQ(marks.points.size(), 2u);
}

TEST(OverlayMarks, KeepPointsThatHaveNoArrowsYet) {
  const Project project = changed(treeProject(), [](WindGraph& graph) {
    graph.points.push_back({});
    graph.points.back().id = 4;
  });
  EXPECT_EQ(marksOf(project).points.size(), 3u);
}

TEST(OverlayMarks, TellRootsFromOtherPoints) {
  const OverlayMarks marks = marksOf(treeProject());
  EXPECT_EQ(marks.points[0].place.w, MARK_ROOT);
  EXPECT_EQ(marks.points[1].place.w, MARK_POINT);
}

TEST(OverlayMarks, ShowSelectionAndHover) {
  const Id selected[] = {10};
  const OverlayMarks marks = marksOf(treeProject(), {.selected = selected, .hovered = 2});
  EXPECT_EQ(marks.arrows[0].look.w, MARK_SELECTED);
  EXPECT_EQ(marks.points[0].look.w, MARK_NORMAL);
  EXPECT_EQ(marks.points[1].look.w, MARK_HOVERED);
}

TEST(OverlayMarks, PointsAreAsWideAsTheirWidestArrow) {
  const Project project = changed(treeProject(), [](WindGraph& graph) { graph.arrows[0].radius = 5.0f; });
  const OverlayMarks marks = marksOf(project);
  EXPECT_GT(marks.points[1].place.z, shared::arrowHalfWidth(5.0f));
  EXPECT_EQ(marks.arrows[0].more.z, marks.points[1].place.z) << "the arrow ends at the disc's rim";
}

TEST(OverlayMarks, LeaveOutArrowsWithoutBothEnds) {
  const Project project = changed(treeProject(), [](WindGraph& graph) { graph.arrows[0].to = 99; });
  EXPECT_TRUE(marksOf(project).arrows.empty());
}

TEST(OverlaySignals, RunAlongTheArrowAtItsTravelSpeed) {
  const Project project = treeProject();
  const GraphEvaluator evaluator(*project.graph);
  OverlaySignals signals;
  signals.build(*project.graph, GraphLinks(*project.graph), &evaluator);
  const Signal root{};
  for (const double time : {0.0, 0.3, 0.9, 1.4, 5.0}) {
    signals.refresh(time);
    for (const float share : {0.0f, 0.25f, 0.6f, 1.0f}) {
      for (std::size_t arrow = 0; arrow < 2; ++arrow) {
        // 10 m at 10 m/s: a second each.
        const double delay = static_cast<double>(arrow) + static_cast<double>(share);
        EXPECT_NEAR(levelAt(signals, arrow, share), signalAt(root, time - delay), 0.02f)
            << time << " s, arrow " << arrow << " at " << share;
      }
    }
  }
}

TEST(OverlaySignals, AreFullWithoutAnEvaluation) {
  const Project project = treeProject();
  OverlaySignals signals;
  signals.build(*project.graph, GraphLinks(*project.graph), nullptr);
  signals.refresh(0.0);
  EXPECT_EQ(levelAt(signals, 0, 0.5f), 1.0f);
}

TEST(OverlaySignals, SteadyOnesAreNotFilledAgain) {
  const Project project = treeProject();
  const GraphEvaluator evaluator(*project.graph);
  OverlaySignals signals;
  signals.build(*project.graph, GraphLinks(*project.graph), &evaluator);
  EXPECT_TRUE(signals.refresh(0.5));
  EXPECT_TRUE(signals.refresh(20.0)) << "the rise has passed";
  EXPECT_FALSE(signals.refresh(20.1));
  EXPECT_TRUE(signals.refresh(0.5)) << "restarted";
  EXPECT_LT(levelAt(signals, 1, 1.0f), 0.1f);
}

TEST(OverlaySignals, HaveATableOfBoundedLength) {
  const Project project = changed(treeProject(), [](WindGraph& graph) { graph.arrows[0].travelSpeed = 0.001f; });
  const GraphEvaluator evaluator(*project.graph);
  OverlaySignals signals;
  signals.build(*project.graph, GraphLinks(*project.graph), &evaluator);
  EXPECT_LT(signals.levels().size(), 5000u) << "a signal that takes hours to pass";
  signals.refresh(1.0);
  EXPECT_TRUE(std::isfinite(levelAt(signals, 1, 1.0f)));
}

class CachedMarks : public ::testing::Test {
 protected:
  void SetUp() override {
    m_project = treeProject();
    m_evaluator.emplace(*m_project.graph);
    m_input.project = &m_project;
    m_input.graph = &*m_evaluator;
    (void)m_cache.update(m_input);
  }
  Project m_project;
  std::optional<GraphEvaluator> m_evaluator;
  FrameInput m_input;
  MarkCache m_cache;
};

TEST_F(CachedMarks, RestWhileNothingChanges) {
  const MarkCache::Change change = m_cache.update(m_input);
  EXPECT_FALSE(change.marks);
  EXPECT_FALSE(change.levels);
}

TEST_F(CachedMarks, OnlyLevelsFollowTheTime) {
  m_input.time = 0.5;
  const MarkCache::Change change = m_cache.update(m_input);
  EXPECT_FALSE(change.marks);
  EXPECT_TRUE(change.levels);
}

TEST_F(CachedMarks, FollowHighlightAndProject) {
  const Id selected[] = {10};
  m_input.highlight.selected = selected;
  EXPECT_TRUE(m_cache.update(m_input).marks);
  EXPECT_EQ(m_cache.marks().arrows[0].look.w, MARK_SELECTED);
  m_input.highlight.hovered = 1;
  EXPECT_TRUE(m_cache.update(m_input).marks);
  Project moved = changed(m_project, [](WindGraph& graph) { graph.points[1].position.y = 4.0f; });
  m_input.project = &moved;
  EXPECT_TRUE(m_cache.update(m_input).marks);
  EXPECT_EQ(m_cache.marks().arrows[0].place.w, 4.0f);
  moved.probes = std::make_shared<std::vector<Probe>>(1);
  EXPECT_TRUE(m_cache.update(m_input).marks);
  moved.obstacles = std::make_shared<std::vector<Obstacle>>(1);
  EXPECT_TRUE(m_cache.update(m_input).marks);
  moved.grass = std::make_shared<GrassSettings>();
  EXPECT_FALSE(m_cache.update(m_input).marks) << "grass is not in the marks";
}

}  // namespace
}  // namespace windloom
