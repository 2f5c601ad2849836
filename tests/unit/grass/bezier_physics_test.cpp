#include "engine/grass/bezier_physics.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/grass/bezier_reference.hpp"

namespace windloom {
namespace {

namespace paper = testing::paper;
using glm::dvec3;
using glm::vec3;
using shared::BezierCurve;
using shared::BezierForces;
using shared::BezierMotion;

class Sample {
 public:
  explicit Sample(unsigned seed) : m_random(seed) {}
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(m_random); }
  dvec3 unit() { return paper::randomUnit(m_random); }
  /// Over the plane of `up`.
  dvec3 above(dvec3 up) {
    const dvec3 found = unit();
    return glm::dot(found, up) < 0.0 ? -found : found;
  }
  paper::Blade blade() {
    paper::Blade blade;
    blade.root = unit() * between(0.0, 20.0);
    blade.up = unit();
    blade.front = vec3(shared::bezierFront(blade.up, shared::bezierAcross(blade.up, float(between(0.0, 1.0)))));
    blade.height = between(0.05, 2.0);
    blade.stiffness = between(0.5, 80.0);
    return blade;
  }
  paper::World world() {
    paper::World world;
    world.direction = unit() * between(0.1, 3.0);
    world.gravity = between(0.0, 4.0);
    world.centre = unit() * between(1.0, 40.0);
    world.centreGravity = between(0.0, 4.0);
    world.blend = between(0.0, 1.0);
    world.frontPart = between(0.0, 0.5);
    world.wind = unit() * between(0.0, 8.0);
    world.fade = between(0.0, 2.0);
    return world;
  }

