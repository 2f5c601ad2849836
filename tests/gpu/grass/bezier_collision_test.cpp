#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "engine/grass/bezier_physics.hpp"
#include "tests/gpu/grass/bezier_fixture.hpp"

namespace windloom {
namespace {

using glm::vec3;
using shared::BezierCurve;
using shared::BezierState;
using testing::ball;
using testing::between;
using testing::BladePlan;
using testing::BladeStore;
using testing::farthest;
using testing::lawn;
using testing::randomBlades;
using testing::randomStates;
using testing::randomUnit;
using testing::stepped;

constexpr double kFrame = 1.0 / 60.0;

class BezierCollisionGpu : public testing::BezierTest {};

TEST_F(BezierCollisionGpu, CollisionsAreTheSharedFunctionsOnes) {
  BladeStore blades(randomBlades(5, 1024));
  for (int i = 0; i < 6; ++i) {
    Collider collider = ball(0.4f + 0.1f * float(i), {{0.0f, {0, 0, 0}}, {2.0f, {2.0f, 0.5f, -1.0f}}});
    collider.position = {-2.0f + 0.7f * float(i), 1.5f - 0.5f * float(i)};
    collider.shape = i % 2 == 0 ? ColliderShape::Sphere : ColliderShape::Capsule;
    collider.length = 0.8f;
    colliders.push_back(collider);
  }
  configure(blades);
  advance(blades, 1.0);
  const std::vector<BezierState> before = randomStates(blades, 6);
  blades.setStates(before);
  const double now = 1.0 + kFrame;
  advance(blades, now);
  const std::vector<BezierState> after = blades.states();
  const std::vector<BezierMover> movers =
      bezierMovers(colliderPrimitives(project(), 1.0), colliderPrimitives(project(), now));
  const BezierPhysicsBlock block = makeBezierPhysicsBlock(project(), now);
  int hit = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const BezierState wanted = stepped(before[i], blades.blades[i], block, {}, movers, float(kFrame));
    const BezierState alone = stepped(before[i], blades.blades[i], block, {}, {}, float(kFrame));
    hit += glm::length(wanted.tip - alone.tip) > 1e-3f ? 1 : 0;
    ASSERT_LT(glm::length(vec3(after[i].tip - wanted.tip)), 1e-4f) << i;
    ASSERT_NEAR(after[i].tip.w, wanted.tip.w, 2e-3f) << i;
  }
  EXPECT_GT(hit, 80);
}

/// m that the deepest of the points that eq. 14 and 15 test is inside.
float deepest(const std::vector<BezierState>& states, const BladeStore& blades,
              const std::vector<ColliderPrimitive>& things) {
  float most = 0.0f;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BladePlan& blade = blades.blades[i];
    const BezierCurve curve = shared::bezierValid(vec3(states[i].tip), blade.up, blade.height);
    for (const ColliderPrimitive& thing : things) {
      // Under a ball a blade has no room.
      if (shared::colliderDistance(thing, blade.root) < 0.12f) continue;
      for (const vec3 point : {curve.tip, shared::bezierPoint(curve, 0.5f)}) {
        most = std::max(most, -shared::colliderDistance(thing, blade.root + point));
      }
    }
  }
  return most;
}

TEST_F(BezierCollisionGpu, BladesAreKeptOutOfABallThatRollsOverThem) {
  const BladeStore blades(lawn({-3.0f, -1.5f}, {60, 32}, 0.1f));
  colliders = {ball(0.6f, {{0.0f, {-3, 0, 0}}, {3.0f, {3, 0, 0}}})};
  configure(blades);
  float worst = 0.0f;
  for (double time = 0.0; time < 3.0; time += kFrame) {
    advance(blades, time);
    worst = std::max(worst, deepest(blades.states(), blades, colliderPrimitives(project(), time)));
  }
  EXPECT_LT(worst, 0.05f);
}

TEST_F(BezierCollisionGpu, ABallLeavesATrailThatRisesInTheTimeItsStrengthGives) {
  const BladeStore blades(lawn({-0.5f, -1.6f}, {8, 32}, 0.1f));
  colliders = {ball(0.5f, {{0.0f, {-3, 0, 0}}, {2.0f, {5, 0, 0}}})};
  configure(blades);
  double time = 0.0;
  for (; time < 1.3; time += kFrame) advance(blades, time);
  std::vector<BezierState> states = blades.states();
  const std::vector<BezierState> left = states;
  int low = 0, strong = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const float aside = std::abs(blades.blades[i].root.z);
    if (aside < 0.3f) {
      low += states[i].tip.y < 0.35f ? 1 : 0;
      strong += states[i].tip.w > 1.0f ? 1 : 0;
    }
    if (aside > 1.1f) {
      EXPECT_NEAR(states[i].tip.y, 0.5f, 0.01f) << "beside the trail they stand";
    }
  }
  EXPECT_GT(low, 35);
  EXPECT_GT(strong, 35);
  // From here on nothing touches them: what is left is eq. 2 and 3.
  const BezierPhysicsBlock block = makeBezierPhysicsBlock(project(), time);
  for (const double later : {0.5, 1.0, 2.0, 3.5}) {
    for (; time < 1.3 + later; time += kFrame) advance(blades, time);
    const std::vector<BezierState> found = blades.states();
    for (std::size_t i = 0; i < states.size(); ++i) {
      const double way = time - 1.3;
      BezierState wanted = left[i];
      const int parts = static_cast<int>(std::lround(way * 240.0));
      for (int n = 0; n < parts; ++n) wanted = stepped(wanted, blades.blades[i], block, {}, {}, float(way / parts));
      ASSERT_LT(glm::length(found[i].tip - wanted.tip), 0.02f) << i << " after " << later;
    }
  }
  states = blades.states();
  for (const BezierState& state : states) EXPECT_GT(state.tip.y, 0.47f) << "and in the end all stand";
}

