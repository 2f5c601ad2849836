// Colliders in the editor: adding, picking, dragging, their handles and what they are told by.
#include "editor/core/collider_shape.hpp"
#include "editor/core/grips.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

Id addBall(Bench& b, glm::vec2 place, float radius = 2.0f) {
  Collider ball;
  ball.position = place;
  ball.radius = radius;
  const AddResult added = addColliderEdit(b.project(), ball);
  EXPECT_TRUE(b.w.apply(added.edit));
  return added.id;
}

const Collider& collider(const Bench& b, Id id) {
  return *findCollider(b.project(), id);
}

}  // namespace

TEST(Colliders, CAddsABallInTheMiddleOfTheView) {
  Bench b;
  b.w.camera.target = {12, 0, -7};
  EXPECT_TRUE(b.key("C"));
  ASSERT_EQ(b.project().colliders->size(), 1u);
  const Collider& ball = b.project().colliders->front();
  EXPECT_EQ(ball.shape, ColliderShape::Sphere);
  expectNear(ball.position, {12, -7}, 0.01f);
  EXPECT_EQ(b.w.selection.active(), ball.id);
  EXPECT_EQ(b.steps(), 1u);
  b.key("C");
  ASSERT_EQ(b.project().colliders->size(), 2u);
  EXPECT_GT(glm::distance((*b.project().colliders)[1].position, glm::vec2(12, -7)), 0.9f) << "beside the first";
  b.key("Ctrl+Z");
  b.key("Ctrl+Z");
  EXPECT_TRUE(b.project().colliders->empty());
}

TEST(Colliders, ThereAreAtMostSixtyFour) {
  Bench b;
  for (int i = 0; i < 64; ++i) b.key("C");
  EXPECT_EQ(b.project().colliders->size(), 64u);
  b.key("C");
  EXPECT_EQ(b.project().colliders->size(), 64u);
  EXPECT_NE(b.w.message().text.find("at most 64"), std::string::npos) << b.w.message().text;
}

TEST(Colliders, AreSelectedAndDraggedAsOneStep) {
  Bench b;
  const Id ball = addBall(b, {5, 5});
  b.click({40, 40});
  EXPECT_TRUE(b.w.selection.empty());
  b.click({5, 6});
  EXPECT_EQ(b.w.selection.active(), ball) << "inside its outline";
  const std::size_t before = b.steps();
  b.drag({5, 5}, {-10, 8});
  expectNear(collider(b, ball).position, {-10, 8}, 0.01f);
  EXPECT_EQ(b.steps(), before + 1);
  b.key("Ctrl+Z");
  expectNear(collider(b, ball).position, {5, 5});
  b.drag({5, 5}, {10, 5}, kAlt);
  ASSERT_EQ(b.project().colliders->size(), 2u) << "Alt+drag copies";
  expectNear((*b.project().colliders)[1].position, {10, 5}, 0.01f);
}

TEST(Colliders, TheMiddleComesBeforeALineTheOutlineAfterIt) {
  Bench b;
  const Id arrow = b.draw({-20, 0}, {20, 0});
  b.key("Q");
  const Id ball = addBall(b, {10, 0}, 3.0f);
  const auto first = [&](glm::vec2 place) { return b.w.context().hits(b.pixel(place)).front(); };
  EXPECT_EQ(first({10, 0.2f}).id, ball);
  EXPECT_TRUE(first({10, 0.2f}).isHandle());
  EXPECT_EQ(first({13, 0}).id, arrow);
  EXPECT_EQ(first({10, 3}).id, ball);
  EXPECT_TRUE(first({10, 3}).edge);
  EXPECT_TRUE(first({11.4f, 1.4f}).inside);
}