 private:
  std::mt19937 m_random;
};

BezierForces forcesOf(const paper::Blade& blade, const paper::World& world) {
  BezierForces forces;
  forces.up = blade.up;
  forces.front = blade.front;
  const dvec3 pull = world.direction / glm::length(world.direction) * world.gravity * (1.0 - world.blend);
  forces.gravity = shared::bezierGravity(glm::vec4(glm::dvec4(pull, world.frontPart)),
                                         glm::vec4(glm::dvec4(world.centre, world.centreGravity * world.blend)),
                                         blade.root, blade.front);
  forces.wind = world.wind;
  forces.recovery = float(blade.stiffness);
  return forces;
}

/// A frame as bezier_step does it; returns the tip over the height.
BezierMotion frame(const BezierForces& forces, BezierMotion motion, float fade, float seconds) {
  const float parts = shared::bezierParts(seconds, forces.wind);
  for (float i = 0; i < parts; ++i) motion = shared::bezierSwing(forces, motion, fade, seconds / parts);
  return motion;
}

vec3 tipOf(const BezierForces& forces, const BezierMotion& motion) {
  return shared::bezierCurveOf(motion.direction, forces.up, 1.0f).tip;
}

void expectNear(dvec3 got, dvec3 wanted, double tolerance, const std::string& what) {
  EXPECT_LT(glm::length(got - wanted), tolerance) << what;
}

TEST(BezierEquations, ForcesAreThePapers) {
  Sample sample(1);
  for (int n = 0; n < 2000; ++n) {
    const paper::Blade blade = sample.blade();
    const paper::World world = sample.world();
    const BezierForces forces = forcesOf(blade, world);
    const std::string which = "blade " + std::to_string(n);
    const double strength = sample.between(0.0, 2.0), dt = sample.between(0.0, 0.1);
    EXPECT_NEAR(shared::bezierFaded(float(strength), float(world.fade), float(dt)),
                paper::faded(strength, world.fade, dt), 1e-6)
        << which << ", eq. 2";
    expectNear(forces.gravity, paper::gravity(blade, world), 1e-4, which + ", eq. 4-6");
    const dvec3 tip = sample.above(blade.up) * sample.between(0.1, 1.0);
    EXPECT_NEAR(shared::bezierWindPart(world.wind, tip, blade.up), paper::theta(blade, world.wind, tip * blade.height),
                1e-4)
        << which << ", eq. 7";
  }
}

TEST(BezierEquations, TheWholePullIsThePapersButForWhatStretches) {
  Sample sample(2);
  for (int n = 0; n < 2000; ++n) {
    const paper::Blade blade = sample.blade();
    const paper::World world = sample.world();
    const dvec3 direction = sample.above(blade.up);
    const double strength = sample.between(0.0, 2.0);
    const BezierForces forces = forcesOf(blade, world);
    const double reach = shared::bezierReach(direction, blade.up);
    const dvec3 wanted = paper::forces(blade, world, direction * reach * blade.height, strength) / blade.height;
    const dvec3 got = shared::bezierPull(forces, direction, float(strength));
    const auto turning = [&](dvec3 pull) { return pull - direction * glm::dot(pull, direction); };
    expectNear(turning(got), turning(wanted), 1e-4 * std::max(1.0, glm::length(wanted)),
               "eq. 1 and 3, " + std::to_string(n));
  }
}

TEST(BezierEquations, CurveIsThePapers) {
  Sample sample(3);
  for (int n = 0; n < 2000; ++n) {
    const paper::Blade blade = sample.blade();
    const dvec3 tip = sample.unit() * sample.between(0.05, 2.0) * blade.height;
    const BezierCurve got = shared::bezierValid(tip, blade.up, float(blade.height));
    const paper::Curve wanted = paper::valid(blade, tip);
    expectNear(got.middle, wanted.v1, 1e-4 * blade.height, "v1, eq. 9-13");
    expectNear(got.tip, wanted.v2, 1e-4 * blade.height, "v2, eq. 9-13");
  }
}

TEST(BezierEquations, CollisionsAreThePapers) {
  Sample sample(4);
  int tips = 0, middles = 0;
  for (int n = 0; n < 4000; ++n) {
    const paper::Blade blade = sample.blade();
    const dvec3 direction = sample.above(blade.up);
    const BezierCurve curve = shared::bezierCurveOf(direction, blade.up, float(blade.height));
    const paper::Curve same{curve.middle, curve.tip};
    const dvec3 centre = blade.root + (blade.up * 0.5 + sample.unit()) * blade.height;
    const double radius = sample.between(0.1, 1.2) * blade.height;
    const glm::vec4 sphere{vec3(centre), float(radius)};
    const dvec3 atTip = paper::translation(centre, radius, blade.root + same.v2);
    const dvec3 atMiddle = paper::translation(centre, radius, paper::middle(blade, same));
    tips += glm::length(atTip) > 0.0 ? 1 : 0;
    middles += glm::length(atMiddle) > 0.0 ? 1 : 0;
    const vec3 got = shared::bezierHit({sphere, sphere}, blade.root, curve);
    expectNear(got, atTip + 4.0 * atMiddle, 1e-4, "eq. 14 and 15");
    const double once = glm::dot(atTip + 4.0 * atMiddle, atTip + 4.0 * atMiddle) / (blade.height * blade.height);
    // Over the measures of time and strength, what is left is eq. 16.
    EXPECT_NEAR(shared::bezierGain(got, float(blade.height), 1.0f, BEZIER_CONTACT_S), once, 1e-4 * std::max(1.0, once));
  }
  EXPECT_GT(tips, 500);
  EXPECT_GT(middles, 500);
}

TEST(BezierEquations, WithoutWindThetaIsNought) {
  EXPECT_EQ(shared::bezierWindPart(vec3(0.0f), {0.1f, 0.9f, 0.0f}, {0.0f, 1.0f, 0.0f}), 0.0f);
  EXPECT_EQ(shared::bezierWindPart({0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}), 0.0f)
      << "wind along a blade doesn't bend it";
  EXPECT_NEAR(shared::bezierWindPart({2.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}), 1.0f, 1e-6f);
}

TEST(BezierReach, IsWhereValidationChangesNothing) {
  Sample sample(5);
  for (int n = 0; n < 2000; ++n) {
    paper::Blade blade = sample.blade();
    const dvec3 direction = sample.above(blade.up);
    const float reach = shared::bezierReach(direction, blade.up);
    EXPECT_GE(reach, 0.95f);
    EXPECT_LE(reach, 1.00001f);
    const dvec3 tip = direction * double(reach) * blade.height;
    expectNear(paper::valid(blade, tip).v2, tip, 1e-4 * blade.height, "a second validation");
    // And where doing it again and again leads.
    dvec3 again = direction * sample.between(0.6, 1.5) * blade.height;
    for (int i = 0; i < 200; ++i) again = paper::valid(blade, again).v2;
    expectNear(again, tip, 2e-3 * blade.height, "many validations");
  }
}

TEST(BezierReach, StatesErrorOfTheApproximateLength) {
  // Eq. 12 against the curve's own length, over all directions that a blade can have.
  double largest = 0.0, sum = 0.0;
  int count = 0;
  const paper::Blade blade;
  for (double angle = 0.0; std::cos(angle) >= double(BEZIER_LOWEST); angle += 0.002) {
    const dvec3 direction(std::sin(angle), std::cos(angle), 0.0);
    const BezierCurve curve = shared::bezierCurveOf(direction, blade.up, 1.0f);
    const double error = std::abs(paper::trueLength({curve.middle, curve.tip}) - 1.0);
    largest = std::max(largest, error);
    sum += error;
    ++count;
  }
  EXPECT_NEAR(largest, 0.0099, 1e-4);
  EXPECT_NEAR(sum / count, 0.0045, 1e-4);
}

TEST(BezierMotion, KeepsLengthAndStaysOverTheGroundWhateverTheForces) {
  Sample sample(6);
  for (int n = 0; n < 400; ++n) {
    const paper::Blade blade = sample.blade();
    paper::World world = sample.world();
    world.gravity *= n % 4 == 0 ? 50.0 : 1.0;
    world.wind *= n % 3 == 0 ? 10.0 : 1.0;
    const BezierForces forces = forcesOf(blade, world);
    BezierMotion motion{vec3(sample.above(blade.up)), float(sample.between(0.0, 2.0))};
    motion.direction = shared::bezierRaised(motion.direction, forces.up, forces.front);
    for (int step = 0; step < 60; ++step) {
      motion = frame(forces, motion, float(world.fade), float(sample.between(0.001, 0.1)));
      const vec3 tip = tipOf(forces, motion) * float(blade.height);
      ASSERT_GE(glm::dot(tip, vec3(blade.up)), 0.09f * float(blade.height)) << n;
      const BezierCurve drawn = shared::bezierValid(tip, blade.up, float(blade.height));
      ASSERT_NEAR(paper::trueLength({drawn.middle, drawn.tip}), blade.height, 0.01 * blade.height) << n;
      ASSERT_LE(glm::length(drawn.tip), 1.001f * float(blade.height));
    }
  }
}

TEST(BezierMotion, FollowsThePapersStepsWhenThoseAreSmall) {
  Sample sample(7);
  for (int n = 0; n < 24; ++n) {
    paper::Blade blade = sample.blade();
    blade.stiffness = n % 2 == 0 ? sample.between(1.0, 8.0) : sample.between(8.0, 80.0);
    const paper::World world = sample.world();
    const BezierForces forces = forcesOf(blade, world);
    dvec3 direction = sample.above(blade.up);
    if (glm::dot(direction, blade.up) < 0.3) direction = glm::normalize(direction + blade.up);
    BezierMotion motion{vec3(direction), float(sample.between(0.0, 2.0))};
    double eta = double(motion.strength);
    dvec3 tip = dvec3(tipOf(forces, motion)) * blade.height;
    constexpr int kSmall = 1000;
    for (int step = 0; step < 60; ++step) {
      motion = frame(forces, motion, float(world.fade), 1.0f / 60.0f);
      for (int i = 0; i < kSmall; ++i) tip = paper::step(blade, world, tip, eta, 1.0 / (60.0 * kSmall));
      // Flatter ones lie on the ground, which the paper's may go into.
      if (glm::dot(tip, blade.up) < 0.12 * blade.height) break;
      expectNear(tipOf(forces, motion), tip / blade.height, 0.005,
                 "blade " + std::to_string(n) + " step " + std::to_string(step));
    }
  }
}

/// Tips over the height after 2 s of a gusty wind, by frames as `next` gives them.
vec3 afterTwoSeconds(const BezierForces& still, vec3 wind, float fade, const std::function<double(double)>& next) {
  BezierForces forces = still;
  BezierMotion motion{forces.up, 1.5f};
  motion.direction = glm::normalize(forces.up + 0.8f * forces.front);
  for (double time = 0.0; time < 2.0 - 1e-9;) {
    const double dt = std::min(next(time), 2.0 - time);
    forces.wind = wind * float(0.6 + 0.4 * std::sin(3.0 * (time + 0.5 * dt)));
    motion = frame(forces, motion, fade, float(dt));
    time += dt;
  }
  return tipOf(forces, motion);
}

TEST(BezierMotion, IsTheSameAt30And60And240HzAndWithSpikes) {
  Sample sample(8);
  double largest = 0.0;
  for (int n = 0; n < 300; ++n) {
    const paper::Blade blade = sample.blade();
    const paper::World world = sample.world();
    const BezierForces forces = forcesOf(blade, world);
    const auto at = [&](const std::function<double(double)>& next) {
      return afterTwoSeconds(forces, world.wind, float(world.fade), next);
    };
    const vec3 fine = at([](double) { return 1.0 / 240.0; });
    const vec3 others[] = {at([](double) { return 1.0 / 30.0; }), at([](double) { return 1.0 / 60.0; }),
                           at([](double time) { return std::fmod(time, 0.5) < 0.02 ? 0.1 : 1.0 / 60.0; })};
    for (const vec3& other : others) largest = std::max(largest, double(glm::length(other - fine)));
  }
  EXPECT_LT(largest, 0.005) << "the bar is 0.02";
}

TEST(BezierMotion, IsStableForLongStepsAndStiffBlades) {
  Sample sample(9);
  for (int n = 0; n < 200; ++n) {
    paper::Blade blade = sample.blade();
    blade.stiffness = 80.0;
    const paper::World world = sample.world();
    const BezierForces forces = forcesOf(blade, world);
    BezierMotion motion{forces.up, 0.0f};
    for (int i = 0; i < 40; ++i) motion = frame(forces, motion, 1.0f, 0.1f);
    const BezierMotion rest = motion;
    for (int i = 0; i < 3; ++i) {
      motion = frame(forces, motion, 1.0f, 0.1f);
      ASSERT_LT(glm::length(motion.direction - rest.direction), 1e-3f) << "it neither rings nor creeps, " << n;
    }
  }
}

TEST(BezierMotion, ABladePressedStraightDownTipsOverToItsFront) {
  BezierForces forces{{0, 1, 0}, {1, 0, 0}, {0, -30, 0}, vec3(0.0f), 4.0f};
  forces.gravity.x = 0.01f;
  BezierMotion motion{forces.up, 0.0f};
  for (int i = 0; i < 120; ++i) motion = frame(forces, motion, 1.0f, 1.0f / 60.0f);
  EXPECT_NEAR(motion.direction.x, 0.995f, 1e-3f);
  EXPECT_NEAR(shared::bezierRaised({0, -1, 0}, forces.up, forces.front).x, 0.995f, 1e-3f);
  EXPECT_EQ(shared::bezierDirection(vec3(0.0f), forces.up, forces.front), forces.up);
}

TEST(BezierMotion, RisesAfterTheTimeThatItsStrengthGives) {
  const float fade = 0.5f;
  BezierForces forces{{0, 1, 0}, {1, 0, 0}, vec3(0.0f), vec3(0.0f), 20.0f};
  const vec3 low = shared::bezierRaised({1, 0, 0}, forces.up, forces.front);
  for (const float strength : {0.0f, 1.0f, 1.5f, BEZIER_STRENGTH_MOST}) {
    BezierMotion motion{low, strength};
    float time = 0.0f;
    while (motion.direction.y < 0.9f && time < 20.0f) {
      motion = frame(forces, motion, fade, 1.0f / 60.0f);
      time += 1.0f / 60.0f;
    }
    // From tan(phi/2) falling by the integral of s max(1 - eta, 0.1), the reach being about 0.97.
    const double wanted = std::log(std::tan(0.5 * std::acos(0.1)) / std::tan(0.5 * std::acos(0.9))) * 0.97;
    double sum = 0.0, expected = 0.0;
    for (; sum < wanted; expected += 1e-4)
      sum += 20.0 * std::max(1.0 - paper::faded(strength, 0.5, expected), 0.1) * 1e-4;
    EXPECT_NEAR(double(time), expected, 0.03 + 0.03 * expected) << strength;
    EXPECT_LT(time, 1.1f / fade * (strength / BEZIER_STRENGTH_MOST) + 1.0f);
  }
}

TEST(BezierMotion, ContactGainsTheSameStrengthWhateverTheLengthOfItsSteps) {
  // Moved by its height within 0.2 s.
  const auto gained = [](int steps) {
    float sum = 0.0f;
    for (int i = 0; i < steps; ++i)
      sum += shared::bezierGain(vec3(0.5f / float(steps), 0, 0), 0.5f, 2.0f, 0.2f / float(steps));
    return sum;
  };
  EXPECT_NEAR(gained(6), 2.0f * BEZIER_CONTACT_S / 0.2f, 1e-3f);
  EXPECT_NEAR(gained(48), gained(6), 1e-3f);
}

TEST(BezierSleep, CatchesUpToWhatFramesGive) {
  Sample sample(10);
  for (int n = 0; n < 200; ++n) {
    const paper::Blade blade = sample.blade();
    const paper::World world = sample.world();
    const BezierForces forces = forcesOf(blade, world);
    const float asleep = float(sample.between(0.05, 4.0)), fade = 0.6f;
    BezierMotion awake{glm::normalize(forces.up + forces.front), 1.2f}, woken = awake;
    for (int i = 0; i < 100; ++i) awake = frame(forces, awake, fade, asleep / 100.0f);
    const float part = shared::bezierWakePart(asleep, forces.wind);
    woken.strength = shared::bezierFaded(woken.strength, fade, asleep - part * BEZIER_WAKE_PARTS);
    for (float i = 0; i < BEZIER_WAKE_PARTS; ++i) woken = shared::bezierSwing(forces, woken, fade, part);
    EXPECT_LT(glm::length(awake.direction - woken.direction), 0.01f) << n << " after " << asleep;
    EXPECT_NEAR(awake.strength, woken.strength, 1e-4f);
  }
}

TEST(BezierMovers, GoFromTheBeginOfAStepToItsEnd) {
  const ColliderPrimitive from{{0, 1, 0, 0.5f}, {0, 1, 0, 0}}, to{{2, 1, 0, 0.5f}, {2, 1, 0, 0}};
  const std::vector<BezierMover> movers = bezierMovers(std::vector{from}, std::vector{to});
  ASSERT_EQ(movers.size(), 1u);
  EXPECT_EQ(shared::bezierMoverAt(movers[0], 0.25f).a, glm::vec4(0.5f, 1, 0, 0.5f));
  EXPECT_EQ(shared::bezierMoverAt(movers[0], 1.0f).b, to.b);
  EXPECT_EQ(bezierTouchParts(movers, 0.01f), 6.0f) << "a way of two metres for a radius of half of one";
  EXPECT_EQ(bezierTouchParts({}, 1.0f / 60.0f), 4.0f);
  const std::vector<BezierMover> added = bezierMovers({}, std::vector{to});
  EXPECT_EQ(added[0].a, to.a) << "a new one stands where it is";
}

TEST(BezierWaves, RunWithTheAmbientWind) {
  Project project;
  AmbientWind ambient;
  ambient.direction = 90.0f;
  project.ambient = std::make_shared<AmbientWind>(ambient);
  const auto wind = [&](glm::vec2 place, double seconds) {
    const BezierPhysicsBlock block = makeBezierPhysicsBlock(project, seconds);
    glm::vec2 sum(0.0f);
    for (const glm::vec4& wave : block.waves) sum += shared::bezierWave(wave, place);
    return sum;
  };
  const BezierSettings& bezier = *project.bezier;
  float strongest = 0.0f;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec2 place(0.37f * float(i % 50), 0.61f * float(i / 50));
    const glm::vec2 here = wind(place, 3.0);
    EXPECT_GE(here.y, 0.0f) << "never against the ambient wind";
    strongest = std::max(strongest, glm::length(here));
  }
  EXPECT_LE(strongest, bezier.waveStrength);
  EXPECT_GT(strongest, 0.7f * bezier.waveStrength);
  // The first wave alone comes by again where it runs to.
  const glm::vec4 now = makeBezierPhysicsBlock(project, 3.0).waves[0],
                  later = makeBezierPhysicsBlock(project, 4.0).waves[0];
  const glm::vec2 moved = glm::vec2(0.0f, bezier.waveSpeed);
  EXPECT_NEAR(shared::bezierWave(later, moved + glm::vec2(1, 2)).y, shared::bezierWave(now, {1, 2}).y, 1e-4f);
}

}  // namespace
}  // namespace windloom
