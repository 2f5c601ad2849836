// The gizmo of the move, rotate and scale tools, snapping of moves, and merging what was put together.
#include "editor/core/project_cameras.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

/// An arrow from (-10, 0) to (10, 0), selected; its middle is the gizmo's place. Arms are 7 m long.
const Arrow& prepare(Bench& b, const char* tool) {
  const Id id = b.draw({-10, 0}, {10, 0});
  b.key(tool);
  b.w.selection.replace(id);
  return b.arrow(id);
}

TEST(Gizmo, TheArmOfTheMoveToolLocksItsAxis) {
  Bench b;
  const Arrow arrow = prepare(b, "W");
  b.drag({0, 5}, {6, 12});
  expectNear(b.place(arrow.from), {-10, 7}, 0.02f);
  expectNear(b.place(arrow.to), {10, 7}, 0.02f);
}

TEST(Gizmo, TheCentreOfTheMoveToolMovesFreely) {
  Bench b;
  const Arrow arrow = prepare(b, "W");
  b.drag({0, 0}, {6, 12});
  expectNear(b.place(arrow.from), {-4, 12}, 0.02f);
}

TEST(Gizmo, TheRingTurns) {
  Bench b;
  const Arrow arrow = prepare(b, "E");
  b.drag({0, 7}, {-7, 0});
  expectNear(b.place(arrow.to), {0, 10}, 0.1f);
}

TEST(Gizmo, TheSquareEndOfTheScaleToolLocksItsAxis) {
  Bench b;
  const Arrow arrow = prepare(b, "R");
  const Id point = b.graph().points.back().id;
  b.drag({7, 0}, {14, 9});
  expectNear(b.place(arrow.to), {20, 0}, 0.1f);
  EXPECT_NEAR(b.place(point).y, 0.0f, 1e-4f);
}

TEST(Gizmo, IsHighlightedBeforeTheClick) {
  Bench b;
  prepare(b, "W");
  b.hover({0, 5});
  bool hot = false;
  for (const auto& grip : b.w.tools.shapes(b.w.context()).grips) hot = hot || (grip.hot && grip.name == "grip:z");
  EXPECT_TRUE(hot);
  EXPECT_EQ(b.w.tools.hovered(), 0u) << "no object is meant";
  b.hover({30, 30});
  for (const auto& grip : b.w.tools.shapes(b.w.context()).grips) EXPECT_FALSE(grip.hot);
}

TEST(Gizmo, KeepsItsSizeOnTheScreen) {
  Bench b;
  prepare(b, "W");
  for (const float zoom : {1.0f, 0.1f}) {
    b.w.camera.distance *= zoom;
    const PreviewShapes shapes = b.w.tools.shapes(b.w.context());
    const glm::vec2 middle = b.pixel({0, 0});
    for (const auto& grip : shapes.grips) {
      if (grip.name == "grip:x") {
        EXPECT_NEAR(glm::distance(*b.w.view().toScreen(grip.at), middle), 70.0f, 0.5f);
      }
    }
    EXPECT_EQ(shapes.grips.size(), 3u);
  }
}

TEST(Gizmo, GivesWayToAPointThatIsNotSelected) {
  Bench b;
  prepare(b, "W");
  Point other;
  other.id = 900;
  other.position = {0, 5};
  b.w.apply(Edit{"Add", {Put<Point>{other}}, ""});
  b.drag({0, 5}, {6, 12});
  expectNear(b.place(900), {6, 12}, 0.02f);
}

TEST(Snapping, AMovedPointSnapsToAnotherAndCtrlJMergesThem) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.draw({20, 20}, {20, 5});
  const Id moved = b.arrow(b.w.selection.active()).to;
  b.key("Q");
  b.drag({20, 5}, {0.4f, 0.3f});
  const Id target = b.arrow(b.graph().arrows[0].id).to;
  expectNear(b.place(moved), b.place(target), 1e-4f);
  EXPECT_EQ(b.graph().points.size(), 4u) << "nothing merges by itself";
  b.key("Ctrl+J");
  EXPECT_EQ(b.graph().points.size(), 3u);
  EXPECT_EQ(b.graph().arrows[0].to, b.graph().arrows[1].to);
}

TEST(Snapping, WithoutSnapToPointsAMoveStopsWhereThePointerDoes) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.draw({20, 20}, {20, 5});
  b.w.toolSettings.snap.points = false;
  b.key("Q");
  b.drag({20, 5}, {0.4f, 0.3f});
  expectNear(b.place(b.graph().arrows[1].to), {0.4f, 0.3f}, 0.02f);
}

TEST(Snapping, AMoveKeepsToAnglesWhereTheyAreOn) {
  Bench b;
  const Id id = b.draw({-20, 0}, {0, 0});
  b.w.toolSettings.snap.angle = true;
  b.w.toolSettings.snap.angleDeg = 45;
  b.key("Q");
  b.drag({0, 0}, {10, 9});
  const glm::vec2 end = b.place(b.arrow(id).to);
  EXPECT_NEAR(end.x, end.y, 0.01f);
}

TEST(Cameras, AProjectOpensWithItsHero) {
  Bench b;
  Project project;
  Camera first, hero;
  first.id = 1;
  first.name = "side";
  hero.id = 2;
  hero.name = "hero";
  hero.position = {10, 12, 30};
  hero.target = {1, 2, 3};
  hero.fieldOfView = 35;
  project.cameras = std::make_shared<std::vector<Camera>>(std::vector{first, hero});
  b.w.flow.requestNew(project);
  EXPECT_EQ(b.w.lookedThrough(), 2u);
  EXPECT_NEAR(glm::distance(b.w.camera.position(), hero.position), 0.0f, 1e-3f);
  EXPECT_NEAR(glm::distance(b.w.camera.target, hero.target), 0.0f, 1e-3f);
  EXPECT_EQ(b.w.camera.fieldOfView, 35.0f);
  EXPECT_TRUE(b.w.actions.run("view.camera_next"));
  EXPECT_EQ(b.w.lookedThrough(), 1u);
  EXPECT_EQ(b.steps(), 0u) << "looking is no edit";
}

TEST(Cameras, TheViewIsStoredAsACameraAndUndone) {
  Bench b;
  b.w.camera = EditorCamera{{3, 0, -4}, 40, 25, 60, 50, false};
  const glm::vec3 eye = b.w.camera.position();
  EXPECT_TRUE(b.w.actions.run("view.camera_store"));
  ASSERT_EQ(b.project().cameras->size(), 1u);
  const Camera stored = b.project().cameras->front();
  EXPECT_EQ(stored.name, "camera 1");
  EXPECT_NEAR(glm::distance(stored.position, eye), 0.0f, 1e-3f);
  EXPECT_NEAR(glm::distance(lookThrough({}, stored).position(), eye), 0.0f, 1e-3f);
  b.w.actions.run("view.camera_store");
  EXPECT_EQ(b.project().cameras->back().name, "camera 2");
  b.key("Ctrl+Z");
  b.key("Ctrl+Z");
  EXPECT_TRUE(b.project().cameras->empty());
}

}  // namespace
}  // namespace windloom::editor
