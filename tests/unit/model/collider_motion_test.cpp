#include "engine/model/collider_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

constexpr float kRadians = 3.14159265f / 180.0f;

Collider moving(std::vector<ColliderKey> keys, bool loop = false) {
  Collider collider;
  collider.keys = std::move(keys);
  collider.loop = loop;
  return collider;
}

/// Steps and rests, up and down, unevenly spaced.
Collider walk() {
  return moving({{0.5f, {0, 0, 0}},
                 {1.0f, {0, 0, 0}},
                 {1.2f, {0.3f, 0.12f, 0.02f}},
                 {1.5f, {0.7f, 0, 0.05f}},
                 {2.3f, {0.7f, 0, 0.05f}},
                 {2.4f, {0.2f, 0.1f, 0.3f}},
                 {4.0f, {1.5f, 0, -1.0f}}});
}

Collider circle(float radiusM, float seconds, int keys = 24) {
  std::vector<ColliderKey> list;
  for (int i = 0; i <= keys; ++i) {
    const float turn = 2.0f * 3.14159265f * float(i % keys) / float(keys);
    list.push_back({seconds * float(i) / float(keys), {radiusM * std::cos(turn), 0, radiusM * std::sin(turn)}});
  }
  return moving(list, true);
}

/// rad, the shorter way round.
float between(float a, float b) {
  return std::abs(std::remainder(a - b, 2.0f * 3.14159265f));
}

TEST(ColliderMotion, PassesThroughItsKeys) {
  const Collider collider = walk();
  for (const ColliderKey& key : collider.keys) {
    EXPECT_LT(glm::distance(colliderOffset(collider, double(key.time)), key.offset), 1e-5f) << key.time;
  }
}

TEST(ColliderMotion, HasNoJumpInPlaceAndSpeed) {
  const Collider collider = walk();
  const double dt = 1e-4;
  for (double t = 0.0; t < 5.0; t += dt) {
    EXPECT_LT(glm::distance(colliderOffset(collider, t), colliderOffset(collider, t + dt)), 3e-3f) << t;
    EXPECT_LT(glm::distance(colliderVelocity(collider, t), colliderVelocity(collider, t + dt)), 0.15f) << t;
  }
}

TEST(ColliderMotion, VelocityIsTheChangeOfTheOffset) {
  const Collider collider = walk();
  const double dt = 1e-3;
  for (double t = 0.55; t < 3.9; t += 0.0371) {
    const glm::vec3 change = (colliderOffset(collider, t + dt) - colliderOffset(collider, t - dt)) / float(2 * dt);
    EXPECT_LT(glm::distance(change, colliderVelocity(collider, t)), 0.02f) << t;
  }
}

TEST(ColliderMotion, NeverGoesBeyondTheKeysAround) {
  const Collider collider = walk();
  for (std::size_t i = 0; i + 1 < collider.keys.size(); ++i) {
    const ColliderKey &from = collider.keys[i], &to = collider.keys[i + 1];
    for (int k = 0; k <= 50; ++k) {
      const glm::vec3 at = colliderOffset(collider, double(from.time + (to.time - from.time) * float(k) / 50.0f));
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(at[c], std::min(from.offset[c], to.offset[c]) - 1e-5f);
        EXPECT_LE(at[c], std::max(from.offset[c], to.offset[c]) + 1e-5f);
      }
    }
  }
}

TEST(ColliderMotion, ARestingFootStays) {
  const Collider collider = walk();
  for (double t = 1.5; t < 2.295; t += 0.01) {
    EXPECT_LT(glm::distance(colliderOffset(collider, t), {0.7f, 0.0f, 0.05f}), 1e-6f) << t;
    EXPECT_LT(glm::length(colliderVelocity(collider, t)), 1e-5f) << t;
  }
}

TEST(ColliderMotion, WithoutLoopTheEndsHold) {
  const Collider collider = walk();
  EXPECT_EQ(colliderOffset(collider, 0.0), collider.keys.front().offset);
  EXPECT_EQ(colliderOffset(collider, 100.0), collider.keys.back().offset);
  EXPECT_EQ(colliderVelocity(collider, 100.0), glm::vec3(0.0f));
}

TEST(ColliderMotion, NoKeysAndOneKeyRest) {
  EXPECT_EQ(colliderOffset(moving({}), 3.0), glm::vec3(0.0f));
  EXPECT_EQ(colliderOffset(moving({{2.0f, {1, 2, 3}}}, true), 0.0), glm::vec3(1, 2, 3));
  EXPECT_EQ(colliderOffset(moving({{2.0f, {1, 2, 3}}}, true), 9.0), glm::vec3(1, 2, 3));
}

