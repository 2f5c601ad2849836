#include "engine/grass/bezier_placement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <map>
#include <random>
#include <thread>

#include "engine/grass/grass_layout.hpp"
#include "tests/unit/grass/bezier_fixture.hpp"

namespace windloom {
namespace {

using namespace testing;

std::shared_ptr<const GrassMap> pictureOf(const std::function<int(int, int)>& grey, int side = 64) {
  auto map = std::make_shared<GrassMap>();
  map->size = {side, side};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const auto value = static_cast<std::uint8_t>(grey(x, y));
      for (const std::uint8_t byte : {value, value, value, std::uint8_t{255}}) map->pixels.push_back(byte);
    }
  }
  return map;
}

TEST(BezierGround, HoldsDensityTimesAreaInTheField) {
  for (const float tufts : {0.0f, 0.35f, 1.0f}) {
    BezierScene scene;
    scene.bezier.tufts = tufts;
    const BezierMeadow meadow = scene.place();
    EXPECT_EQ(inField(scene, meadow).size(), 80000u) << tufts;
    EXPECT_EQ(static_cast<long long>(grown(meadow).size()), meadow.count);
    EXPECT_FLOAT_EQ(meadow.widening, 1.0f);
    EXPECT_EQ(meadow.blades.size(), meadow.patches.size() * BEZIER_PATCH);
  }
}

TEST(BezierGround, CountsTheTrueAreaOfHills) {
  BezierScene scene;
  scene.heights =
      heightsFrom({401, 401}, {80, 80}, [](glm::vec2 at) { return 2.0f * std::sin(0.4f * at.x) + 0.3f * at.y; });
  scene.grass.slopeLimit = 89.0f;
  double area = 0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const double slope = 0.8 * std::cos(0.4 * (-20.0 + 40.0 * (i + 0.5) / kSteps));
    area += 40.0 * 40.0 / kSteps * std::sqrt(1.0 + slope * slope + 0.09);
  }
  const auto blades = inField(scene, scene.place());
  EXPECT_NEAR(static_cast<double>(blades.size()), 50.0 * area, 0.005 * 50.0 * area);
  for (const BezierBlade& blade : blades) EXPECT_NEAR(blade.y, heightAt(*scene.heights, {blade.x, blade.z}), 1e-4f);
}

TEST(BezierGround, LowersTheDensityAndWidensTheBlades) {
  BezierScene scene;
  const auto meanWidth = [](const std::vector<BezierBlade>& blades) {
    double sum = 0;
    for (const BezierBlade& blade : blades) sum += static_cast<double>(sizesOf(blade).y);
    return sum / static_cast<double>(blades.size());
  };
  const BezierMeadow every = scene.place();
  const double all = meanWidth(inField(scene, every));
  scene.bezier.most = 64000;
  const BezierMeadow fewer = scene.place();
  EXPECT_EQ(fewer.count, 64000) << "with the margin";
  const double factor = static_cast<double>(every.count) / 64000.0;
  EXPECT_NEAR(fewer.widening, factor, 1e-3 * factor);
  EXPECT_NEAR(static_cast<double>(inField(scene, fewer).size()), 80000.0 / factor, 2.0);
  EXPECT_NEAR(meanWidth(inField(scene, fewer)), factor * all, 0.02 * all) << "the cover stays";
  scene.bezier.most = 1000;
  EXPECT_FLOAT_EQ(scene.place().widening, 4.0f);
}

TEST(BezierGround, SpreadsSingleBladesEvenly) {
  for (const bool hills : {false, true}) {
    BezierScene scene;
    scene.bezier.tufts = 0.0f;
    scene.grass.slopeLimit = 90.0f;
    if (hills) scene.heights = heightsFrom({65, 65}, {60, 60}, [](glm::vec2 at) { return 0.02f * at.x * at.x; });
    constexpr int kSide = 20;
    std::vector<double> found(kSide * kSide, 0.0), expected(kSide * kSide, 0.0);
    const auto blades = inField(scene, scene.place());
    for (const BezierBlade& blade : blades) {
      const int x = std::min(static_cast<int>((blade.x + 20.0f) / 2.0f), kSide - 1);
      const int z = std::min(static_cast<int>((blade.z + 20.0f) / 2.0f), kSide - 1);
      ++found[static_cast<std::size_t>(z * kSide + x)];
    }
    double whole = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      // The stretch of the ground from side to side of a cell.
      const double from = -20.0 + 2.0 * static_cast<double>(i % kSide);
      for (int s = 0; s < 50; ++s) {
        const double slope = hills ? 0.04 * (from + 2.0 * (s + 0.5) / 50) : 0.0;
        expected[i] += std::sqrt(1.0 + slope * slope);
      }
      whole += expected[i];
    }
    for (double& one : expected) one *= static_cast<double>(blades.size()) / whole;
    EXPECT_LT(chiSquareExcess(found, expected), 4.0);
    EXPECT_GT(chiSquareExcess(found, std::vector<double>(found.size(), 1.0)), 100.0) << "the test sees what is uneven";
  }
}

