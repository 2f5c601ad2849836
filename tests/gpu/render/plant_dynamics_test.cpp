// Plants that aren't blades answer touches and gusts as the grass around them.
#include <glm/gtc/packing.hpp>
#include <map>

#include "engine/grass/plant_pass.hpp"
#include "tests/gpu/render/render_fixture.hpp"

namespace windloom {
namespace {

using testing::uniformWind;

class PlantDynamics : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setField(16);
    m_input.camera = testing::above({0.0f, 0.0f}, 10.0f);
    m_input.time = 3.0;
    auto pass = PlantPass::create(shaders());
    ASSERT_TRUE(pass.ok()) << pass.error().text();
    m_pass = std::make_unique<PlantPass>(std::move(*pass));
    setDeformation(Deformation::Arc);
    Species poppy;
    poppy.id = 7;
    poppy.shape = PlantShape::Poppy;
    poppy.weight = 0.3f;
    poppy.patchiness = 0.0f;
    m_project.species = std::make_shared<std::vector<Species>>(std::vector{poppy});
  }
  void TearDown() override {
    m_pass.reset();
    RenderTest::TearDown();
  }

  void setDeformation(Deformation deformation) {
    GrassSettings grass;
    grass.deformation = deformation;
    grass.flutter = 0.0f;
    m_project.grass = std::make_shared<GrassSettings>(grass);
  }
  void blow(glm::vec2 wind) {
    m_wind = uniformWind(wind);
    m_input.wind = {m_wind.name(), makeGridMapping(m_project.field->centre, m_project.field->size, {16, 16})};
  }

  /// Bends of the plants of the whole field by their places.
  std::map<std::pair<float, float>, glm::vec2> bends() {
    (void)picture();  // leaves bound what the pass reads
    EXPECT_TRUE(m_pass->configure(*m_project.field, *m_project.grass, *m_project.species).ok());
    m_pass->prepare({.thinning = false, .culling = false});
    std::map<std::pair<float, float>, glm::vec2> found;
    for (const shared::PlantInstance& plant : m_pass->placed(0)) {
      found[{plant.x, plant.z}] = glm::unpackHalf2x16(plant.bend);
    }
    return found;
  }

  std::unique_ptr<PlantPass> m_pass;
};

TEST_F(PlantDynamics, BendAwayFromWhatTouchesTheGrassAroundThem) {
  const auto before = bends();
  Collider ball;
  ball.id = 9;
  ball.radius = 0.5f;
  m_project.colliders = std::make_shared<std::vector<Collider>>(std::vector{ball});
  const auto after = bends();
  int bent = 0, near = 0, gone = 0;
  for (const auto& [place, was] : before) {
    const glm::vec2 root(place.first, place.second);
    const float away = glm::length(root);
    const auto now = after.find(place);
    if (now == after.end()) {
      ++gone;
      EXPECT_LT(away, 0.5f) << "only what stands right under the ball is hidden";
      continue;
    }
    if (away > 4.0f) {
      ASSERT_EQ(now->second, was) << "far from it nothing changes";
    } else if (away > 0.15f && away < 0.45f) {
      ++near;
      bent += glm::dot(now->second - was, root / away) > 0.2f ? 1 : 0;
    }
  }
  EXPECT_GT(near, 5);
  EXPECT_GT(bent, near * 3 / 4);
  EXPECT_LT(gone, near);
}

TEST_F(PlantDynamics, SwingWithInertialGrass) {
  // How far a gust has bent plants on the mean after its first step, and after a third of a second.
  const auto answer = [&](Deformation deformation) {
    setDeformation(deformation);
    m_input.time += 10.0;
    blow({0.5f, 0.0f});
    const auto calm = bends();
    blow({9.0f, 0.0f});
    glm::vec2 sums(0.0f);
    for (int n = 1; n <= 20; ++n) {
      m_input.time += 1.0 / 60.0;
      if (n > 1 && n < 20) {
        (void)picture();
        continue;
      }
      const auto now = bends();
      for (const auto& [place, was] : calm) sums[n == 1 ? 0 : 1] += (now.at(place).x - was.x) / float(calm.size());
    }
    return sums;
  };
  const glm::vec2 arc = answer(Deformation::Arc), inertial = answer(Deformation::Inertial);
  EXPECT_GT(arc[0], 0.4f);
  EXPECT_LT(inertial[0], 0.1f * arc[0]) << "inertia takes time";
  EXPECT_GT(inertial[1], 0.5f * arc[1]) << "and then follows";
}

}  // namespace
}  // namespace windloom