TEST(ColliderMotion, ALoopBeginsAgainAndAClosedOneHasNoSeam) {
  Collider collider = circle(4.0f, 12.0f);
  EXPECT_LT(glm::distance(colliderOffset(collider, 5.0), colliderOffset(collider, 5.0 + 36.0)), 1e-4f);
  const double dt = 1e-3;
  for (double t = 11.98; t < 12.02; t += dt) {
    EXPECT_LT(glm::distance(colliderOffset(collider, t), colliderOffset(collider, t + dt)), 2.3e-3f) << t;
    EXPECT_LT(glm::distance(colliderVelocity(collider, t), colliderVelocity(collider, t + dt)), 0.02f) << t;
    EXPECT_LT(between(colliderHeading(collider, t), colliderHeading(collider, t + dt)), 0.01f) << t;
  }
  collider.keys.back().offset.x += 1.0f;  // no longer closed: it stops and starts again
  EXPECT_LT(glm::length(colliderVelocity(collider, 12.0 + 1e-6)), 1e-2f);
}

TEST(ColliderMotion, PointsAlongItsWay) {
  const Collider collider = circle(4.0f, 12.0f);
  for (double t = 0.05; t < 24.0; t += 0.13) {
    const float turn = float(t) / 12.0f * 360.0f + 90.0f;
    EXPECT_LT(between(colliderHeading(collider, t), turn * kRadians), 0.06f) << t;
  }
}

TEST(ColliderMotion, PausesInTheDirectionItCameInAndTurnsSmoothly) {
  Collider collider = walk();
  collider.rotation = 30.0f;
  EXPECT_NEAR(colliderHeading(collider, 0.7), 30.0f * kRadians, 1e-5f) << "has not moved yet";
  const float arrived = colliderHeading(collider, 1.499);
  EXPECT_LT(between(colliderHeading(collider, 2.0), arrived), 0.02f);
  const double dt = 1e-4;
  for (double t = 0.0; t < 5.0; t += dt) {
    EXPECT_LT(between(colliderHeading(collider, t), colliderHeading(collider, t + dt)), 0.02f) << t;
  }
}

TEST(ColliderMotion, ABallRollsWithoutSlipping) {
  Collider ball = circle(3.0f, 10.0f);
  ball.radius = 0.4f;
  const double dt = 1e-3;
  for (double t = 0.2; t < 21.0; t += 0.37) {
    const ColliderPose before = colliderPose(ball, nullptr, t - dt), after = colliderPose(ball, nullptr, t + dt);
    // The place that touches the ground now has no speed.
    const glm::vec3 now = colliderPose(ball, nullptr, t).centre;
    const glm::vec4 own = glm::inverse(colliderPose(ball, nullptr, t).world) * glm::vec4(now.x, 0.0f, now.z, 1.0f);
    const glm::vec3 slip = glm::vec3(after.world * own - before.world * own) / float(2 * dt);
    EXPECT_LT(glm::length(slip), 0.02f * glm::length(colliderVelocity(ball, t))) << t;
  }
}

TEST(ColliderMotion, ABallTurnsOnAcrossTheSeamOfItsLoop) {
  Collider ball = circle(3.0f, 10.0f);
  ball.radius = 0.4f;
  for (double seam : {10.0, 20.0, 70.0}) {
    const glm::mat4 before = colliderPose(ball, nullptr, seam - 1e-4).world;
    const glm::mat4 after = colliderPose(ball, nullptr, seam + 1e-4).world;
    for (int column = 0; column < 3; ++column) EXPECT_LT(glm::distance(before[column], after[column]), 3e-3f) << seam;
  }
}

TEST(ColliderMotion, ARollingBallComesBackTheWayItWent) {
  Collider ball = moving({{0, {0, 0, 0}}, {1, {2, 0, 0.5f}}, {2, {0, 0, 0}}});
  const glm::mat4 start = colliderPose(ball, nullptr, 0.0).world, end = colliderPose(ball, nullptr, 2.5).world;
  for (int column = 0; column < 4; ++column) EXPECT_LT(glm::distance(start[column], end[column]), 1e-3f);
  EXPECT_GT(glm::distance(start[1], colliderPose(ball, nullptr, 1.0).world[1]), 0.1f);
  ball.roll = false;
  EXPECT_NEAR(colliderPose(ball, nullptr, 0.7).world[1].y, 1.0f, 1e-6f);
}

