#include "engine/render/overlay_lattice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "engine/render/framing.hpp"

namespace windloom {
namespace {

constexpr glm::ivec2 kSize{1280, 720};
constexpr float kPixels = 30.0f;

double weightOf(const std::vector<FlowSeed>& seeds) {
  double sum = 0;
  for (const FlowSeed& seed : seeds) sum += static_cast<double>(seed.place.w);
  return sum;
}

TEST(FlowSeeds, AreAboutEquallyDenseAtEveryZoom) {
  ViewCamera camera = frameFieldFromAbove({});
  for (const float height : {3.0f, 7.0f, 20.0f, 45.0f, 90.0f}) {
    camera.orthographicHeight = height;
    const double seeds = weightOf(makeFlowSeeds(camera, kSize, {}, kPixels));
    // Up to 92 m of field are seen across: the picture's share that is field.
    const double across =
        std::min(1280.0 / 720.0 * static_cast<double>(height), 100.0) * 720.0 / static_cast<double>(height);
    const double share = seeds * 30.0 * 30.0 / (across * 720.0);
    EXPECT_GT(share, 0.15) << height;
    EXPECT_LT(share, 0.9) << height;
  }
}

TEST(FlowSeeds, StandStillWhileTheCameraMoves) {
  ViewCamera camera = frameField({});
  std::map<std::uint32_t, glm::vec2> before;
  for (const FlowSeed& seed : makeFlowSeeds(camera, kSize, {}, kPixels)) before[seed.key] = glm::vec2(seed.place);
  camera.position += glm::vec3(1.7f, 0.2f, -0.8f);
  int same = 0;
  for (const FlowSeed& seed : makeFlowSeeds(camera, kSize, {}, kPixels)) {
    const auto found = before.find(seed.key);
    if (found == before.end()) continue;
    EXPECT_EQ(found->second, glm::vec2(seed.place));
    ++same;
  }
  EXPECT_GT(same, static_cast<int>(before.size()) / 2);
}

TEST(FlowSeeds, ComeAndGoFaintly) {
  ViewCamera camera = frameFieldFromAbove({});
  camera.orthographicHeight = 40.0f;
  std::map<std::uint32_t, float> last;
  for (int i = 0; i < 200; ++i) {
    camera.orthographicHeight *= 1.01f;
    std::map<std::uint32_t, float> now;
    for (const FlowSeed& seed : makeFlowSeeds(camera, kSize, {}, kPixels)) now[seed.key] = seed.place.w;
    for (const auto& [key, weight] : last) {
      EXPECT_TRUE(now.contains(key) || weight < 0.1f) << "gone at once from " << weight;
    }
    last = std::move(now);
  }
}

TEST(FlowSeeds, HaveKeysOfTheirOwn) {
  std::set<std::uint32_t> keys;
  const std::vector<FlowSeed> seeds = makeFlowSeeds(frameField({}), kSize, {}, kPixels);
  for (const FlowSeed& seed : seeds) keys.insert(seed.key);
  EXPECT_GE(keys.size() + 1, seeds.size()) << "a clash of hashes is one in a million";
}

TEST(FlowSeeds, LieInTheField) {
  FieldSettings field;
  field.size = {20.0f, 10.0f};
  const std::vector<FlowSeed> seeds = makeFlowSeeds(frameField(field), kSize, field, kPixels);
  ASSERT_FALSE(seeds.empty());
  for (const FlowSeed& seed : seeds) {
    EXPECT_LE(std::abs(seed.place.x), 10.0f);
    EXPECT_LE(std::abs(seed.place.y), 5.0f);
  }
}

TEST(FlowSeeds, StayFewInAHugeFieldSeenAlongTheGround) {
  FieldSettings field;
  field.size = {20000.0f, 20000.0f};
  ViewCamera camera;
  camera.position = {0.0f, 1.7f, 0.0f};
  camera.target = {100.0f, 1.7f, 0.0f};
  const std::vector<FlowSeed> seeds = makeFlowSeeds(camera, kSize, field, kPixels);
  EXPECT_FALSE(seeds.empty());
  EXPECT_LT(seeds.size(), 5000u);
}

TEST(FlowSeeds, AreNoneWhereTheFieldIsOutOfSight) {
  ViewCamera camera;
  camera.position = {500.0f, 20.0f, 500.0f};
  camera.target = {600.0f, 0.0f, 600.0f};
  EXPECT_TRUE(makeFlowSeeds(camera, kSize, {}, kPixels).empty());
  EXPECT_TRUE(seenArea(camera, kSize, {}).empty());
}

}  // namespace
}  // namespace windloom
