// Species other than blades: where they stand, how many are drawn, how they answer wind, maps and slopes.
#include <algorithm>
#include <cstring>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <map>
#include <tuple>

#include "engine/grass/plant_pass.hpp"
#include "engine/render/frame_block.hpp"
#include "tests/gpu/render/render_fixture.hpp"
#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

using shared::PlantInstance;
using testing::above;
using testing::difference;
using testing::Picture;
using testing::uniformWind;

class Plants : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setField(16);
    setSpecies([](Species&) {});
    m_input.camera = above({0.0f, 0.0f}, 80.0f);
    auto pass = PlantPass::create(shaders());
    ASSERT_TRUE(pass.ok()) << pass.error().text();
    m_pass = std::make_unique<PlantPass>(std::move(*pass));
  }
  void TearDown() override {
    m_pass.reset();
    RenderTest::TearDown();
  }

  /// One species of poppies, two a square metre, everywhere alike, in grass too thin to hide them.
  void setSpecies(const std::function<void(Species&)>& change, const std::function<void(GrassSettings&)>& grow = {}) {
    GrassSettings grass;
    grass.density = 4.0f;
    if (grow) grow(grass);
    m_project.grass = std::make_shared<GrassSettings>(grass);
    Species poppy;
    poppy.id = 7;
    poppy.shape = PlantShape::Poppy;
    poppy.weight = 1.0f;
    poppy.patchiness = 0.0f;
    poppy.height = 0.6f;
    poppy.width = 0.006f;
    poppy.tipColour = {0.7f, 0.02f, 0.01f};
    change(poppy);
    m_project.species = std::make_shared<std::vector<Species>>(std::vector{poppy});
  }
  void setCamera(glm::vec3 eye, glm::vec3 target) {
    m_input.camera = ViewCamera{};
    m_input.camera.position = eye;
    m_input.camera.target = target;
  }

  /// The plants of a frame, in a fixed order. A frame drawn before leaves bound what the pass reads.
  std::vector<PlantInstance> placed(PlantView view = {}) {
    (void)picture();
    const FrameBlock block = makeFrameBlock(m_input, defaultLight());
    view.eye = glm::vec3(block.cameraPosition);
    view.orthographic = block.cameraPosition.w > 0.5f;
    view.pixelScale = block.pixelScale.x;
    EXPECT_TRUE(m_pass->configure(*m_project.field, *m_project.grass, *m_project.species).ok());
    m_pass->prepare(view);
    std::vector<PlantInstance> all = m_pass->placed(0);
    std::ranges::sort(all, {}, [](const PlantInstance& p) { return std::tuple(p.x, p.z, p.place); });
    return all;
  }
  std::vector<PlantInstance> everyPlant() { return placed({.thinning = false, .culling = false}); }

  static long within(const std::vector<PlantInstance>& plants, glm::vec2 low, glm::vec2 high) {
    return std::ranges::count_if(
        plants, [&](const PlantInstance& p) { return p.x >= low.x && p.z >= low.y && p.x < high.x && p.z < high.y; });
  }

  std::unique_ptr<PlantPass> m_pass;
};

constexpr float kHalf = 20.0f;  // of the field, m

TEST_F(Plants, AreTheSameFromAnyCameraPath) {
  setCamera({5.0f, 2.0f, 30.0f}, {0.0f, 0.5f, 0.0f});
  const std::vector<PlantInstance> first = placed();
  ASSERT_GT(first.size(), 200u);
  for (const float x : {-40.0f, 3.0f, 11.7f}) {
    setCamera({x, 9.0f, -12.0f}, {2.0f, 0.0f, 1.0f});
    ASSERT_FALSE(placed().empty());
  }
  setCamera({5.0f, 2.0f, 30.0f}, {0.0f, 0.5f, 0.0f});
  const std::vector<PlantInstance> again = placed();
  ASSERT_EQ(first.size(), again.size());
  EXPECT_EQ(std::memcmp(first.data(), again.data(), first.size() * sizeof(PlantInstance)), 0);
}

