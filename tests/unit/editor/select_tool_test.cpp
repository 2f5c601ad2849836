#include "editor/core/graph_edits.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

/// Two separate arrows, a circle and a probe; the select tool.
struct Scene : Bench {
  Id a = 0, b = 0, obstacle = 0, probe = 0;
  Scene() {
    a = draw({-30, 0}, {-10, 0});
    b = draw({-30, 20}, {-10, 20});
    Obstacle circle;
    circle.centre = {20, 0};
    circle.radius = 5.0f;
    AddResult added = addObstacleEdit(project(), circle);
    w.apply(added.edit);
    obstacle = added.id;
    Probe watch;
    watch.position = {20, 20};
    added = addProbeEdit(project(), watch);
    w.apply(added.edit);
    probe = added.id;
    w.selection.clear();
    key("Q");
  }
  [[nodiscard]] Id from(Id id) const { return arrow(id).from; }
  [[nodiscard]] Id to(Id id) const { return arrow(id).to; }
};

}  // namespace

TEST(SelectTool, ClickReplacesShiftAddsCtrlToggles) {
  Scene s;
  s.click({-30, 0});
  EXPECT_EQ(s.w.selection.active(), s.from(s.a));
  s.click({20, 20}, kShift);
  EXPECT_EQ(s.w.selection.size(), 2u);
  EXPECT_EQ(s.w.selection.active(), s.probe);
  s.click({-30, 0}, kCtrl);
  EXPECT_EQ(s.w.selection.size(), 1u);
  s.click({25, 0});
  EXPECT_EQ(s.w.selection.active(), s.obstacle);
  s.click({40, 40}, kShift);
  EXPECT_EQ(s.w.selection.size(), 1u);
  s.click({40, 40});
  EXPECT_TRUE(s.w.selection.empty());
}

TEST(SelectTool, CtrlShiftTogglesAnArrow) {
  Scene s;
  s.click({-20, 0});
  EXPECT_EQ(s.w.selection.active(), s.a);
  s.click({-20, 20}, {true, true, false});
  EXPECT_TRUE(s.w.selection.contains(s.b));
  s.click({-20, 20}, {true, true, false});
  EXPECT_FALSE(s.w.selection.contains(s.b));
  EXPECT_EQ(s.graph().arrows.size(), 2u);
}

TEST(SelectTool, CtrlClickOnAnArrowInsertsAPoint) {
  Scene s;
  s.w.undo();
  s.w.redo();
  const Id end = s.to(s.a);
  s.click({-16, 0}, kCtrl);
  ASSERT_EQ(s.graph().arrows.size(), 3u);
  const Id fresh = s.w.selection.active();
  expectNear(s.place(fresh), {-16, 0}, 0.02f);
  EXPECT_EQ(s.to(s.a), fresh);
  EXPECT_EQ(s.graph().arrows.back().from, fresh);
  EXPECT_EQ(s.graph().arrows.back().to, end);
}

TEST(SelectTool, RepeatedClicksGoThroughWhatOverlaps) {
  Scene s;
  Probe probe;
  probe.position = {-10, 0.3f};
  const AddResult added = addProbeEdit(s.project(), probe);
  s.w.apply(added.edit);
  s.click({-10, 0});
  EXPECT_EQ(s.w.selection.active(), s.to(s.a));
  s.click({-10, 0});
  EXPECT_EQ(s.w.selection.active(), added.id);
  s.click({-10, 0});
  EXPECT_EQ(s.w.selection.active(), s.a);
  s.click({-10, 0});
  EXPECT_EQ(s.w.selection.active(), s.to(s.a));
}

TEST(SelectTool, HoverIsKnownBeforeTheClick) {
  Scene s;
  s.hover({-30.5f, 0});
  EXPECT_EQ(s.w.tools.hovered(), s.from(s.a));
  s.hover({0, 40});
  EXPECT_EQ(s.w.tools.hovered(), 0u);
}

TEST(SelectTool, DragMovesAPointAsOneStep) {
  Scene s;
  const std::size_t before = s.steps();
  const Id tip = s.to(s.a);
  s.drag({-10, 0}, {-5, 8});
  expectNear(s.place(tip), {-5, 8});
  expectNear(s.place(s.from(s.a)), {-30, 0});
  EXPECT_EQ(s.steps(), before + 1);
  EXPECT_EQ(s.w.selection.active(), tip);
  EXPECT_TRUE(s.key("Ctrl+Z"));
  expectNear(s.place(tip), {-10, 0});
  EXPECT_TRUE(s.key("Ctrl+Shift+Z"));
  expectNear(s.place(tip), {-5, 8});
}

