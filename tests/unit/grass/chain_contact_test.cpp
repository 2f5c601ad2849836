#include "shaders/shared/chain_contact.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <vector>

#include "tests/unit/grass/chain_fixture.hpp"

namespace windloom {
namespace {

using shared::ColliderPrimitive;
using shared::ContactChain;
using testing::axisOf;
constexpr int kSegments = CHAIN_SEGMENTS;

ColliderPrimitive ball(glm::vec3 centre, float radius) {
  return {glm::vec4(centre, radius), glm::vec4(centre, 0.0f)};
}

/// A blade of `height` that bends by `bend` as an arc.
ContactChain bladeOf(float height, glm::vec2 bend) {
  ContactChain chain{};
  for (int i = 0; i < kSegments; ++i) {
    chain.part[i] = axisOf(bend * shared::chainShare(i));
    chain.size[i] = height / kSegments;
  }
  return chain;
}

/// As step_patches.comp goes through all that touches a blade; none: it is hidden.
std::optional<ContactChain> afterContact(ContactChain chain, const std::vector<ColliderPrimitive>& primitives) {
  for (const ColliderPrimitive& primitive : primitives) {
    if (shared::rootInside(primitive)) return std::nullopt;
  }
  for (int pass = 0; pass < CONTACT_PASSES; ++pass) {
    bool clear = true;
    for (const ColliderPrimitive& primitive : primitives) {
      if (shared::chainDistance(chain, primitive) >= 0.97f * CONTACT_MARGIN) continue;
      chain = shared::bentOut(chain, primitive);
      clear = false;
    }
    if (clear) return chain;
  }
  for (const ColliderPrimitive& primitive : primitives) {
    if (shared::chainDistance(chain, primitive) < 0.9f * CONTACT_MARGIN) return std::nullopt;
  }
  return chain;
}

/// The least distance of densely sampled points of a blade to the primitives, m.
float leastDistance(const ContactChain& chain, const std::vector<ColliderPrimitive>& primitives) {
  float least = 1e9f;
  glm::vec3 start(0.0f);
  for (int i = 0; i < kSegments; ++i) {
    // The rotation in double precision: a check of the leans, too.
    const glm::vec3 along(testing::turnMatrix(glm::dvec3(shared::chainTurn(chain.lean[i]))) *
                          glm::dvec3(chain.part[i]));
    for (int n = 0; n <= 50; ++n) {
      const glm::vec3 point = start + along * (chain.size[i] * static_cast<float>(n) / 50.0f);
      for (const ColliderPrimitive& primitive : primitives)
        least = std::min(least, shared::colliderDistance(primitive, point));
    }
    start += along * chain.size[i];
  }
  return least;
}

struct Scene {
  ContactChain blade{};
  std::vector<ColliderPrimitive> primitives;
};

Scene randomScene(std::mt19937& random, int most) {
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  Scene scene;
  scene.blade = bladeOf(0.5f + 0.3f * unit(random), 0.9f * glm::vec2(unit(random), unit(random)));
  for (int n = 0; n < most; ++n) {
    const float radius = 0.25f + 0.2f * unit(random);
    const glm::vec3 a(0.7f * unit(random), radius + 0.2f * (1.0f + unit(random)), 0.7f * unit(random));
    const glm::vec3 way(0.4f * unit(random), 0.1f * unit(random), 0.4f * unit(random));
    scene.primitives.push_back({glm::vec4(a, radius), glm::vec4(n % 2 == 0 ? a : a + way, 0.0f)});
  }
  return scene;
}

TEST(ChainContact, LeanBetweenTurnsOneDirectionIntoTheOther) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (int n = 0; n < 500; ++n) {
    const glm::vec3 from = axisOf(glm::vec2(unit(random), unit(random)));
    const glm::vec3 to = glm::normalize(glm::vec3(unit(random), std::abs(unit(random)), unit(random)));
    const glm::vec3 got = shared::chainMatrix(shared::chainTurn(shared::leanBetween(from, to))) * from;
    EXPECT_LT(glm::length(got - to), 2e-4f) << n;
  }
}

TEST(ChainContact, NoPointStaysInABall) {
  std::mt19937 random(11);
  int bent = 0, hidden = 0, outside = 0;
  for (int n = 0; n < 3000; ++n) {
    const Scene scene = randomScene(random, 1);
    const bool inRoot = shared::rootInside(scene.primitives[0]);
    const auto after = afterContact(scene.blade, scene.primitives);
    if (!after) {
      hidden += inRoot ? 0 : 1;
      continue;
    }
    ASSERT_GT(leastDistance(*after, scene.primitives), 0.8f * CONTACT_MARGIN) << n;
    (after->bent != 0 ? bent : outside) += 1;
  }
  EXPECT_GT(bent, 200);
  EXPECT_GT(outside, 500);
  EXPECT_LT(hidden, 30) << "a single ball leaves a way out";
}

TEST(ChainContact, NoPointStaysInCapsulesAndHeapsOfBalls) {
  std::mt19937 random(12);
  int bent = 0, hidden = 0;
  for (int n = 0; n < 3000; ++n) {
    const Scene scene = randomScene(random, 2 + n % 4);
    const auto after = afterContact(scene.blade, scene.primitives);
    if (!after) {
      ++hidden;
      continue;
    }
    ASSERT_GT(leastDistance(*after, scene.primitives), 0.75f * CONTACT_MARGIN) << n;
    bent += after->bent != 0 ? 1 : 0;
  }
  EXPECT_GT(bent, 500);
  EXPECT_LT(hidden, 2000);
}

TEST(ChainContact, LeavesBladesAloneThatNothingTouches) {
  const ContactChain blade = bladeOf(0.5f, {0.3f, 0.1f});
  const ContactChain after = shared::bentOut(blade, ball({1.5f, 0.4f, 0.0f}, 0.4f));
  EXPECT_EQ(after.bent, 0u);
  for (int i = 0; i < kSegments; ++i) EXPECT_EQ(after.lean[i], blade.lean[i]);
}

TEST(ChainContact, BladesUnderABallLieDownAwayFromWhereItStands) {
  const float radius = 0.5f;
  float before = 10.0f;
  for (const float away : {0.12f, 0.2f, 0.3f, 0.4f}) {
    const std::vector<ColliderPrimitive> primitives{ball({-away, radius, 0.0f}, radius)};
    const auto after = afterContact(bladeOf(0.55f, {}), primitives);
    ASSERT_TRUE(after.has_value()) << away;
    const float lean = after->lean[3].x;
    EXPECT_GT(lean, 0.3f) << "away from the ball, which lies towards -x";
    EXPECT_LT(lean, 1.571f) << "and over the ground";
    EXPECT_NEAR(after->lean[3].y, 0.0f, 1e-3f);
    EXPECT_LT(lean, before) << "less the farther away";
    before = lean;
  }
}

TEST(ChainContact, TurnsNoFurtherThanItMust) {
  // The segment just touches the ball afterwards.
  const ColliderPrimitive sphere = ball({0.2f, 0.3f, 0.0f}, 0.25f);
  const auto after = afterContact(bladeOf(0.6f, {0.4f, 0.0f}), {sphere});
  ASSERT_TRUE(after.has_value());
  ASSERT_NE(after->bent, 0u);
  EXPECT_NEAR(shared::chainDistance(*after, sphere), CONTACT_MARGIN, 0.3f * CONTACT_MARGIN);
}

TEST(ChainContact, HidesBladesWhoseRootIsInside) {
  EXPECT_FALSE(afterContact(bladeOf(0.5f, {}), {ball({0.1f, 0.2f, 0.0f}, 0.3f)}).has_value());
}

}  // namespace
}  // namespace windloom