TEST_F(BezierCollisionGpu, AFastBallMissesNoBlade) {
  const BladeStore blades(lawn({-2.5f, -0.3f}, {50, 5}, 0.1f));
  colliders = {ball(0.3f, {{0.0f, {-6, 0, 0}}, {0.3f, {6, 0, 0}}})};
  configure(blades);
  for (const double time : {0.0, 0.1, 0.2, 0.3, 0.4}) advance(blades, time);
  const std::vector<BezierState> states = blades.states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (std::abs(blades.blades[i].root.z) < 0.15f) {
      EXPECT_GT(states[i].tip.w, 0.5f) << blades.blades[i].root.x;
    }
  }
}

TEST_F(BezierCollisionGpu, FramesOfAnyRateGiveTheSamePose) {
  const std::vector<BladePlan> plans = lawn({-2.0f, -1.0f}, {40, 20}, 0.1f);
  m_scene->blow({5.0f, 1.0f});
  colliders = {ball(0.5f, {{0.0f, {-3, 0, 0}}, {6.0f, {3, 0, 0}}})};
  const auto after = [&](double frame) {
    const BladeStore blades(plans);
    configure(blades);
    for (int i = 0; i * frame < 2.0 + 1e-6; ++i) advance(blades, 1.0 + i * frame);
    return blades.states();
  };
  const BladeStore blades(plans);
  const std::vector<BezierState> fine = after(1.0 / 240.0);
  for (const double frame : {1.0 / 30.0, 1.0 / 60.0, 0.1}) {
    EXPECT_LT(farthest(fine, after(frame), blades), 0.02f) << frame;
  }
}

TEST_F(BezierCollisionGpu, AMeshOfAThousandSpheresIsMetTheSameWayEachTime) {
  auto mesh = std::make_shared<PlantMesh>();
  std::mt19937 random(12);
  for (int i = 0; i < 1000; ++i)
    mesh->spheres.emplace_back(randomUnit(random) * vec3(0.9f, 0.7f, 0.9f) * between(random, 0.0f, 1.0f),
                               between(random, 0.05f, 0.2f));
  mesh->low = vec3(-1.1f, -0.9f, -1.1f);
  mesh->high = -mesh->low;
  Collider thing;
  thing.shape = ColliderShape::Mesh;
  thing.mesh = mesh;
  thing.keys = {{0.0f, {-2, 0, 0}}, {2.0f, {0, 0, 0}}};
  thing.loop = false;
  colliders = {thing};
  const std::vector<BladePlan> plans = lawn({-1.6f, -1.6f}, {32, 32}, 0.1f);
  const auto play = [&] {
    const BladeStore blades(plans);
    configure(blades);
    for (int i = 0; i <= 60; ++i) advance(blades, 1.2 + i * kFrame);
    EXPECT_LT(deepest(blades.states(), blades, colliderPrimitives(project(), 2.2)), 0.2f);
    return blades.states();
  };
  const std::vector<BezierState> first = play(), second = play();
  int touched = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    ASSERT_EQ(first[i].tip, second[i].tip) << i;
    touched += first[i].tip.w > 0.1f ? 1 : 0;
  }
  EXPECT_GT(touched, 300);
}

TEST_F(BezierCollisionGpu, BladesAgainstABallThatLiesStillDontTremble) {
  const BladeStore blades(lawn({-1.0f, -1.0f}, {32, 32}, 0.06f));
  m_scene->blow({4.0f, 0.0f});
  colliders = {ball(0.4f, {})};
  configure(blades);
  for (int i = 0; i <= 120; ++i) advance(blades, i * kFrame);
  std::vector<BezierState> before = blades.states();
  float most = 0.0f;
  for (int i = 121; i <= 150; ++i) {
    advance(blades, i * kFrame);
    std::vector<BezierState> after = blades.states();
    most = std::max(most, farthest(before, after, blades));
    before = std::move(after);
  }
  EXPECT_LT(most, 0.01f);
}

TEST_F(BezierCollisionGpu, AThingThatLiesStillWakesNoPatchButIsMetWhenItWakes) {
  BladeStore blades(lawn({-0.8f, -0.8f}, {16, 16}, 0.1f));
  m_scene->blow({5.0f, 0.0f});
  colliders = {ball(0.5f, {})};
  blades.setSeen(false);
  configure(blades);
  for (int i = 0; i <= 30; ++i) advance(blades, i * kFrame);
  for (const BezierState& state : blades.states()) ASSERT_EQ(state.tip, glm::vec4(0.0f));
  blades.setSeen(true);
  advance(blades, 31 * kFrame);
  const std::vector<BezierState> woken = blades.states();
  EXPECT_LT(deepest(woken, blades, colliderPrimitives(project(), 0.0)), 0.05f);
  for (int i = 32; i <= 120; ++i) advance(blades, i * kFrame);
  const std::vector<BezierState> later = blades.states();
  int alike = 0;
  for (std::size_t i = 0; i < later.size(); ++i)
    alike += glm::length(vec3(later[i].tip - woken[i].tip)) < 0.05f ? 1 : 0;
  EXPECT_GT(alike, int(later.size()) * 75 / 100) << "most lean against it at once as they will";
}

}  // namespace
}  // namespace windloom