TEST_F(Plants, StayWhereTheyAreWhenTheCameraMoves) {
  setCamera({5.0f, 2.0f, 30.0f}, {0.0f, 0.5f, 0.0f});
  std::map<std::uint32_t, PlantInstance> known;
  for (const PlantInstance& plant : placed()) known[plant.place] = plant;
  setCamera({-9.3f, 6.0f, 21.0f}, {0.0f, 0.5f, 0.0f});
  std::size_t same = 0;
  for (const PlantInstance& plant : placed()) {
    const auto before = known.find(plant.place);
    if (before == known.end()) continue;
    ++same;
    ASSERT_EQ(std::tuple(plant.x, plant.y, plant.z, plant.turn, plant.tint, plant.bend),
              std::tuple(before->second.x, before->second.y, before->second.z, before->second.turn, before->second.tint,
                         before->second.bend));
  }
  EXPECT_GT(same, 100u);
}

TEST_F(Plants, GrowAsDenseAsTheirWeightSays) {
  const long even = within(everyPlant(), glm::vec2(-kHalf), glm::vec2(kHalf));
  EXPECT_NEAR(static_cast<double>(even), 2.0 * 1600.0, 100.0);
  setSpecies([](Species& one) {
    one.patchiness = 1.0f;
    one.patchSize = 1.0f;
  });
  const long patchy = within(everyPlant(), glm::vec2(-kHalf), glm::vec2(kHalf));
  EXPECT_NEAR(static_cast<double>(patchy), 2.0 * 1600.0, 900.0);
}

TEST_F(Plants, ThinOutInTheMarginAndEndThere) {
  const std::vector<PlantInstance> all = everyPlant();
  const long inside = within(all, {-5.0f, kHalf - 5.0f}, {5.0f, kHalf}),
             beyond = within(all, {-5.0f, kHalf + 8.0f}, {5.0f, kHalf + 13.0f});
  EXPECT_LT(beyond, inside);
  for (const PlantInstance& plant : all) ASSERT_LE(std::max(std::abs(plant.x), std::abs(plant.z)), kHalf + 40.0f);
}

TEST_F(Plants, ThinSmoothlyWithTheirSizeInThePicture) {
  long last = 1'000'000;
  long most = 0;
  for (float metres = 8.0f; metres < 130.0f; metres *= 1.12f) {
    m_input.camera.orthographicHeight = metres;
    const auto now = static_cast<long>(placed({.culling = false}).size());
    EXPECT_LE(now, last) << metres << " m";
    if (last < 1'000'000) {
      EXPECT_GE(now, last * 55 / 100 - 100) << "no sudden loss at " << metres << " m";
    }
    most = std::max(most, now);
    last = now;
  }
  EXPECT_GT(most, 2000);
  EXPECT_EQ(last, 0) << "what is under a pixel is not drawn";
}

TEST_F(Plants, LeaveOutWhatIsOutOfSight) {
  setCamera({0.0f, 2.0f, 60.0f}, {0.0f, 2.0f, 90.0f});
  EXPECT_TRUE(placed().empty()) << "the meadow lies behind the camera";
  setCamera({0.0f, 2.0f, 0.0f}, {0.0f, 1.0f, -10.0f});
  const auto some = placed().size(), all = placed({.thinning = false, .culling = false}).size();
  EXPECT_LT(some, all / 2);
  EXPECT_GT(some, 0u);
}

TEST_F(Plants, GrowInNoObstacle) {
  Obstacle stone;
  stone.id = 5;
  stone.radius = 4.0f;
  stone.height = 2.0f;
  m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{stone});
  const std::vector<PlantInstance> plants = everyPlant();
  ASSERT_GT(plants.size(), 1000u);
  for (const PlantInstance& plant : plants) EXPECT_GT(glm::length(glm::vec2(plant.x, plant.z)), 3.9f);
}

std::shared_ptr<GrassMap> halfMap(std::uint8_t left, std::uint8_t right) {
  auto map = std::make_shared<GrassMap>();
  map->size = {64, 4};
  for (int i = 0; i < 64 * 4; ++i) {
    const std::uint8_t value = i % 64 < 32 ? left : right;
    map->pixels.insert(map->pixels.end(), {value, value, value, 255});
  }
  return map;
}

