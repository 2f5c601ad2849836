// Polygon obstacles under the hands: drawing, corners, and the handles of all outlines.
#include "editor/core/inspector.hpp"
#include "editor_bench.hpp"
#include "engine/model/outline.hpp"

namespace windloom::editor {
namespace {

/// A polygon by clicks, closed with Enter and selected.
const Obstacle& drawPolygon(Bench& b, std::initializer_list<glm::vec2> corners) {
  b.key("O");
  for (const glm::vec2 corner : corners) b.click(corner);
  b.key("Enter");
  EXPECT_EQ(b.project().obstacles->size(), 1u);
  return b.project().obstacles->front();
}

Id add(Bench& b, ObstacleShape shape) {
  Obstacle obstacle;
  obstacle.id = 1;
  obstacle.shape = shape;
  obstacle.centre = {10, 10};
  obstacle.radius = 5;
  obstacle.size = {8, 6};
  Edit edit{"Add", {Put<Obstacle>{obstacle}}, ""};
  EXPECT_TRUE(b.w.apply(edit));
  b.w.selection.replace(1);
  b.key("Q");
  return 1;
}

const Obstacle& only(const Bench& b) {
  return b.project().obstacles->front();
}

TEST(PolygonTool, ClicksAndEnterMakeAPolygon) {
  Bench b;
  const Obstacle& made = drawPolygon(b, {{0, 0}, {10, 0}, {10, 8}, {0, 8}});
  EXPECT_EQ(made.shape, ObstacleShape::Polygon);
  ASSERT_EQ(made.points.size(), 4u);
  expectNear(made.centre, {5, 4}, 0.05f);
  expectNear(toWorld(made, made.points[2]), {10, 8}, 0.05f);
  EXPECT_EQ(b.steps(), 1u) << "one undo step";
  EXPECT_EQ(b.w.selection.active(), made.id);
  EXPECT_FALSE(b.w.tools.busy());
}

TEST(PolygonTool, RightClickAndTheFirstCornerCloseToo) {
  for (const bool right : {true, false}) {
    Bench b;
    b.key("O");
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(10, 0), glm::vec2(5, 8)}) b.click(corner);
    if (right) {
      b.rightClick({20, 20});
    } else {
      b.click({0.3f, 0.2f});
    }
    ASSERT_EQ(b.project().obstacles->size(), 1u);
    EXPECT_EQ(only(b).points.size(), 3u);
  }
}

TEST(PolygonTool, EscGivesItUpAndBackspaceTakesACornerBack) {
  Bench b;
  b.key("O");
  b.click({0, 0});
  b.click({10, 0});
  b.key("Esc");
  EXPECT_FALSE(b.w.tools.busy());
  EXPECT_TRUE(b.project().obstacles->empty());
  for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(10, 0), glm::vec2(10, 10), glm::vec2(30, 30)})
    b.click(corner);
  b.key("Backspace");
  b.click({0, 10});
  b.key("Enter");
  ASSERT_EQ(only(b).points.size(), 4u);
  EXPECT_LT(reachOf(only(b)), 8.0f);
}

TEST(PolygonTool, RefusesSidesThatCross) {
  Bench b;
  b.key("O");
  for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(10, 10), glm::vec2(10, 0), glm::vec2(0, 10)})
    b.click(corner);
  b.key("Enter");
  EXPECT_TRUE(b.project().obstacles->empty());
  EXPECT_NE(b.w.message().text.find("cross"), std::string::npos) << b.w.message().text;
}

TEST(PolygonTool, TwoCornersAreTooFew) {
  Bench b;
  b.key("O");
  b.click({0, 0});
  b.click({10, 0});
  b.key("Enter");
  EXPECT_TRUE(b.project().obstacles->empty());
  EXPECT_NE(b.w.message().text.find("three"), std::string::npos);
}

