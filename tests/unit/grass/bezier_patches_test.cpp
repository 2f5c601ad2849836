// Patches of Bezier grass: their boxes, their order, and the order of the blades in them.
#include <gtest/gtest.h>

#include <random>
#include <span>

#include "tests/unit/grass/bezier_fixture.hpp"

namespace windloom {
namespace {

using namespace testing;

struct PatchesTest : ::testing::Test {
  static const BezierMeadow& meadow() {
    static const BezierMeadow kMeadow = [] {
      BezierScene scene = sceneOf(SurfaceShape::Hare, 3.0f, 4000.0f);
      Surface band = scene.surfaces[0];
      band.id = 6;
      band.shape = SurfaceShape::Moebius;
      band.position = {6.0f, 3.0f};
      scene.surfaces.push_back(band);
      scene.grass.density = 60.0f;
      scene.grass.slopeAlign = 1.0f;
      scene.heights = heightsFrom({129, 129}, {60, 60},
                                  [](glm::vec2 at) { return 2.0f * std::sin(0.3f * at.x) + std::cos(0.4f * at.y); });
      return scene.place();
    }();
    return kMeadow;
  }
  static std::span<const BezierBlade> bladesOf(std::size_t patch) {
    return {&meadow().blades[patch * BEZIER_PATCH], static_cast<std::size_t>(meadow().patches[patch].centre.w)};
  }
};

TEST_F(PatchesTest, HoldTheBladesThatTheySayAndFillUpWithNone) {
  ASSERT_GT(meadow().patches.size(), 400u);
  int notFull = 0;
  for (std::size_t p = 0; p < meadow().patches.size(); ++p) {
    const auto blades = bladesOf(p);
    for (std::size_t i = 0; i < BEZIER_PATCH; ++i)
      ASSERT_EQ(heightOf(meadow().blades[p * BEZIER_PATCH + i]) > 0.0f, i < blades.size());
    notFull += blades.size() < BEZIER_PATCH ? 1 : 0;
  }
  EXPECT_LE(notFull, 3) << "one at the end of the ground and of each surface";
}

TEST_F(PatchesTest, NeverMixGroundAndSurfaces) {
  float last = -1.0f;
  for (const BezierPatch& patch : meadow().patches) {
    ASSERT_TRUE(patch.reach.w == -1.0f || patch.reach.w == 0.0f || patch.reach.w == 1.0f);
    ASSERT_GE(patch.reach.w, last);
    last = patch.reach.w;
  }
  EXPECT_EQ(last, 1.0f);
}

TEST_F(PatchesTest, HoldTheirBladesHoweverTheyMove) {
  std::mt19937 random(4);
  std::normal_distribution<float> any(0.0f, 1.0f);
  float furthest = 0.0f;
  for (std::size_t p = 0; p < meadow().patches.size(); p += 3) {
    const glm::vec3 centre(meadow().patches[p].centre), reach(meadow().patches[p].reach);
    for (const BezierBlade& blade : bladesOf(p)) {
      const glm::vec3 up = upOf(blade), root = rootOf(blade);
      const float height = heightOf(blade), width = sizesOf(blade).y;
      const glm::vec3 across = shared::bezierAcross(up, static_cast<float>(blade.growth >> 16) / 65535.0f);
      for (int n = 0; n < 6; ++n) {
        const glm::vec3 force(any(random), any(random), any(random));
        const float strength = n == 0 ? 1e-4f : n == 1 ? 100.0f : height;
        const shared::BezierCurve curve = shared::bezierValid(force * strength, up, height);
        for (int v = 0; v <= 8; ++v) {
          const glm::vec3 point = shared::bezierPoint(curve, static_cast<float>(v) / 8.0f);
          furthest = std::max(furthest, glm::length(point) / height);
          ASSERT_GE(glm::dot(point, up), -1e-4f * height) << "above its plane";
          for (const float side : {-1.0f, 1.0f}) {
            const glm::vec3 away = glm::abs(root + point + across * (side * width) - centre);
            ASSERT_TRUE(glm::all(glm::lessThanEqual(away, reach)));
          }
        }
      }
    }
  }
  EXPECT_LT(furthest, kBladeReach);
  EXPECT_GT(furthest, 0.9f) << "blades do move";
}

TEST_F(PatchesTest, AreCompact) {
  // Against the same blades dealt out at random.
  std::vector<BezierBlade> shuffled;
  double own = 0;
  int patches = 0;
  for (std::size_t p = 0; p < meadow().patches.size() && meadow().patches[p].reach.w < 0.0f; ++p, ++patches) {
    const auto blades = bladesOf(p);
    shuffled.insert(shuffled.end(), blades.begin(), blades.end());
    const glm::vec4 reach = meadow().patches[p].reach;
    own += static_cast<double>(reach.x * reach.z);
  }
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(2));
  double dealt = 0;
  for (int p = 0; p + 1 < patches; ++p) {
    const BezierPatch patch = patchAround(&shuffled[static_cast<std::size_t>(p) * BEZIER_PATCH], BEZIER_PATCH, -1);
    dealt += static_cast<double>(patch.reach.x * patch.reach.z);
  }
  EXPECT_LT(own, 0.03 * dealt);
  // On a surface as well, whose blades fill no plane.
  double hare = 0, counted = 0;
  for (const BezierPatch& patch : meadow().patches) {
    if (patch.reach.w != 0.0f) continue;
    hare += static_cast<double>(std::max({patch.reach.x, patch.reach.y, patch.reach.z}));
    ++counted;
  }
  EXPECT_LT(hare / counted, 0.5) << "of a hare 3 m high";
}

TEST_F(PatchesTest, StandInMortonOrder) {
  // The way from patch to patch is short.
  double way = 0, random = 0;
  std::mt19937 any(3);
  int count = 0;
  for (std::size_t p = 1; p < meadow().patches.size() && meadow().patches[p].reach.w < 0.0f; ++p, ++count) {
    way += static_cast<double>(
        glm::distance(glm::vec3(meadow().patches[p].centre), glm::vec3(meadow().patches[p - 1].centre)));
    random += static_cast<double>(
        glm::distance(glm::vec3(meadow().patches[p].centre), glm::vec3(meadow().patches[any() % p].centre)));
  }
  EXPECT_LT(way, 0.2 * random);
}

TEST_F(PatchesTest, AnyFirstPartOfTheBladesCoversThePatch) {
  for (const std::size_t part : {4u, 16u, 50u, 128u, 200u}) {
    double own = 0, chance = 0;
    for (std::size_t p = 0; p < meadow().patches.size(); ++p) {
      const auto blades = bladesOf(p);
      if (blades.size() < BEZIER_PATCH) continue;
      // Mean place of the first ones against that of all, beside what chance would give.
      glm::dvec3 all(0.0), some(0.0), squares(0.0);
      for (std::size_t i = 0; i < blades.size(); ++i) {
        const glm::dvec3 root(rootOf(blades[i]));
        all += root / 256.0;
        if (i < part) some += root / static_cast<double>(part);
      }
      for (const BezierBlade& blade : blades)
        squares += (glm::dvec3(rootOf(blade)) - all) * (glm::dvec3(rootOf(blade)) - all) / 256.0;
      const glm::dvec3 off = some - all;
      own += glm::dot(off, off);
      chance +=
          (squares.x + squares.y + squares.z) / static_cast<double>(part) * (1.0 - static_cast<double>(part) / 256.0);
    }
    EXPECT_LT(own, 0.5 * chance) << part;
  }
}

}  // namespace
}  // namespace windloom