float heightOf(const PlantInstance& plant) {
  return glm::unpackHalf2x16(plant.sizes).x;
}

TEST_F(Plants, FollowTheMapOfDensity) {
  setSpecies([](Species&) {}, [](GrassSettings& grass) { grass.densityPixels = halfMap(0, 255); });
  const std::vector<PlantInstance> plants = everyPlant();
  EXPECT_EQ(within(plants, glm::vec2(-kHalf), {-0.5f, kHalf}), 0);
  EXPECT_NEAR(static_cast<double>(within(plants, {0.5f, -kHalf}, glm::vec2(kHalf))), 2.0 * 19.5 * 40.0, 80.0);
}

TEST_F(Plants, FollowTheMapOfHeight) {
  const auto meanHeights = [&] {
    glm::vec2 sum(0.0f), count(0.0f);
    for (const PlantInstance& plant : everyPlant()) {
      if (std::abs(plant.x) < 1.0f || std::max(std::abs(plant.x), std::abs(plant.z)) > kHalf) continue;
      sum[plant.x > 0.0f] += heightOf(plant);
      count[plant.x > 0.0f] += 1.0f;
    }
    return sum / count;
  };
  const glm::vec2 plain = meanHeights();
  setSpecies([](Species&) {}, [](GrassSettings& grass) { grass.heightPixels = halfMap(128, 255); });
  const glm::vec2 mapped = meanHeights();
  EXPECT_NEAR(mapped.x / plain.x, 1.0f, 0.02f) << "mid grey changes nothing";
  EXPECT_NEAR(mapped.y / plain.y, 2.0f, 0.05f);
}

TEST_F(Plants, LeaveSteepSlopesBare) {
  const auto ridge = [](glm::vec2 p) { return std::max(0.0f, 1.6f * (6.0f - std::abs(p.x))); };  // 58 degrees
  m_project.terrain = testing::terrainOf(testing::heightsFrom({161, 161}, {40.0f, 40.0f}, ridge));
  setSpecies([](Species&) {}, [](GrassSettings& grass) { grass.slopeLimit = 40.0f; });
  const std::vector<PlantInstance> plants = everyPlant();
  EXPECT_EQ(within(plants, {1.0f, -kHalf}, {5.0f, kHalf}), 0);
  EXPECT_GT(within(plants, {8.0f, -kHalf}, {12.0f, kHalf}), 200);
  setSpecies([](Species&) {}, [](GrassSettings& grass) { grass.slopeLimit = 80.0f; });
  const std::vector<PlantInstance> everywhere = everyPlant();
  EXPECT_GT(within(everywhere, {1.0f, -kHalf}, {5.0f, kHalf}), 200);
  for (const PlantInstance& plant : everywhere) {
    if (std::abs(plant.x) > 5.0f || std::abs(plant.x) < 1.0f) continue;
    ASSERT_NEAR(plant.y, ridge({plant.x, plant.z}), 0.2f);
  }
}

TEST_F(Plants, BendWithTheWind) {
  const auto meanBend = [&](glm::vec2 wind) {
    m_wind = uniformWind(wind);
    m_input.wind = {m_wind.name(), makeGridMapping(m_project.field->centre, m_project.field->size, {16, 16})};
    glm::vec2 sum(0.0f);
    const std::vector<PlantInstance> plants = everyPlant();
    for (const PlantInstance& plant : plants) sum += glm::unpackHalf2x16(plant.bend);
    return sum / static_cast<float>(plants.size());
  };
  EXPECT_LT(glm::length(meanBend({0.0f, 0.0f})), 0.05f);
  const glm::vec2 weak = meanBend({3.0f, 0.0f}), strong = meanBend({12.0f, 0.0f});
  EXPECT_GT(weak.x, 0.1f);
  EXPECT_GT(strong.x, weak.x);
  EXPECT_LT(strong.x, 1.55f) << "never lies down";
  EXPECT_LT(std::abs(strong.y), 0.1f);
}

