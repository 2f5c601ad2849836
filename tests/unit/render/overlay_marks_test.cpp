#include "engine/render/overlay_marks.hpp"

#include <gtest/gtest.h>

#include "engine/render/framing.hpp"

namespace windloom {
namespace {

Project treeProject() {
  WindGraph graph;
  graph.points.resize(3);
  for (Id i = 0; i < 3; ++i) {
    graph.points[i].id = i + 1;
    graph.points[i].position = {-10.0f + 10.0f * static_cast<float>(i), i == 2 ? 5.0f : 0.0f};
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

TEST(OverlayMarks, LeaveOutHiddenArrowsAndTheirLonePoints) {
  const OverlayMarks marks = makeOverlayMarks(treeProject(), nullptr, 0.0, 12.0f, {});
  ASSERT_EQ(marks.arrows.size(), 1u);
  EXPECT_EQ(marks.arrows[0].place, glm::vec4(-10.0f, 0.0f, 0.0f, 0.0f));
  EXPECT_FLOAT_EQ(marks.arrows[0].look.y, 0.5f) << "6 of 12 m/s";
  EXPECT_EQ(marks.points.size(), 2u);
}

TEST(OverlayMarks, TellRootsFromOtherPoints) {
  const OverlayMarks marks = makeOverlayMarks(treeProject(), nullptr, 0.0, 12.0f, {});
  EXPECT_EQ(marks.points[0].place.w, MARK_ROOT);
  EXPECT_EQ(marks.points[1].place.w, MARK_POINT);
}

TEST(OverlayMarks, ShowSelectionAndHover) {
  const Id selected[] = {10};
  const OverlayMarks marks = makeOverlayMarks(treeProject(), nullptr, 0.0, 12.0f, {.selected = selected, .hovered = 2});
  EXPECT_EQ(marks.arrows[0].look.w, MARK_SELECTED);
  EXPECT_EQ(marks.points[0].look.w, MARK_NORMAL);
  EXPECT_EQ(marks.points[1].look.w, MARK_HOVERED);
}

TEST(OverlayMarks, FollowTheSignal) {
  const Project project = treeProject();
  const GraphEvaluator graph(*project.graph);
  EXPECT_FLOAT_EQ(makeOverlayMarks(project, &graph, 0.0, 12.0f, {}).arrows[0].look.z, 0.0f);
  EXPECT_FLOAT_EQ(makeOverlayMarks(project, &graph, 10.0, 12.0f, {}).arrows[0].look.z, 1.0f);
}

TEST(VectorLattice, HasAboutFortyNodesAcrossAndStandsStill) {
  const FieldSettings field;
  ViewCamera camera = frameFieldFromAbove(field);
  const VectorLattice lattice = makeVectorLattice(camera, {1280, 720}, field);
  EXPECT_GE(lattice.nodes.x, 24);
  EXPECT_LE(lattice.nodes.x, 64);
  camera.position.x += 1.7f;
  camera.target.x += 1.7f;
  const VectorLattice moved = makeVectorLattice(camera, {1280, 720}, field);
  EXPECT_EQ(moved.spacing, lattice.spacing);
  const float steps = (moved.first.x - lattice.first.x) / lattice.spacing;
  EXPECT_EQ(steps, std::round(steps)) << "nodes stay on the same places of the world";
}

TEST(VectorLattice, IsEmptyWhereTheFieldIsOutOfSight) {
  ViewCamera camera;
  camera.position = {500.0f, 20.0f, 500.0f};
  camera.target = {600.0f, 0.0f, 600.0f};
  const VectorLattice lattice = makeVectorLattice(camera, {1280, 720}, {});
  EXPECT_EQ(lattice.nodes.x * lattice.nodes.y, 0);
}

}  // namespace
}  // namespace windloom