TEST(PolygonTool, TheMiddleButtonTurnsTheViewBetweenClicks) {
  Bench b;
  b.key("O");
  b.click({0, 0});
  PointerEvent middle = b.at({5, 5});
  middle.button = PointerButton::Middle;
  b.w.pointerPressed(middle);
  EXPECT_TRUE(b.w.navigator.active());
  b.w.pointerReleased(middle);
  EXPECT_TRUE(b.w.tools.busy());
}

TEST(PolygonCorners, ADragMovesOneAndEscPutsItBack) {
  Bench b;
  drawPolygon(b, {{0, 0}, {10, 0}, {10, 8}, {0, 8}});
  b.key("Q");
  b.drag({10, 8}, {14, 12});
  expectNear(toWorld(only(b), only(b).points[2]), {14, 12}, 0.06f);
  expectNear(toWorld(only(b), only(b).points[0]), {0, 0}, 0.06f);
  EXPECT_EQ(b.steps(), 2u);
  b.press({14, 12});
  b.move({20, 20});
  b.key("Esc");
  b.release({20, 20});
  expectNear(toWorld(only(b), only(b).points[2]), {14, 12}, 0.06f);
  EXPECT_EQ(b.steps(), 2u);
}

TEST(PolygonCorners, CtrlClickOnASideInsertsOne) {
  Bench b;
  drawPolygon(b, {{0, 0}, {10, 0}, {10, 8}, {0, 8}});
  b.key("Q");
  b.click({5, 0}, kCtrl);
  ASSERT_EQ(only(b).points.size(), 5u);
  expectNear(toWorld(only(b), only(b).points[1]), {5, 0}, 0.1f);
  EXPECT_EQ(b.w.selection.active(), only(b).id);
}

TEST(PolygonCorners, DelTakesTheHoveredOrClickedOneOut) {
  Bench b;
  drawPolygon(b, {{0, 0}, {10, 0}, {12, 4}, {10, 8}, {0, 8}});
  b.key("Q");
  b.hover({12, 4});
  b.key("Del");
  EXPECT_EQ(only(b).points.size(), 4u);
  b.click({10, 8});
  b.hover({30, 30});
  b.key("X");
  EXPECT_EQ(only(b).points.size(), 3u);
  b.hover({0, 0});
  b.key("Del");
  EXPECT_EQ(only(b).points.size(), 3u) << "three stay, with a message";
  EXPECT_EQ(b.w.message().kind, MessageKind::Warning);
  b.hover({30, 30});
  b.key("Del");
  EXPECT_TRUE(b.project().obstacles->empty()) << "elsewhere Del deletes the obstacle";
}

TEST(PolygonCorners, DelAfterUndoDoesNotTakeAnotherCorner) {
  Bench b;
  drawPolygon(b, {{0, 0}, {10, 0}, {10, 8}, {0, 8}});
  b.key("Q");
  b.click({5, 0}, kCtrl);
  ASSERT_EQ(only(b).points.size(), 5u);
  b.click({5, 0});
  b.hover({30, 30});
  b.w.undo();
  ASSERT_EQ(only(b).points.size(), 4u);
  b.key("Del");
  EXPECT_TRUE(b.project().obstacles->empty()) << "the corner that was clicked is gone: the selection goes";
}

TEST(OutlineHandles, DragTheRadiusOfACircle) {
  Bench b;
  add(b, ObstacleShape::Circle);
  b.drag({15, 10}, {17.5f, 10});
  EXPECT_NEAR(only(b).radius, 7.5f, 0.02f);
  expectNear(only(b).centre, {10, 10});
}

TEST(OutlineHandles, ATypedNumberIsTheRadius) {
  Bench b;
  add(b, ObstacleShape::Circle);
  b.press({15, 10});
  b.move({16, 10});
  b.type("3");
  b.key("Enter");
  b.release({16, 10});
  EXPECT_NEAR(only(b).radius, 3.0f, 1e-5f);
}

TEST(OutlineHandles, DragASideOfABoxWhileTheOppositeOneStays) {
  Bench b;
  add(b, ObstacleShape::Box);
  b.drag({14, 10}, {18, 10});
  expectNear(only(b).size, {12, 6}, 0.02f);
  expectNear(only(b).centre, {12, 10}, 0.02f);
}

