#include "engine/grass/bezier_physics.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/gpu/grass/bezier_fixture.hpp"

namespace windloom {
namespace {

using glm::vec3;
using shared::BezierCurve;
using shared::BezierState;
using testing::BladePlan;
using testing::BladeStore;
using testing::stepped;

constexpr double kFrame = 1.0 / 60.0;

class BezierPhysicsGpu : public testing::BezierTest {};

vec3 randomUnit(std::mt19937& random) {
  std::normal_distribution<float> normal;
  return glm::normalize(vec3(normal(random), normal(random), normal(random)));
}

float between(std::mt19937& random, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(random);
}

/// Blades of every kind in a box around the origin.
std::vector<BladePlan> randomBlades(unsigned seed, int count) {
  std::mt19937 random(seed);
  std::vector<BladePlan> plans;
  for (int i = 0; i < count; ++i) {
    const vec3 root = vec3(3.0f, 1.0f, 3.0f) * randomUnit(random) * between(random, 0.2f, 1.0f);
    plans.push_back({root, randomUnit(random), between(random, 0.1f, 0.8f), between(random, 0.5f, 2.0f),
                     between(random, 0.0f, 1.0f)});
  }
  return plans;
}

/// Upright blades in rows, `step` m apart, rows along x.
std::vector<BladePlan> lawn(glm::vec2 low, glm::ivec2 count, float step, float height = 0.5f) {
  std::vector<BladePlan> plans;
  for (int z = 0; z < count.y; ++z) {
    for (int x = 0; x < count.x; ++x) {
      plans.push_back({{low.x + step * float(x), 0.0f, low.y + step * float(z)},
                       {0, 1, 0},
                       height,
                       1.0f,
                       0.37f * float(x + 7 * z) - std::floor(0.37f * float(x + 7 * z))});
    }
  }
  return plans;
}

std::vector<BezierState> randomStates(const BladeStore& blades, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<BezierState> states;
  for (const BladePlan& blade : blades.blades) {
    vec3 direction = randomUnit(random);
    if (glm::dot(direction, blade.up) < 0.0f) direction = -direction;
    states.push_back({glm::vec4(direction * blade.height * between(random, 0.3f, 1.2f), between(random, 0.0f, 2.0f))});
  }
  return states;
}

Collider ball(float radius, std::vector<ColliderKey> keys) {
  Collider collider;
  collider.radius = radius;
  collider.keys = std::move(keys);
  collider.loop = false;
  return collider;
}

float farthest(const std::vector<BezierState>& a, const std::vector<BezierState>& b, const BladeStore& blades) {
  float most = 0.0f;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, glm::length(vec3(a[i].tip - b[i].tip)) / blades.blades[i].height);
  }
  return most;
}

TEST_F(BezierPhysicsGpu, AStepIsTheSharedFunctionsOne) {
  const BladeStore blades(randomBlades(1, 700));
  BladeStore& changed = const_cast<BladeStore&>(blades);
  const glm::vec2 wind(5.0f, -3.0f);
  m_scene->blow(wind);
  m_scene->ambient = {};
  m_scene->ambient.speed = 0.0f;
  bezier.gravity = 1.3f;
  bezier.gravityDirection = {1.0f, -2.0f, 0.5f};
  bezier.centreBlend = 0.3f;
  bezier.gravityCentre = {1.0f, 4.0f, 0.0f};
  configure(blades);
  double time = 10.0;
  advance(blades, time);
  for (const float dt : {1.0f / 240.0f, 1.0f / 60.0f, 0.05f}) {
    const std::vector<BezierState> before = randomStates(blades, 2);
    changed.setStates(before);
    time += double{dt};
    advance(blades, time);
    const std::vector<BezierState> after = blades.states();
    const BezierPhysicsBlock block = makeBezierPhysicsBlock(project(), time);
    for (std::size_t i = 0; i < after.size(); ++i) {
      const BezierState wanted = stepped(before[i], blades.blades[i], block, {wind.x, 0.0f, wind.y}, {}, dt);
      ASSERT_LT(glm::length(after[i].tip - wanted.tip), 1e-4f) << "blade " << i << " after " << dt << " s";
    }
  }
}

TEST_F(BezierPhysicsGpu, WavesAreTheSharedFunctionsOnes) {
  BladeStore blades(randomBlades(3, 256));
  m_scene->blow({4.0f, 0.0f});
  bezier.wind = BezierWind::Waves;
  configure(blades);
  advance(blades, 7.0);
  const std::vector<BezierState> before = randomStates(blades, 4);
  blades.setStates(before);
  advance(blades, 7.0 + kFrame);
  const std::vector<BezierState> after = blades.states();
  const BezierPhysicsBlock block = makeBezierPhysicsBlock(project(), 7.0 + kFrame);
  for (std::size_t i = 0; i < after.size(); ++i) {
    glm::vec2 wind(0.0f);
    for (const glm::vec4& wave : block.waves)
      wind += shared::bezierWave(wave, {blades.blades[i].root.x, blades.blades[i].root.z});
    const BezierState wanted = stepped(before[i], blades.blades[i], block, {wind.x, 0.0f, wind.y}, {}, float(kFrame));
    ASSERT_LT(glm::length(after[i].tip - wanted.tip), 1e-4f) << i;
  }
}