TEST(SelectTool, DragShowsTheMovedProjectBeforeTheRelease) {
  Scene s;
  const Id tip = s.to(s.a);
  const auto revision = s.w.document.revision();
  s.press({-10, 0});
  s.move({-5, 0});
  expectNear(s.place(tip), {-5, 0});
  EXPECT_GT(s.w.document.revision(), revision);
  s.move({0, 0});
  expectNear(s.place(tip), {0, 0});
  expectNear(findPoint(*s.w.document.committed().graph, tip)->position, {-10, 0});
}

TEST(SelectTool, DragOfOneSelectedMovesAllSelected) {
  Scene s;
  s.click({-30, 0});
  s.click({20, 20}, kShift);
  s.click({25, 0}, kShift);
  s.drag({20, 20}, {22, 21});
  expectNear(s.place(s.from(s.a)), {-28, 1});
  expectNear((*s.project().obstacles)[0].centre, {22, 1});
  expectNear((*s.project().probes)[0].position, {22, 21});
  expectNear(s.place(s.to(s.a)), {-10, 0});
}

TEST(SelectTool, DragOfAnArrowMovesBothItsEnds) {
  Scene s;
  s.drag({-20, 0}, {-20, 5});
  expectNear(s.place(s.from(s.a)), {-30, 5});
  expectNear(s.place(s.to(s.a)), {-10, 5});
}

TEST(SelectTool, DragInsideAnObstacleMovesIt) {
  Scene s;
  s.drag({21, 1}, {31, -4});
  expectNear((*s.project().obstacles)[0].centre, {30, -5});
}

TEST(SelectTool, AxisLockKeepsTheOtherCoordinate) {
  Scene s;
  const Id tip = s.to(s.a);
  s.press({-10, 0});
  s.move({-5, 8});
  EXPECT_TRUE(s.key("X"));
  expectNear(s.place(tip), {-5, 0});
  EXPECT_TRUE(s.key("Z"));
  expectNear(s.place(tip), {-10, 8});
  EXPECT_TRUE(s.key("Z"));
  expectNear(s.place(tip), {-5, 8});
  s.key("X");
  s.release({-4, 8});
  expectNear(s.place(tip), {-4, 0});
  EXPECT_EQ(s.graph().points.size(), 4u);  // X deleted nothing
}

TEST(SelectTool, TypedNumberAndEnterMoveExactly) {
  Scene s;
  const Id tip = s.to(s.a);
  s.press({-10, 0});
  s.move({-7, 1});
  s.key("X");
  s.type("12.5");
  EXPECT_FLOAT_EQ(s.place(tip).x, 2.5f);
  s.key("-");
  EXPECT_FLOAT_EQ(s.place(tip).x, -22.5f);
  s.key("Backspace");
  s.key("Backspace");
  s.key("Enter");
  EXPECT_FALSE(s.w.tools.busy());
  expectNear(s.place(tip), {-22, 0}, 1e-5f);
  s.release({-7, 1});
  expectNear(s.place(tip), {-22, 0}, 1e-5f);
}

TEST(SelectTool, TypedNumberWithoutLockGoesTheWayOfThePointer) {
  Scene s;
  const Id tip = s.to(s.a);
  s.press({-10, 0});
  s.move({-7, 4});
  s.type("10");
  s.key("Numpad Enter");
  expectNear(s.place(tip), {-4, 8}, 0.01f);
}

TEST(SelectTool, CancelGivesBackTheSameProject) {
  for (const bool right : {false, true}) {
    Scene s;
    const Project before = s.w.document.committed();
    s.press({-10, 0});
    s.move({5, 5});
    if (right) {
      s.rightClick({5, 5});
    } else {
      s.key("Esc");
    }
    EXPECT_TRUE(s.project().sameAs(before));
    EXPECT_FALSE(s.w.selection.empty());  // Esc ended the drag, not the selection
    s.release({5, 5});
    EXPECT_TRUE(s.project().sameAs(before));
  }
}

TEST(SelectTool, MoveThatWouldMakeAnArrowOfNoLengthIsRefused) {
  Scene s;
  s.w.toolSettings.snap.grid = true;
  s.w.toolSettings.snap.gridM = 10.0f;
  const Project before = s.w.document.committed();
  s.drag({-10, 0}, {-30, 0.2f});
  EXPECT_TRUE(s.project().sameAs(before));
  EXPECT_NE(s.w.message().text.find("length"), std::string::npos) << s.w.message().text;
}

TEST(SelectTool, CtrlWhileDraggingSnapsToTheGrid) {
  Scene s;
  const Id tip = s.to(s.a);
  s.press({-10, 0});
  s.move({-5.3f, 8.4f}, kCtrl);
  s.release({-5.3f, 8.4f}, kCtrl);
  EXPECT_EQ(s.place(tip), glm::vec2(-5.0f, 8.0f));
}