TEST_F(Plants, BendWithTheVirtualWindWhereGrassHasInertia) {
  setSpecies([](Species&) {}, [](GrassSettings& grass) { grass.deformation = Deformation::Inertial; });
  m_wind = uniformWind({6.0f, 0.0f});
  m_input.wind = {m_wind.name(), makeGridMapping(m_project.field->centre, m_project.field->size, {16, 16})};
  for (int frame = 0; frame < 40; ++frame) {
    m_input.time += 1.0 / 30.0;
    m_renderer->advance(m_input);
  }
  glm::vec2 sum(0.0f);
  const std::vector<PlantInstance> plants = everyPlant();
  for (const PlantInstance& plant : plants) sum += glm::unpackHalf2x16(plant.bend);
  sum /= static_cast<float>(plants.size());
  EXPECT_GT(sum.x, 0.1f);
  EXPECT_LT(sum.x, 1.5f);
  EXPECT_LT(std::abs(sum.y), 0.1f);
}

TEST_F(Plants, ShowThemselvesAndTheWindInThePicture) {
  setCamera({0.0f, 1.0f, 6.0f}, {0.0f, 0.4f, 0.0f});
  const Picture with = picture();
  int red = 0;
  for (int y = 0; y < with.size.y; ++y) {
    for (int x = 0; x < with.size.x; ++x) {
      const glm::vec3 c = with.at(x, y);
      if (c.x > 100.0f && c.y < 0.5f * c.x) ++red;
    }
  }
  EXPECT_GT(red, 100) << "poppies are red";
  m_wind = uniformWind({6.0f, 0.0f});
  m_input.wind = {m_wind.name(), makeGridMapping(m_project.field->centre, m_project.field->size, {16, 16})};
  const Picture blown = picture();
  EXPECT_GT(difference(with, blown), 1.0f);
  m_project.species = std::make_shared<std::vector<Species>>();
  EXPECT_GT(difference(blown, picture()), 0.5f);
}

TEST_F(Plants, AreStillInStillAir) {
  setCamera({0.0f, 1.0f, 6.0f}, {0.0f, 0.4f, 0.0f});
  const Picture first = picture();
  for (int frame = 0; frame < 12; ++frame) {
    m_input.time += 1.0 / 60.0;
    ASSERT_EQ(difference(first, picture()), 0.0f) << "frame " << frame;
  }
}

TEST_F(Plants, CutTheirTextureAtTheAlphaCutoff) {
  const auto tuft = [](std::uint8_t alpha) {
    auto mesh = std::make_shared<PlantMesh>();
    for (const glm::vec2 c : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)})
      mesh->vertices.push_back(
          {.position = {c.x - 0.5f, c.y, 0.0f}, .normal = {0, 0.7f, 0.714f}, .uv = {c.x, 1.0f - c.y}});
    mesh->indices = {0, 1, 2, 0, 2, 3};
    mesh->low = {-0.5f, 0, 0};
    mesh->high = {0.5f, 1, 0};
    mesh->textureSize = {4, 4};
    for (int i = 0; i < 16; ++i) mesh->texture.insert(mesh->texture.end(), {250, 10, 250, alpha});
    return mesh;
  };
  setCamera({0.0f, 1.0f, 6.0f}, {0.0f, 0.4f, 0.0f});
  const auto shown = [&](std::uint8_t alpha) {
    setSpecies([&](Species& one) {
      one.shape = PlantShape::Mesh;
      one.mesh = tuft(alpha);
      one.tipColour = glm::vec3(1.0f);
    });
    return picture();
  };
  const Picture opaque = shown(255), cut = shown(40);
  setSpecies([&](Species& one) {
    one.shape = PlantShape::Mesh;
    one.mesh = tuft(255);
    one.hidden = true;
  });
  const Picture without = picture();
  EXPECT_EQ(difference(cut, without), 0.0f);
  EXPECT_GT(difference(opaque, without), 3.0f);
}

TEST_F(Plants, KeepTheirPlacesWhileColoursChange) {
  const std::vector<PlantInstance> before = everyPlant();
  setSpecies([](Species& one) { one.tipColour = {0.1f, 0.1f, 0.9f}; });
  const std::vector<PlantInstance> after = everyPlant();
  ASSERT_EQ(before.size(), after.size());
  EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(PlantInstance)), 0);
}

}  // namespace
}  // namespace windloom