TEST(ColliderMotion, FollowsTheGround) {
  const auto ground = testing::heightsFrom({65, 65}, {32, 32}, [](glm::vec2 at) { return 0.25f * at.x + 2.0f; });
  Collider collider = moving({{0, {0, 0, 0}}, {4, {8, 0.5f, 0}}});
  collider.position = {-4.0f, 1.0f};
  collider.lift = 0.1f;
  for (double t = 0.0; t <= 4.0; t += 0.25) {
    const glm::vec3 offset = colliderOffset(collider, t);
    const glm::vec3 centre = colliderPose(collider, ground.get(), t).centre;
    const float above = collider.lift + offset.y;
    // m between the sphere's centre and the tilted plane
    const float distance = (centre.y - above - (0.25f * centre.x + 2.0f)) / std::sqrt(1.0f + 0.25f * 0.25f);
    EXPECT_NEAR(distance, collider.radius, 1e-3f) << t;
  }
  collider.shape = ColliderShape::Capsule;
  collider.length = 1.0f;
  for (double t = 0.0; t <= 4.0; t += 0.25) {
    for (const ColliderPrimitive& part : colliderPrimitives(collider, ground.get(), t)) {
      for (const glm::vec4& end : {part.a, part.b}) EXPECT_GE(end.y - 0.25f * end.x - 2.0f, collider.radius - 1e-3f);
    }
  }
}

TEST(ColliderMotion, ACapsuleLiesLevelAlongItsWay) {
  Collider collider = moving({{0, {0, 0, 0}}, {2, {0, 0, 4}}});
  collider.shape = ColliderShape::Capsule;
  collider.radius = 0.2f;
  collider.length = 0.6f;
  const std::vector<ColliderPrimitive> parts = colliderPrimitives(collider, nullptr, 1.0);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_NEAR(parts[0].a.w, 0.2f, 1e-6f);
  EXPECT_LT(glm::distance(glm::vec3(parts[0].a), glm::vec3(0, 0.2f, 2 - 0.3f)), 1e-4f);
  EXPECT_LT(glm::distance(glm::vec3(parts[0].b), glm::vec3(0, 0.2f, 2 + 0.3f)), 1e-4f);
}

TEST(ColliderMotion, AMeshGivesItsSpheresWhereItStands) {
  auto mesh = std::make_shared<PlantMesh>();
  mesh->low = {-1, -0.5f, -2};
  mesh->spheres = {{0, 0.5f, 0, 0.25f}, {0, 0, 1.0f, 0.125f}};  // the second at its front
  Collider collider;
  collider.shape = ColliderShape::Mesh;
  collider.position = {3, 4};
  collider.scale = 2.0f;
  collider.rotation = 90.0f;
  EXPECT_TRUE(colliderPrimitives(collider, nullptr, 0.0).empty()) << "not read yet";
  collider.mesh = mesh;
  std::vector<ColliderPrimitive> parts = colliderPrimitives(collider, nullptr, 0.0);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_LT(glm::distance(parts[0].a, glm::vec4(3, 2, 4, 0.5f)), 1e-5f);
  EXPECT_LT(glm::distance(parts[1].a, glm::vec4(3, 1, 6, 0.25f)), 1e-5f) << "its front points by its rotation";
  EXPECT_EQ(glm::vec3(parts[1].a), glm::vec3(parts[1].b));
}

TEST(ColliderMotion, AMutedColliderTouchesNothing) {
  Project project;
  Collider ball;
  Collider muted;
  muted.muted = true;
  project.colliders = std::make_shared<std::vector<Collider>>(std::vector{muted, ball});
  EXPECT_EQ(colliderPrimitives(project, 1.0).size(), 1u);
  EXPECT_TRUE(colliderPrimitives(muted, nullptr, 1.0).empty());
}

TEST(ColliderPrimitives, DistanceIsToTheSurface) {
  const ColliderPrimitive capsule{{0, 0, 0, 0.5f}, {2, 0, 0, 0}};
  EXPECT_NEAR(shared::colliderDistance(capsule, {1, 1, 0}), 0.5f, 1e-6f);
  EXPECT_NEAR(shared::colliderDistance(capsule, {3, 0, 0}), 0.5f, 1e-6f);
  EXPECT_NEAR(shared::colliderDistance(capsule, {1, 0.2f, 0}), -0.3f, 1e-6f);
  const ColliderPrimitive sphere{{0, 1, 0, 0.5f}, {0, 1, 0, 0}};
  EXPECT_NEAR(shared::colliderDistance(sphere, {0, 2, 0}), 0.5f, 1e-6f);
}

}  // namespace
}  // namespace windloom