TEST(BezierGround, SingleBladesClumpAsChanceHasIt) {
  BezierScene scene;
  scene.bezier.tufts = 0.0f;
  const auto blades = inField(scene, scene.place());
  // In squares of 0.1 m, half a blade each: as many empty ones as a Poisson process leaves, far from a lattice's half.
  std::vector<int> found(400 * 400, 0);
  for (const BezierBlade& blade : blades) {
    const int x = std::min(static_cast<int>((blade.x + 20.0f) * 10.0f), 399),
              z = std::min(static_cast<int>((blade.z + 20.0f) * 10.0f), 399);
    ++found[static_cast<std::size_t>(z * 400 + x)];
  }
  EXPECT_NEAR(static_cast<double>(std::ranges::count(found, 0)) / 160000.0, std::exp(-0.5), 0.02);
}

TEST(BezierGround, ThinsOutInARaggedMargin) {
  BezierScene scene;
  double near = 0, far = 0;
  for (const BezierBlade& blade : grown(scene.place())) {
    const float beyond = std::max(std::abs(blade.x), std::abs(blade.z)) - 20.0f;
    EXPECT_LE(beyond, kMeadowMarginM + 1e-3f);
    if (beyond > 0.0f && beyond < 2.0f) ++near;
    if (beyond > 8.0f && beyond < 10.0f) ++far;
  }
  EXPECT_GT(near, 5000);
  EXPECT_GT(far, 100);
  EXPECT_LT(far, 0.5 * near);
}

TEST(BezierGround, GrowsNothingOnSteepGroundAndLeansWithIt) {
  BezierScene scene;
  scene.grass.slopeLimit = 40.0f;
  scene.grass.slopeAlign = 1.0f;
  scene.heights =
      heightsFrom({801, 801}, {80, 80}, [](glm::vec2 at) { return at.x > 0.0f ? 1.2f * at.x : 0.2f * at.x; });
  int flat = 0;
  for (const BezierBlade& blade : grown(scene.place())) {
    ASSERT_LT(blade.x, 0.2f) << "50 degrees are too steep";
    if (blade.x > -0.5f) continue;
    ++flat;
    EXPECT_LT(glm::distance(upOf(blade), glm::normalize(glm::vec3(-0.2f, 1.0f, 0.0f))), 1e-3f);
  }
  EXPECT_GT(flat, 10000);
  scene.grass.slopeAlign = 0.0f;
  for (const BezierBlade& blade : grown(scene.place())) ASSERT_NEAR(upOf(blade).y, 1.0f, 1e-5f);
}

TEST(BezierGround, FollowsDensityAndHeightMaps) {
  BezierScene scene;
  scene.grass.densityPixels = pictureOf([](int x, int) { return x < 32 ? 0 : 255; });
  auto blades = inField(scene, scene.place());
  EXPECT_NEAR(static_cast<double>(blades.size()), 40000.0, 800.0);
  for (const BezierBlade& blade : blades) ASSERT_GT(blade.x, -0.4f) << "black grows nothing";
  scene.grass.densityPixels = pictureOf([](int, int) { return 51; });
  EXPECT_NEAR(static_cast<double>(inField(scene, scene.place()).size()), 16000.0, 10.0) << "a fifth";

  scene.grass.densityPixels = nullptr;
  const auto meanHeight = [&] {
    double sum = 0;
    blades = inField(scene, scene.place());
    for (const BezierBlade& blade : blades) sum += static_cast<double>(heightOf(blade));
    return sum / static_cast<double>(blades.size());
  };
  const double own = meanHeight();
  scene.grass.heightPixels = pictureOf([](int, int) { return 128; });
  EXPECT_NEAR(meanHeight(), own, 1e-4);
  scene.grass.heightPixels = pictureOf([](int, int) { return 255; });
  EXPECT_NEAR(meanHeight(), 2.0 * own, 2e-3);
}