TEST(Colliders, LockedAndHiddenOnesAreNotPicked) {
  Bench b;
  const Id ball = addBall(b, {5, 5});
  for (const Flag flag : {Flag::Locked, Flag::Hidden}) {
    b.w.apply(flagEdit(b.project(), std::vector<Id>{ball}, flag, true));
    b.w.selection.clear();
    b.click({5, 5});
    EXPECT_TRUE(b.w.selection.empty());
    b.w.apply(clearFlagEdit(b.project(), flag));
  }
  b.click({5, 5});
  EXPECT_EQ(b.w.selection.active(), ball);
  b.key("M");
  EXPECT_TRUE(collider(b, ball).muted);
}

TEST(Colliders, TheRadiusHasAHandle) {
  Bench b;
  const Id ball = addBall(b, {0, 0});
  b.click({0, 0});
  const std::size_t before = b.steps();
  b.drag({2, 0}, {4, 0});
  EXPECT_NEAR(collider(b, ball).radius, 4.0f, 0.01f);
  expectNear(collider(b, ball).position, {0, 0});
  EXPECT_EQ(b.steps(), before + 1);
  b.press({4, 0});
  b.move({5, 0});
  b.type("1.5");
  b.key("Enter");
  EXPECT_FLOAT_EQ(collider(b, ball).radius, 1.5f);
}

TEST(Colliders, ACapsuleTurnsByItsHandle) {
  Bench b;
  const Id id = addBall(b, {0, 0}, 1.0f);
  Collider capsule = collider(b, id);
  capsule.shape = ColliderShape::Capsule;
  capsule.length = 4.0f;
  b.w.apply(Edit{"Shape", {Put<Collider>{capsule}}, {}});
  b.click({0, 0});
  const std::vector<Grip> grips = gripsOf(b.w.context(), SelectKind::Select);
  ASSERT_EQ(grips.size(), 2u);
  EXPECT_EQ(grips[0].kind, GripKind::Radius);
  EXPECT_EQ(grips[1].kind, GripKind::Turn);
  b.drag(grips[1].place, {0, 8});
  EXPECT_NEAR(collider(b, id).rotation, 90.0f, 0.5f);
  const std::vector<glm::vec2> outline = outlineOf(collider(b, id));
  EXPECT_TRUE(isInside(collider(b, id), {0.0f, 2.9f}));
  EXPECT_FALSE(isInside(collider(b, id), {2.9f, 0.0f}));
  for (const glm::vec2 corner : outline) EXPECT_LE(glm::length(corner), reachOf(collider(b, id)) + 1e-4f);
}

TEST(Colliders, AMeshPointsAlongItsRotationWithItsFront) {
  Collider shoe;
  shoe.shape = ColliderShape::Mesh;
  shoe.file = "shoe.glb";
  auto mesh = std::make_shared<PlantMesh>();
  mesh->file = shoe.file;
  mesh->low = {-0.1f, 0.0f, -0.2f};
  mesh->high = {0.1f, 0.1f, 0.6f};  // its front is +z
  shoe.mesh = mesh;
  EXPECT_TRUE(isInside(shoe, {0.55f, 0.0f}));
  EXPECT_FALSE(isInside(shoe, {-0.25f, 0.0f}));
  shoe.rotation = 90.0f;
  EXPECT_TRUE(isInside(shoe, {0.0f, 0.55f}));
  EXPECT_FALSE(isInside(shoe, {0.0f, -0.25f}));
  shoe.scale = 2.0f;
  EXPECT_TRUE(isInside(shoe, {0.0f, 1.1f}));
}

TEST(Colliders, MovingOnesAreTakenHoldOfWhereTheyAre) {
  Bench b;
  const Id ball = addBall(b, {0, 0}, 1.5f);
  Collider moving = collider(b, ball);
  moving.keys = {{0, {0, 0, 0}}, {2, {20, 0, 10}}};
  moving.loop = false;
  b.w.apply(Edit{"Way", {Put<Collider>{moving}}, {}});
  b.w.windSeconds = 2.0;
  b.click({0, 0});
  EXPECT_TRUE(b.w.selection.empty()) << "it has gone";
  b.click({20, 10});
  ASSERT_EQ(b.w.selection.active(), ball);
  b.drag({21.5f, 10}, {22.5f, 10});
  EXPECT_NEAR(collider(b, ball).radius, 2.5f, 0.01f) << "the handle goes along";
  b.drag({20, 10}, {15, 5});
  expectNear(collider(b, ball).position, {-5, -5}, 0.01f);
  EXPECT_EQ(collider(b, ball).keys, moving.keys) << "the way moves as a whole";
  b.click({40, 40});
  b.drag({12, 2}, {17, 7});
  EXPECT_EQ(b.w.selection.active(), ball) << "box select";
}