TEST(OutlineHandles, DragTheTurnOfABox) {
  Bench b;
  add(b, ObstacleShape::Box);
  b.drag({16.8f, 10}, {10, 17});
  EXPECT_NEAR(only(b).rotation, 90.0f, 0.5f);
}

TEST(OutlineHandles, NoneOnALockedObstacle) {
  Bench b;
  add(b, ObstacleShape::Circle);
  Obstacle locked = only(b);
  locked.locked = true;
  b.w.apply(Edit{"Lock", {Put<Obstacle>{locked}}, ""});
  b.drag({15, 10}, {17.5f, 10});
  EXPECT_EQ(only(b).radius, 5.0f);
}

TEST(Polygon, MovesTurnsAndScalesAsOne) {
  Bench b;
  drawPolygon(b, {{0, 0}, {10, 0}, {10, 8}, {0, 8}});
  const std::vector<glm::vec2> before = only(b).points;
  b.key("W");
  b.press({5, 3});
  b.move({6, 3});
  b.key("X");
  b.type("20");
  b.key("Enter");
  b.release({6, 3});
  expectNear(only(b).centre, {25, 4}, 0.05f);
  EXPECT_EQ(only(b).points, before) << "a move changes the centre only";
  b.key("E");
  b.press({28, 4});
  b.move({28, 5});
  b.type("90");
  b.key("Enter");
  b.release({28, 5});
  EXPECT_NEAR(only(b).rotation, 90.0f, 1e-3f);
  EXPECT_EQ(only(b).points, before);
  b.key("R");
  b.press({40, 20});
  b.move({41, 20});
  b.key("X");
  b.type("2");
  b.key("Enter");
  b.release({41, 20});
  const std::vector<glm::vec2> outline = outlineOf(only(b));
  float low = 1e9f, high = -1e9f, lowZ = 1e9f, highZ = -1e9f;
  for (const glm::vec2 corner : outline) {
    low = std::min(low, corner.x), high = std::max(high, corner.x);
    lowZ = std::min(lowZ, corner.y), highZ = std::max(highZ, corner.y);
  }
  EXPECT_NEAR(high - low, 16.0f, 0.1f) << "8 m, turned onto x, twice as long";
  EXPECT_NEAR(highZ - lowZ, 10.0f, 0.1f);
}

TEST(Polygon, TheInspectorTurnsACircleIntoOne) {
  Bench b;
  add(b, ObstacleShape::Circle);
  const auto edit =
      setParameter(b.project(), {InspectorKind::Obstacle, {1}}, "shape", static_cast<int>(ObstacleShape::Polygon));
  ASSERT_TRUE(edit.ok());
  ASSERT_TRUE(b.w.apply(*edit));
  EXPECT_EQ(only(b).shape, ObstacleShape::Polygon);
  EXPECT_GE(only(b).points.size(), 8u);
  EXPECT_NEAR(reachOf(only(b)), 5.0f, 1e-3f);
}

TEST(Polygon, RadiusKeysLeaveItAlone) {
  Bench b;
  drawPolygon(b, {{0, 0}, {10, 0}, {10, 8}});
  const Obstacle before = only(b);
  b.key("Q");
  b.key("]");
  EXPECT_EQ(only(b), before);
}

TEST(Polygon, IsPickedInsideAndAtItsSides) {
  Bench b;
  const Id id = drawPolygon(b, {{0, 0}, {20, 0}, {20, 20}, {10, 4}, {0, 20}}).id;
  b.key("Q");
  b.click({-30, -30});
  EXPECT_TRUE(b.w.selection.empty());
  b.click({10, 2});
  EXPECT_EQ(b.w.selection.active(), id) << "inside";
  b.click({-30, -30});
  b.click({10, 14});
  EXPECT_TRUE(b.w.selection.empty()) << "the notch is outside";
  b.click({20.4f, 10});
  EXPECT_EQ(b.w.selection.active(), id) << "within reach of a side";
}

}  // namespace
}  // namespace windloom::editor