TEST(BezierGround, VariesBladesWithinTheirRanges) {
  BezierScene scene;
  scene.grass.stiffness = 2.0f;
  scene.bezier.tufts = 0.0f;
  scene.bezier.dandelions = 0.1f;
  const auto blades = inField(scene, scene.place());
  double dandelions = 0, high = 0, low = 0;
  for (const BezierBlade& blade : blades) {
    const float stiffness = glm::unpackHalf1x16(static_cast<std::uint16_t>(blade.growth & 0xffffu));
    ASSERT_GE(stiffness, 2.0f * 0.699f);
    ASSERT_LE(stiffness, 2.0f * 1.301f);
    ASSERT_GE(sizesOf(blade).y, 0.799f * scene.grass.width);
    ASSERT_LE(sizesOf(blade).y, 1.201f * scene.grass.width);
    ASSERT_LT(heightOf(blade), scene.grass.height * 1.35f * 1.36f * 1.13f);
    ASSERT_GT(heightOf(blade), scene.grass.height * 0.64f * 0.86f);
    const float bright = 2.0f * static_cast<float>(blade.look >> 8 & 255u) / 255.0f;
    ASSERT_GT(bright, 0.65f);
    ASSERT_LT(bright, 1.4f);
    const bool dandelion = blade.look >> 24 == BEZIER_FORM_DANDELION;
    ASSERT_EQ(blade.look >> 24, dandelion ? BEZIER_FORM_DANDELION : BEZIER_FORM_TRIANGLE_TIP);
    (dandelion ? high : low) += static_cast<double>(heightOf(blade));
    dandelions += dandelion ? 1 : 0;
  }
  const auto all = static_cast<double>(blades.size());
  EXPECT_NEAR(dandelions / all, 0.1, 0.005);
  EXPECT_GT(high / dandelions, 1.15 * low / (all - dandelions)) << "dandelions stand over the grass";
}

TEST(BezierGround, TuftsStandApartAndPointOutwards) {
  BezierScene scene;
  scene.bezier.tufts = 1.0f;
  scene.bezier.tuftSpacing = 2.0f;
  scene.bezier.tuftRadius = 0.2f;
  const auto blades = inField(scene, scene.place());
  // Tufts are far apart beside their size: blades within 0.5 m of each other share one.
  std::vector<std::vector<const BezierBlade*>> tufts;
  for (const BezierBlade& blade : blades) {
    auto* own = static_cast<std::vector<const BezierBlade*>*>(nullptr);
    for (auto& tuft : tufts) {
      if (glm::distance(rootOf(*tuft.front()), rootOf(blade)) < 0.5f) own = &tuft;
    }
    if (own == nullptr) own = &tufts.emplace_back();
    own->push_back(&blade);
  }
  std::vector<glm::vec3> centres;
  double outwards = 0, all = 0;
  for (const auto& tuft : tufts) {
    glm::vec3 centre(0.0f);
    for (const BezierBlade* blade : tuft) centre += rootOf(*blade) / static_cast<float>(tuft.size());
    for (const BezierBlade* blade : tuft) {
      const glm::vec3 away = rootOf(*blade) - centre;
      EXPECT_LT(glm::length(away), 0.25f);
      if (glm::length(away) < 0.05f) continue;
      ++all;
      if (glm::dot(frontOf(*blade), away) > 0.0f) ++outwards;
    }
    centres.push_back(centre);
  }
  EXPECT_GT(outwards, 0.95 * all);
  EXPECT_NEAR(static_cast<double>(centres.size()), 0.7 * 1600.0 / 4.0, 60.0) << "no room for more";
  for (std::size_t i = 0; i < centres.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_GT(glm::distance(centres[i], centres[k]), 1.9f);
  }
}