TEST_F(BezierPhysicsGpu, CollisionsAreTheSharedFunctionsOnes) {
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

TEST_F(BezierPhysicsGpu, BladesAreKeptOutOfABallThatRollsOverThem) {
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

TEST_F(BezierPhysicsGpu, ABallLeavesATrailThatRisesInTheTimeItsStrengthGives) {
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

TEST_F(BezierPhysicsGpu, AFastBallMissesNoBlade) {
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

TEST_F(BezierPhysicsGpu, PatchesThatAreNotSeenSleepAndCatchUp) {
  const std::vector<BladePlan> plans = randomBlades(8, 600);
  BladeStore awake(plans), asleep(plans);
  bezier.gravity = 0.5f;
  m_scene->blow({6.0f, 2.0f});
  auto other = physics();
  configure(awake);
  ASSERT_TRUE(other->configure(asleep.store()).ok());
  advance(awake, 0.0);
  advance(*other, asleep, 0.0);
  const std::vector<BezierState> start = randomStates(awake, 9);
  awake.setStates(start);
  asleep.setStates(start);
  asleep.setSeen(false);
  double time = 0.0;
  for (int i = 1; i <= 90; ++i) {
    time = i * kFrame;
    advance(awake, time);
    advance(*other, asleep, time);
  }
  const std::vector<BezierState> slept = asleep.states();
  for (std::size_t i = 0; i < start.size(); ++i) ASSERT_EQ(slept[i].tip, start[i].tip) << "nothing moves it";
  asleep.setSeen(true);
  advance(*other, asleep, time);  // time stands: the camera turned
  EXPECT_LT(farthest(awake.states(), asleep.states(), awake), 0.02f);
}

TEST_F(BezierPhysicsGpu, ATouchedPatchIsSteppedThoughNobodySeesIt) {
  BladeStore blades(lawn({-0.8f, -0.8f}, {16, 16}, 0.1f));
  colliders = {ball(0.5f, {{0.0f, {-3, 0, 0}}, {2.0f, {5, 0, 0}}})};
  blades.setSeen(false);
  configure(blades);
  double time = 0.0;
  for (; time < 1.3; time += kFrame) advance(blades, time);
  float strongest = 0.0f;
  for (const BezierState& state : blades.states()) strongest = std::max(strongest, state.tip.w);
  EXPECT_GT(strongest, 0.8f);
}

TEST_F(BezierPhysicsGpu, AJumpInTimeGivesWhatPlayingGives) {
  const std::vector<BladePlan> plans = lawn({-2.0f, -1.0f}, {40, 20}, 0.1f);
  const BladeStore played(plans), jumped(plans), hurried(plans);
  m_scene->blow({5.0f, 1.0f});
  bezier.gravity = 0.6f;
  colliders = {ball(0.5f, {{0.0f, {-3, 0, 0}}, {6.0f, {3, 0, 0}}})};
  configure(played);
  for (int i = 0; i <= 240; ++i) advance(played, i * kFrame);
  const double now = 240 * kFrame;
  auto late = physics();
  ASSERT_TRUE(late->configure(jumped.store()).ok());
  advance(*late, jumped, now);
  const std::vector<BezierState> full = played.states(), other = jumped.states();
  // The steps lie elsewhere, which blades in the very middle of the ball's way feel.
  EXPECT_LT(farthest(full, other, played), 0.2f);
  const auto alike = [&](const std::vector<BezierState>& states, float part) {
    int count = 0;
    for (std::size_t i = 0; i < full.size(); ++i)
      count += glm::length(vec3(full[i].tip - states[i].tip)) < part * 0.5f ? 1 : 0;
    return float(count) / float(full.size());
  };
  EXPECT_GT(alike(other, 0.02f), 0.97f);
  auto quick = physics();
  ASSERT_TRUE(quick->configure(hurried.store()).ok());
  advance(*quick, hurried, now, true);
  const float part = alike(hurried.states(), 0.06f);
  EXPECT_GT(part, 0.6f);
  EXPECT_LT(part, 1.0f) << "a part of the trail is missing";
}

TEST_F(BezierPhysicsGpu, FramesOfAnyRateGiveTheSamePose) {
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

TEST_F(BezierPhysicsGpu, OnWallsAndUpsideDownTheWindBlowsAlongTheSurface) {
  m_scene->blow({6.0f, 0.0f});
  bezier.wind = BezierWind::Field;
  const vec3 ups[] = {{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {-1, 0, 0}, glm::normalize(vec3(-1, 0.4f, 0))};
  std::vector<BladePlan> plans;
  for (const vec3& up : ups) plans.push_back({{0, 2, 0}, up, 0.4f, 1.0f, 0.2f});
  const BladeStore blades(plans);
  configure(blades);
  advance(blades, 5.0);
  const std::vector<BezierState> states = blades.states();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(states[i].tip.x, 0.05f) << "along it, " << i;
    EXPECT_GT(glm::dot(vec3(states[i].tip), ups[i]), 0.04f);
    EXPECT_NEAR(states[i].tip.x, states[0].tip.x, 1e-3f) << "whichever way is up";
  }
  EXPECT_LT(glm::length(vec3(states[3].tip) - 0.4f * ups[3]), 1e-3f) << "against a wall it comes to rest";
  const vec3 slid = vec3(states[4].tip) - ups[4] * glm::dot(vec3(states[4].tip), ups[4]);
  EXPECT_GT(slid.y, 0.005f) << "and goes up a steep one";
}

TEST_F(BezierPhysicsGpu, GravityPullsBladesOfACeilingDownAndBallsOfFurToTheirMiddle) {
  bezier.gravity = 2.0f;
  bezier.frontGravity = 0.0f;
  const BladeStore blades(
      {{{0, 2, 0}, glm::normalize(vec3(1, 0.2f, 0)), 0.4f, 1.0f, 0.2f}, {{0, 2, 0}, {0, -1, 0}, 0.4f, 1.0f, 0.2f}});
  configure(blades);
  advance(blades, 1.0);
  std::vector<BezierState> states = blades.states();
  EXPECT_LT(states[0].tip.y, -0.02f) << "on a wall it hangs";
  EXPECT_LT(glm::length(vec3(states[1].tip) - vec3(0, -0.4f, 0)), 1e-3f);
  bezier.centreBlend = 1.0f;
  bezier.centreGravity = 2.0f;
  bezier.gravityCentre = {0, 5, 0};
  edit();
  advance(blades, 1.0);  // an edit while time stands
  states = blades.states();
  EXPECT_GT(states[0].tip.y, 0.15f) << "towards the centre above it";
}

TEST_F(BezierPhysicsGpu, RotorsBlowBladesOutwards) {
  Rotor rotor;
  rotor.lift = 6.0f;
  rotor.radius = 3.0f;
  rotor.rings = 0.0f;
  m_scene->rotors = {rotor};
  bezier.wind = BezierWind::Waves;
  bezier.waveStrength = 0.0f;
  std::vector<BladePlan> plans;
  for (int i = 0; i < 8; ++i)
    plans.push_back({{3.0f * std::cos(0.8f * float(i)), 0.0f, 3.0f * std::sin(0.8f * float(i))}});
  const BladeStore blades(plans);
  configure(blades);
  advance(blades, 2.0);
  const std::vector<BezierState> states = blades.states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    EXPECT_GT(glm::dot(vec3(states[i].tip), glm::normalize(blades.blades[i].root)), 0.1f) << i;
  }
}

TEST_F(BezierPhysicsGpu, AMeshOfAThousandSpheresIsMetTheSameWayEachTime) {
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

TEST_F(BezierPhysicsGpu, BladesThatAreShownAgainStandInTheWind) {
  BladeStore blades(randomBlades(14, 256));
  m_scene->blow({5.0f, 0.0f});
  blades.kept = 64;
  configure(blades);
  advance(blades, 1.0);
  std::vector<BezierState> states = blades.states();
  EXPECT_GT(glm::length(vec3(states[63].tip)), 0.05f);
  EXPECT_EQ(states[64].tip, glm::vec4(0.0f)) << "those not shown are left alone";
  blades.kept = 256;
  advance(blades, 1.0);
  const std::vector<BezierState> more = blades.states();
  const BladeStore all(randomBlades(14, 256));
  configure(all);
  advance(all, 1.0);
  EXPECT_LT(farthest(more, all.states(), all), 0.01f);
}

TEST_F(BezierPhysicsGpu, ANewStoreForgets) {
  BladeStore blades(randomBlades(15, 256));
  configure(blades);
  advance(blades, 1.0);
  blades.setStates(randomStates(blades, 16));
  configure(blades);
  advance(blades, 1.0 + kFrame);
  const std::vector<BezierState> states = blades.states();
  for (std::size_t i = 0; i < states.size(); ++i) {
    const vec3 rest = blades.blades[i].up * blades.blades[i].height;
    ASSERT_LT(glm::length(states[i].tip - glm::vec4(rest, 0.0f)), 1e-3f) << i;
  }
  EXPECT_TRUE(m_physics->configure(BezierStore{}).ok());
  m_physics->advance(project(), BezierStore{}, 2.0, false);
}

}  // namespace
}  // namespace windloom
