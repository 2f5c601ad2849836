#include "editor/core/picking.hpp"

#include "editor/core/graph_edits.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

std::vector<Hit> hitsAt(Bench& b, glm::vec2 place) {
  return b.w.context().hits(b.pixel(place));
}

}  // namespace

TEST(Picking, RadiusIsTenPixels) {
  Bench b;
  const Id arrow = b.draw({-10, 0}, {10, 0});
  EXPECT_EQ(hitsAt(b, {10.9f, 0}).front().id, b.arrow(arrow).to);
  EXPECT_TRUE(hitsAt(b, {11.1f, 0}).empty());
  EXPECT_EQ(hitsAt(b, {0, 0.9f}).front().id, arrow);
  EXPECT_TRUE(hitsAt(b, {0, 1.1f}).empty());
  b.w.toolSettings.hitRadiusPx = 20.0f;
  EXPECT_EQ(hitsAt(b, {0, 1.1f}).front().id, arrow);
}

TEST(Picking, PointsComeBeforeArrowsThenOutlinesThenInsides) {
  Bench b;
  const Id arrow = b.draw({-10, 0}, {10, 0});
  Obstacle around;
  around.centre = {10, 0};
  around.radius = 8.0f;
  const AddResult big = addObstacleEdit(b.project(), around);
  b.w.apply(big.edit);
  around.radius = 0.5f;
  const AddResult small = addObstacleEdit(b.project(), around);
  b.w.apply(small.edit);
  const std::vector<Hit> hits = hitsAt(b, {9.8f, 0});
  ASSERT_EQ(hits.size(), 4u);
  EXPECT_EQ(hits[0].id, b.arrow(arrow).to);
  EXPECT_EQ(hits[1].id, arrow);
  EXPECT_EQ(hits[2].id, small.id);
  EXPECT_EQ(hits[3].id, big.id);
  EXPECT_TRUE(hits[3].inside);
}

TEST(Picking, NearestPointFirst) {
  Bench b;
  const Id first = b.draw({0, 0}, {20, 0});
  const Id second = b.draw({1.5f, 0}, {20, 10});
  const std::vector<Hit> hits = hitsAt(b, {0.9f, 0});
  EXPECT_EQ(hits[0].id, b.arrow(second).from);
  EXPECT_EQ(hits[1].id, b.arrow(first).from);
  EXPECT_LT(hits[0].distancePx, hits[1].distancePx);
}

TEST(Picking, AlongIsThePlaceOnTheGroundInPerspectiveToo) {
  Bench b;
  const Id arrow = b.draw({0, 30}, {0, -30});
  b.w.camera = EditorCamera{};
  const auto hits = hitsAt(b, {0, -15});
  ASSERT_FALSE(hits.empty());
  EXPECT_EQ(hits[0].id, arrow);
  EXPECT_NEAR(hits[0].along, 0.75f, 0.01f);
}

TEST(Picking, ArrowThatPassesTheCameraIsStillHitInFrontOfIt) {
  Bench b;
  const Id arrow = b.draw({0, 45}, {0, -45});
  b.w.camera = EditorCamera{};
  b.w.camera.yaw = 0;
  b.w.camera.pitch = 20;
  b.w.camera.distance = 20;
  EXPECT_FALSE(b.w.view().toScreen({0, 0, 45}));
  const auto hits = hitsAt(b, {0, -2});
  ASSERT_FALSE(hits.empty());
  EXPECT_EQ(hits[0].id, arrow);
}

TEST(Picking, RotatedBoxIsHitInsideAndOnItsSides) {
  Bench b;
  Obstacle box;
  box.shape = ObstacleShape::Box;
  box.size = {20, 4};
  box.rotation = 90;
  const AddResult added = addObstacleEdit(b.project(), box);
  b.w.apply(added.edit);
  ASSERT_FALSE(hitsAt(b, {0, 8}).empty());
  EXPECT_TRUE(hitsAt(b, {0, 8}).front().inside);
  ASSERT_FALSE(hitsAt(b, {2.5f, 5}).empty());
  EXPECT_FALSE(hitsAt(b, {2.5f, 5}).front().inside);
  EXPECT_TRUE(hitsAt(b, {8, 0}).empty());
}

TEST(Picking, CycleGoesRound) {
  const std::vector<Hit> hits{{ObjectKind::Point, 4}, {ObjectKind::Arrow, 9}};
  EXPECT_EQ(cycleHit(hits, 0), 4u);
  EXPECT_EQ(cycleHit(hits, 4), 9u);
  EXPECT_EQ(cycleHit(hits, 9), 4u);
  EXPECT_EQ(cycleHit({}, 9), 0u);
}

}  // namespace windloom::editor
