#include "editor_bench.hpp"

namespace windloom::editor {

TEST(ObstacleTool, DragMakesACircleFromItsCentre) {
  Bench b;
  b.key("O");
  b.drag({10, 5}, {13, 9});
  ASSERT_EQ(b.project().obstacles->size(), 1u);
  const Obstacle& obstacle = b.project().obstacles->front();
  EXPECT_EQ(obstacle.shape, ObstacleShape::Circle);
  expectNear(obstacle.centre, {10, 5});
  EXPECT_NEAR(obstacle.radius, 5.0f, 0.01f);
  EXPECT_EQ(b.w.selection.active(), obstacle.id);
  EXPECT_EQ(b.steps(), 1u);
}

TEST(ObstacleTool, KeyCChangesToABoxDuringTheDrag) {
  Bench b;
  b.key("O");
  b.press({10, 5});
  b.move({13, 9});
  EXPECT_TRUE(b.key("C"));
  b.release({13, 9});
  const Obstacle& obstacle = b.project().obstacles->front();
  EXPECT_EQ(obstacle.shape, ObstacleShape::Box);
  expectNear(obstacle.size, {6, 8}, 0.01f);
}

TEST(ObstacleTool, OneClickMakesNothingYet) {
  Bench b;
  b.key("O");
  b.click({10, 5});
  EXPECT_TRUE(b.project().obstacles->empty());
  EXPECT_TRUE(b.w.message().text.empty());
}

TEST(VortexTool, DragMakesAWhirlAroundItsMiddle) {
  Bench b;
  b.key("V");
  b.press({10, 5});
  b.move({13, 9});
  b.w.wheel(1.0f, b.at({13, 9}));
  b.key("C");
  b.release({13, 9});
  ASSERT_EQ(b.graph().arrows.size(), 1u);
  const Arrow& arrow = b.graph().arrows[0];
  expectNear(b.place(arrow.to), {10, 5});
  EXPECT_NEAR(arrow.radius, 5.0f, 0.01f);
  EXPECT_NEAR(arrow.swirl, -6.6f, 1e-4f);
  EXPECT_EQ(arrow.strength, 0.0f);
  EXPECT_EQ(arrow.where, Where::End);
  EXPECT_EQ(b.steps(), 1u);
}

TEST(ProbeTool, ClickAndDragSetOneDown) {
  Bench b;
  b.key("P");
  b.click({3, 4});
  b.drag({10, 10}, {12, 9});
  ASSERT_EQ(b.project().probes->size(), 2u);
  expectNear((*b.project().probes)[0].position, {3, 4});
  expectNear((*b.project().probes)[1].position, {12, 9});
}

TEST(DeleteTool, ClickDeletesAnArrowWithItsLoneEnds) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.draw({-20, 20}, {0, 20});
  b.w.activateTool("delete");
  b.click({-10, 0});
  EXPECT_EQ(b.graph().arrows.size(), 1u);
  EXPECT_EQ(b.graph().points.size(), 2u);
  EXPECT_TRUE(b.key("Ctrl+Z"));
  EXPECT_EQ(b.graph().points.size(), 4u);
}

TEST(DeleteTool, SweepDeletesAllItCrossesAsOneStep) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.draw({-20, 5}, {0, 5});
  b.draw({-20, 30}, {0, 30});
  b.w.activateTool("delete");
  const std::size_t before = b.steps();
  b.press({-10, -5});
  b.move({-10, 10});
  b.release({-10, 10});
  EXPECT_EQ(b.graph().arrows.size(), 1u);
  EXPECT_EQ(b.steps(), before + 1);
}

}  // namespace windloom::editor