TEST(SelectTool, BoxSelectsWhatLiesInside) {
  Scene s;
  s.drag({-35, -5}, {-5, 5});
  EXPECT_EQ(s.w.selection.size(), 3u);
  EXPECT_TRUE(s.w.selection.contains(s.a));
  s.drag({-12, 15}, {30, 30}, kShift);  // the tip of b and the probe
  EXPECT_EQ(s.w.selection.size(), 5u);
  EXPECT_FALSE(s.w.selection.contains(s.b));
  s.drag({-35, -5}, {-5, 25}, kCtrl);
  EXPECT_FALSE(s.w.selection.contains(s.a));
  EXPECT_TRUE(s.w.selection.contains(s.b));
  EXPECT_TRUE(s.w.selection.contains(s.probe));
  s.drag({35, 35}, {45, 45});
  EXPECT_TRUE(s.w.selection.empty());
}

TEST(SelectTool, CancelledBoxGivesTheOldSelectionBack) {
  Scene s;
  s.click({20, 20});
  s.press({-35, -5});
  s.move({-5, 25});
  EXPECT_EQ(s.w.selection.size(), 6u);
  s.key("Esc");
  EXPECT_EQ(s.w.selection.size(), 1u);
  EXPECT_EQ(s.w.selection.active(), s.probe);
}

TEST(SelectTool, HiddenAndLockedThingsAreNotPicked) {
  Scene s;
  s.w.apply(flagEdit(s.project(), std::vector<Id>{s.a}, Flag::Hidden, true));
  s.w.apply(flagEdit(s.project(), std::vector<Id>{s.obstacle}, Flag::Locked, true));
  for (const glm::vec2 place : {glm::vec2(-20, 0), glm::vec2(-30, 0), glm::vec2(20, 0)}) {
    s.click(place);
    EXPECT_TRUE(s.w.selection.empty());
  }
  s.drag({-45, -45}, {45, 45});
  EXPECT_EQ(s.w.selection.size(), 4u);  // b with its ends, and the probe
}

TEST(SelectTool, AltDragMovesCopies) {
  Scene s;
  s.click({-20, 0});
  s.drag({-20, 0}, {-20, -10}, kAlt);
  EXPECT_FALSE(s.w.navigator.active());
  ASSERT_EQ(s.graph().arrows.size(), 3u);
  const Arrow& copy = s.graph().arrows.back();
  expectNear(s.place(copy.from), {-30, -10});
  expectNear(s.place(s.from(s.a)), {-30, 0});
  EXPECT_EQ(s.w.selection.active(), copy.id);
}

TEST(SelectTool, AltDragOnEmptyGroundOrbits) {
  Scene s;
  const float yaw = s.w.camera.yaw;
  const Project before = s.w.document.committed();
  s.drag({0, -40}, {10, -40}, kAlt);
  EXPECT_NE(s.w.camera.yaw, yaw);
  EXPECT_TRUE(s.project().sameAs(before));
  EXPECT_TRUE(s.w.selection.empty());
}

TEST(TransformTools, RotateTurnsAroundTheMiddle) {
  Scene s;
  s.click({-20, 0});
  s.key("E");
  s.drag({-10, 0}, {-20, 10});  // a quarter turn from +X towards +Z around (-20, 0)
  expectNear(s.place(s.to(s.a)), {-20, 10}, 0.01f);
  expectNear(s.place(s.from(s.a)), {-20, -10}, 0.01f);
}

TEST(TransformTools, TypedAngleIsExact) {
  Scene s;
  s.click({-20, 0});
  s.key("E");
  s.press({0, -40});  // on empty ground: the selection turns all the same
  s.move({5, -40});
  s.type("180");
  s.key("Enter");
  expectNear(s.place(s.to(s.a)), {-30, 0}, 1e-4f);
}

TEST(TransformTools, ScaleChangesDistancesAndCircles) {
  Scene s;
  s.click({25, 0});
  s.key("R");
  s.drag({20, -20}, {20, -40});  // away from the gizmo, whose ends lock the axis
  EXPECT_NEAR((*s.project().obstacles)[0].radius, 10.0f, 0.01f);
  expectNear((*s.project().obstacles)[0].centre, {20, 0});
}

TEST(TransformTools, MoveToolMovesTheSelectionFromAnywhere) {
  Scene s;
  s.click({20, 20});
  s.key("W");
  s.drag({0, -40}, {3, -44});
  expectNear((*s.project().probes)[0].position, {23, 16});
}

}  // namespace windloom::editor