TEST(BezierGround, TuftsShareTheirHeight) {
  BezierScene scene;
  scene.bezier.tufts = 1.0f;
  scene.bezier.tuftSpacing = 2.0f;
  scene.grass.clumping = 0.0f;
  // Part of the heights' variance that is left among blades of one square of 0.5 m.
  const auto left = [&] {
    const auto blades = inField(scene, scene.place());
    std::map<std::pair<int, int>, glm::dvec3> squares;
    glm::dvec3 all(0.0);
    for (const BezierBlade& blade : blades) {
      const auto height = static_cast<double>(heightOf(blade));
      const glm::dvec3 one(1.0, height, height * height);
      squares[{static_cast<int>(std::floor(2.0f * blade.x)), static_cast<int>(std::floor(2.0f * blade.z))}] += one;
      all += one;
    }
    double within = 0;
    for (const auto& [place, sums] : squares) within += sums.z - sums.y * sums.y / sums.x;
    return within / (all.z - all.y * all.y / all.x);
  };
  EXPECT_LT(left(), 0.7);
  scene.bezier.tufts = 0.0f;
  EXPECT_GT(left(), 0.85);
}

TEST(BezierPlacement, IsTheSameOnAnyNumberOfCores) {
  BezierScene scene = sceneOf(SurfaceShape::Hare, 3.0f, 3000.0f);
  scene.grass.density = 50.0f;
  const auto placeOn = [&](const char* threads) {
    setenv("WINDLOOM_THREADS", threads, 1);
    BezierMeadow meadow = scene.place();
    unsetenv("WINDLOOM_THREADS");
    return meadow;
  };
  const BezierMeadow one = placeOn("1");
  for (const char* threads : {"2", "5"}) {
    const BezierMeadow other = placeOn(threads);
    ASSERT_EQ(one.blades.size(), other.blades.size());
    EXPECT_EQ(std::memcmp(one.blades.data(), other.blades.data(), one.blades.size() * sizeof(BezierBlade)), 0);
    EXPECT_EQ(std::memcmp(one.patches.data(), other.patches.data(), one.patches.size() * sizeof(BezierPatch)), 0);
  }
  scene.grass.seed = 2;
  EXPECT_NE(std::memcmp(one.blades.data(), scene.place().blades.data(), 256 * sizeof(BezierBlade)), 0);
}

TEST(BezierPlacement, StopsWhenItIsCancelled) {
  BezierScene scene;
  scene.size = {200.0f, 200.0f};
  std::atomic<bool> cancelled = true;
  const BezierMeadow none = placeBezier(scene.project(), &cancelled);
  EXPECT_TRUE(none.blades.empty() && none.patches.empty());
  EXPECT_EQ(none.count, 0);
  cancelled = false;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    cancelled = true;
  });
  const BezierMeadow meadow = placeBezier(scene.project(), &cancelled);
  later.join();
  EXPECT_TRUE(meadow.blades.empty()) << "2 million blades take longer than 20 ms";
}

TEST(BezierPlacement, NeverPlacesMoreThanTheMost) {
  BezierScene scene = sceneOf(SurfaceShape::Sphere, 2.0f, 1e6f);  // 12.5 million
  scene.grass.density = 2000.0f;                                  // 3.2 million, and the margin
  scene.bezier.most = 10'000'000;
  scene.bezier.tufts = 0.0f;
  const BezierMeadow meadow = scene.place();
  EXPECT_LE(meadow.count, kMaxBezierBlades);
  EXPECT_GT(meadow.count, kMaxBezierBlades - 10);
  EXPECT_GT(meadow.widening, 2.0f);
  double ground = 0, sphere = 0;
  for (const BezierPatch& patch : meadow.patches)
    (patch.reach.w < 0.0f ? ground : sphere) += static_cast<double>(patch.centre.w);
  EXPECT_NEAR(sphere / static_cast<double>(meadow.count), 12.55 / (12.55 + 3.2 + 1.45), 0.03)
      << "all are lowered alike";
}

TEST(BezierPlacement, GrowsNothingWithoutDensity) {
  BezierScene scene;
  scene.grass.density = 0.0f;
  EXPECT_EQ(scene.place().count, 0);
  EXPECT_TRUE(scene.place().patches.empty());
  scene.grass.density = 50.0f;
  scene.bezier.most = 0;
  EXPECT_EQ(scene.place().count, 0);
}

}  // namespace
}  // namespace windloom