TEST(Colliders, FFramesTheWholeWay) {
  Bench b;
  const Id ball = addBall(b, {30, 20});
  Collider moving = collider(b, ball);
  moving.keys = {{0, {0, 0, 0}}, {2, {-20, 0, 0}}};
  b.w.apply(Edit{"Way", {Put<Collider>{moving}}, {}});
  b.w.selection.replace(ball);
  b.key("F");
  EXPECT_NEAR(b.w.camera.target.x, 20.0f, 0.5f);
  EXPECT_NEAR(b.w.camera.target.z, 20.0f, 0.5f);
}

TEST(Colliders, TurningAndScalingTakesTheWayAlong) {
  Project project;
  Collider ball;
  ball.id = 1;
  ball.position = {10, 0};
  ball.keys = {{0, {0, 0, 0}}, {1, {4, 1, 0}}};
  project.colliders = std::make_shared<std::vector<Collider>>(1, ball);
  const Project turned = *applyEdit(project, transformEdit(project, std::vector<Id>{1}, {0, 0}, 90.0f, 2.0f));
  const Collider& after = turned.colliders->front();
  expectNear(after.position, {0, 20});
  EXPECT_NEAR(after.keys[1].offset.x, 0.0f, 1e-3f);
  EXPECT_NEAR(after.keys[1].offset.y, 1.0f, 1e-3f) << "heights stay";
  EXPECT_NEAR(after.keys[1].offset.z, 8.0f, 1e-3f);
  EXPECT_FLOAT_EQ(after.radius, 2.0f * ball.radius);
}

TEST(Colliders, CopiesAndPastesAsText) {
  Bench b;
  const Id ball = addBall(b, {0, 0});
  Collider moving = collider(b, ball);
  moving.name = "ball";
  moving.keys = {{0, {0, 0, 0}}, {2, {3, 0, 1}}};
  b.w.apply(Edit{"Way", {Put<Collider>{moving}}, {}});
  b.w.selection.replace(ball);
  b.key("Ctrl+C");
  EXPECT_NE(b.w.clipboardText().find("\"keys\": [[0, 0, 0, 0], [2, 3, 0, 1]]"), std::string::npos);
  b.hover({20, 10});
  b.key("Ctrl+V");
  ASSERT_EQ(b.project().colliders->size(), 2u);
  const Collider& copy = (*b.project().colliders)[1];
  expectNear(copy.position, {20, 10}, 0.01f);
  EXPECT_EQ(copy.keys, moving.keys);
  EXPECT_EQ(b.w.selection.active(), copy.id);
  b.key("Ctrl+D");
  EXPECT_EQ(b.project().colliders->size(), 3u);
  b.key("Del");
  EXPECT_EQ(b.project().colliders->size(), 2u);
}

TEST(Colliders, BoxSelectTakesThemByTheirMiddle) {
  Bench b;
  const Id ball = addBall(b, {10, 10});
  b.drag({2, 2}, {10.5f, 10.5f});
  EXPECT_EQ(b.w.selection.active(), ball);
  b.click({40, 40});
  b.drag({2, 2}, {9, 9});
  EXPECT_TRUE(b.w.selection.empty());
}

TEST(Colliders, BracketsChangeTheRadius) {
  Bench b;
  const Id ball = addBall(b, {0, 0});
  b.w.selection.replace(ball);
  b.key("]");
  EXPECT_NEAR(collider(b, ball).radius, 2.2f, 1e-3f);
  b.key("[");
  b.key("[");
  EXPECT_LT(collider(b, ball).radius, 2.0f);
}

}  // namespace windloom::editor
