#include "editor_bench.hpp"

namespace windloom::editor {

TEST(DrawTool, DragMakesRootEndAndArrow) {
  Bench b;
  b.w.toolSettings.newArrow.radius = 3.0f;
  b.w.toolSettings.newArrow.strength = 9.0f;
  b.key("D");
  b.drag({-20, 5}, {10, -4});
  ASSERT_EQ(b.graph().points.size(), 2u);
  ASSERT_EQ(b.graph().arrows.size(), 1u);
  const Arrow& arrow = b.graph().arrows[0];
  expectNear(b.place(arrow.from), {-20, 5});
  expectNear(b.place(arrow.to), {10, -4});
  EXPECT_FLOAT_EQ(arrow.radius, 3.0f);
  EXPECT_FLOAT_EQ(arrow.strength, 9.0f);
  EXPECT_EQ(b.w.selection.active(), arrow.id);
  EXPECT_EQ(b.steps(), 1u);
  EXPECT_TRUE(b.w.document.dirty());
}

TEST(DrawTool, StartNearAPointBranchesFromIt) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  const Id tip = b.arrow(first).to;
  const Id second = b.draw({0.8f, 0}, {15, 10});  // 8 pixels beside the tip
  EXPECT_EQ(b.arrow(second).from, tip);
  EXPECT_EQ(b.graph().points.size(), 3u);
}

TEST(DrawTool, StartFartherThanTenPixelsFromAPointMakesARoot) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.draw({1.2f, 0}, {15, 10});
  EXPECT_EQ(b.graph().points.size(), 4u);
}

TEST(DrawTool, ReleaseOnAPointJoinsIt) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  const Id second = b.draw({-20, 20}, {0.5f, 0.2f});
  EXPECT_EQ(b.arrow(second).to, b.arrow(first).to);
  EXPECT_EQ(b.graph().points.size(), 3u);
  expectNear(b.place(b.arrow(first).to), {0, 0});
}

TEST(DrawTool, DragBetweenTwoPointsConnectsThem) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  const Id second = b.draw({-20, 20}, {0, 20});
  const Id link = b.draw({0, 0}, {0, 20});
  EXPECT_EQ(b.arrow(link).from, b.arrow(first).to);
  EXPECT_EQ(b.arrow(link).to, b.arrow(second).to);
  EXPECT_EQ(b.graph().points.size(), 4u);
  // Back to the root: a ring.
  const Id ring = b.draw({0, 0}, {-20, 0});
  EXPECT_EQ(b.arrow(ring).to, b.arrow(first).from);
}

TEST(DrawTool, SecondArrowBetweenTheSamePointsIsRefusedWithAMessage) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.drag({-20, 0}, {0, 0});
  EXPECT_EQ(b.graph().arrows.size(), 1u);
  EXPECT_EQ(b.steps(), 1u);
  EXPECT_EQ(b.w.message().text.find("The arrow joins points"), 0u) << b.w.message().text;
}

TEST(DrawTool, ClicksChainUntilEnter) {
  Bench b;
  b.key("D");
  b.click({-30, 0});
  EXPECT_TRUE(b.graph().points.empty());
  b.click({-10, 5});
  b.click({10, 0});
  EXPECT_TRUE(b.key("Enter"));
  EXPECT_FALSE(b.w.tools.busy());
  ASSERT_EQ(b.graph().arrows.size(), 2u);
  EXPECT_EQ(b.graph().arrows[0].to, b.graph().arrows[1].from);
  EXPECT_EQ(b.graph().points.size(), 3u);
  EXPECT_EQ(b.steps(), 2u);
  b.click({30, 30});  // a new chain begins, nothing joins the old one
  b.click({35, 30});
  EXPECT_EQ(b.graph().points.size(), 5u);
}

TEST(DrawTool, RightClickAndEscapeEndAChain) {
  for (const bool escape : {false, true}) {
    Bench b;
    b.key("D");
    b.click({-30, 0});
    b.click({-10, 5});
    if (escape) {
      b.key("Esc");
    } else {
      b.rightClick({0, 0});
    }
    EXPECT_FALSE(b.w.tools.busy());
    EXPECT_FALSE(b.w.navigator.active());
    EXPECT_EQ(b.graph().arrows.size(), 1u);
    EXPECT_EQ(b.w.tools.active().id(), "draw");
  }
}

TEST(DrawTool, ChainOntoAPointJoinsAndEnds) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  b.click({-20, 20});
  b.click({0, 0});
  EXPECT_FALSE(b.w.tools.busy());
  EXPECT_EQ(b.graph().arrows.back().to, b.arrow(first).to);
}

TEST(DrawTool, ClickTwiceAtOnePlaceMakesNothing) {
  Bench b;
  b.key("D");
  b.click({5, 5});
  b.click({5, 5});
  b.key("Enter");
  EXPECT_TRUE(b.graph().points.empty());
  EXPECT_TRUE(b.w.message().text.empty());
  EXPECT_FALSE(b.w.document.dirty());
}

TEST(DrawTool, DragBackToTheStartMakesNothing) {
  Bench b;
  b.key("D");
  b.press({5, 5});
  b.move({10, 5});
  b.move({5, 5});
  b.release({5, 5});
  EXPECT_TRUE(b.graph().points.empty());
  EXPECT_FALSE(b.w.document.previewing());
}

TEST(DrawTool, UndoDuringAChainTakesThePointThatItGoesOnFrom) {
  Bench b;
  b.key("D");
  b.click({-30, 0});
  b.click({-10, 5});
  b.w.undo();
  EXPECT_TRUE(b.graph().arrows.empty());
  b.click({0, 0});
  b.click({10, 0});
  ASSERT_EQ(b.graph().arrows.size(), 1u);
  expectNear(b.place(b.graph().arrows[0].from), {0, 0});
}

TEST(DrawTool, WheelChangesRadiusAndStrengthWhileDrawing) {
  Bench b;
  b.key("D");
  const float radius = b.w.toolSettings.newArrow.radius, strength = b.w.toolSettings.newArrow.strength;
  b.press({-20, 0});
  b.move({0, 0});
  const float distance = b.w.camera.distance;
  b.w.wheel(2.0f, b.at({0, 0}));
  b.w.wheel(-1.0f, b.at({0, 0}, kShift));
  b.release({0, 0});
  EXPECT_FLOAT_EQ(b.w.camera.distance, distance);
  ASSERT_EQ(b.graph().arrows.size(), 1u);
  EXPECT_NEAR(b.graph().arrows[0].radius, radius * 1.21f, 1e-4f);
  EXPECT_NEAR(b.graph().arrows[0].strength, strength / 1.1f, 1e-4f);
  b.w.wheel(1.0f, b.at({0, 0}));  // not drawing: zooms
  EXPECT_LT(b.w.camera.distance, distance);
}

TEST(DrawTool, PreviewIsLiveAndCancelLeavesNothing) {
  for (const int how : {0, 1, 2, 3}) {
    Bench b;
    const Project before = b.w.document.project();
    b.key("D");
    b.press({-20, 0});
    b.move({0, 0});
    b.move({10, 0});
    ASSERT_EQ(b.graph().arrows.size(), 1u);
    EXPECT_TRUE(b.w.document.committed().graph->arrows.empty());
    if (how == 0) b.key("Esc");
    if (how == 1) b.rightClick({10, 0});
    if (how == 2) b.w.focusLost();
    if (how == 3) b.w.activateTool("select");
    EXPECT_TRUE(b.project().sameAs(before)) << how;
    b.release({10, 0});
    EXPECT_TRUE(b.project().sameAs(before)) << how;
    EXPECT_EQ(b.steps(), 0u);
    EXPECT_FALSE(b.w.document.dirty());
  }
}

TEST(DrawTool, SnapsToGridAndAngle) {
  Bench b;
  b.w.toolSettings.snap.grid = true;
  b.w.toolSettings.snap.gridM = 5.0f;
  const Id first = b.draw({-19, 1}, {11, 8});
  expectNear(b.place(b.arrow(first).from), {-20, 0});
  expectNear(b.place(b.arrow(first).to), {10, 10});
  b.w.toolSettings.snap.grid = false;
  b.w.toolSettings.snap.angle = true;
  b.w.toolSettings.snap.angleDeg = 45.0f;
  const Id second = b.draw({20, -30}, {30, -29});
  expectNear(b.place(b.arrow(second).to), {20.0f + std::sqrt(101.0f), -30.0f}, 5e-3f);
}

TEST(DrawTool, WorksInAPerspectiveView) {
  Bench b;
  b.w.camera = EditorCamera{};
  const Id arrow = b.draw({-20, 5}, {12, -8});
  expectNear(b.place(b.arrow(arrow).from), {-20, 5}, 0.02f);
  expectNear(b.place(b.arrow(arrow).to), {12, -8}, 0.02f);
}

TEST(DrawTool, PressIntoTheSkyDrawsNothing) {
  Bench b;
  b.w.camera = EditorCamera{};
  b.w.camera.pitch = 5.0f;
  b.key("D");
  PointerEvent sky;
  sky.pixel = {500, 5};
  b.w.pointerPressed(sky);
  sky.pixel = {600, 5};
  b.w.pointerMoved(sky);
  b.w.pointerReleased(sky);
  EXPECT_TRUE(b.graph().points.empty());
}

}  // namespace windloom::editor
