#include <cmath>
#include <functional>

#include "tests/gpu/render/render_fixture.hpp"

namespace windloom {
namespace {

using testing::above;
using testing::difference;
using testing::draw;
using testing::Picture;
using testing::uniformWind;

class Frame : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setDensity(60.0f);
    setField(16);
    m_input.camera.position = {0.0f, 1.7f, 16.0f};
    m_input.camera.target = {0.0f, 0.8f, 0.0f};
    m_input.time = 3.0;
  }

  void blow(glm::vec2 wind) {
    m_wind = uniformWind(wind);
    m_input.wind = {m_wind.name(), makeGridMapping(m_project.field->centre, m_project.field->size, {16, 16})};
  }
  void setGrass(const std::function<void(GrassSettings&)>& change) {
    GrassSettings grass = *m_project.grass;
    change(grass);
    m_project.grass = std::make_shared<GrassSettings>(grass);
  }
  void setObstacle(float height) {
    Obstacle stone;
    stone.id = 5;
    stone.radius = 3.0f;
    stone.height = height;
    m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{stone});
  }
  /// Statistics arrive a few frames late.
  FrameStats settledStats() {
    for (int i = 0; i < 3; ++i) (void)picture();
    auto target = gpu::Framebuffer::create("test picture", m_input.size, {.colour = GL_RGBA8, .depth = 0});
    EXPECT_TRUE(target.ok());
    FrameInput input = m_input;
    input.framebuffer = target->name();
    return m_renderer->render(input);
  }
};

/// How much lines run across the picture rather than up it: the ratio of squared gradients along y and x.
float lineDirection(const Picture& p) {
  double x2 = 0, y2 = 0;
  for (int y = 1; y + 1 < p.size.y; ++y) {
    for (int x = 1; x + 1 < p.size.x; ++x) {
      const double gx = static_cast<double>(p.light(x + 1, y) - p.light(x - 1, y)),
                   gy = static_cast<double>(p.light(x, y + 1) - p.light(x, y - 1));
      x2 += gx * gx;
      y2 += gy * gy;
    }
  }
  return static_cast<float>(y2 / x2);
}

TEST_F(Frame, FillsEveryPixelWithLight) {
  blow({3.0f, 1.0f});
  for (const bool top : {false, true}) {
    if (top) m_input.camera = above({0.0f, 0.0f}, 50.0f);
    const Picture p = picture();
    for (int y = 0; y < p.size.y; ++y) {
      for (int x = 0; x < p.size.x; ++x) {
        const glm::vec3 c = p.at(x, y);
        ASSERT_GT(c.x + c.y + c.z, 12.0f) << "black pixel at " << x << ", " << y;
        ASSERT_FALSE(c == glm::vec3(255.0f, 0.0f, 255.0f)) << "pixel not drawn at " << x << ", " << y;
      }
    }
  }
}

TEST_F(Frame, HasSkyAboveAndGreenBelow) {
  const Picture p = picture();
  const glm::vec3 sky = p.mean({0, 0}, {320, 30}), meadow = p.mean({0, 130}, {320, 180});
  EXPECT_GT(sky.z, sky.x * 0.9f);
  EXPECT_GT(meadow.y, meadow.z * 1.5f);
  EXPECT_GT(meadow.y, meadow.x);
}

TEST_F(Frame, WindCombsTheGrassAlongItself) {
  setGrass([](GrassSettings& grass) { grass.flutter = 0.0f; });
  m_input.size = {256, 256};
  m_input.camera = above({1.0f, 2.0f}, 5.0f);
  const float still = lineDirection(picture());
  blow({12.0f, 0.0f});
  const float alongX = lineDirection(picture());
  blow({0.0f, 12.0f});
  const float alongZ = lineDirection(picture());
  EXPECT_GT(alongX, 1.4f * still) << "blades lie along x, so light changes most along z";
  EXPECT_LT(alongZ, still / 1.4f);
}

TEST_F(Frame, WindShowsAsALighterOrDarkerBandFromAfar) {
  m_input.camera = above({0.0f, 0.0f}, 40.0f);
  setGrass([](GrassSettings& grass) { grass.flutter = 0.0f; });
  m_wind = uniformWind({0.0f, 0.0f});
  std::vector<glm::vec2> band(16 * 16, glm::vec2(0.0f));
  for (std::size_t k = 6; k < 10; ++k) {
    for (std::size_t i = 0; i < 16; ++i) band[k * 16 + i] = {11.0f, 0.0f};
  }
  m_input.wind = {m_wind.name(), makeGridMapping({0.0f, 0.0f}, {40.0f, 40.0f}, {16, 16})};
  const Picture calm = picture();
  m_wind.upload(GL_RG, GL_FLOAT, band.data());
  const Picture blown = picture();
  const auto light = [](glm::vec3 c) { return glm::dot(c, glm::vec3(0.3f, 0.6f, 0.1f)); };
  const float inside = std::abs(light(blown.mean({80, 80}, {240, 100})) - light(calm.mean({80, 80}, {240, 100})));
  const float outside = std::abs(light(blown.mean({80, 10}, {240, 40})) - light(calm.mean({80, 10}, {240, 40})));
  EXPECT_GT(inside, 8.0f);
  EXPECT_LT(outside, 1.0f);
}

TEST_F(Frame, BladesStandStillInTheWorldWhenTheCameraMoves) {
  blow({2.0f, 0.0f});
  m_input.size = {200, 200};
  m_input.camera = above({0.0f, 0.0f}, 10.0f);
  const Picture before = picture();
  m_input.camera = above({2.0f, 0.0f}, 10.0f);  // 40 pixels
  const Picture after = picture();
  double sum = 0;
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 160; ++x) sum += static_cast<double>(std::abs(before.light(x + 40, y) - after.light(x, y)));
  }
  EXPECT_LT(sum / (200.0 * 160.0), 2.0);
}

TEST_F(Frame, TheSamePictureTwiceIsTheSame) {
  blow({5.0f, 2.0f});
  EXPECT_LT(difference(picture(), picture()), 0.02f);
}

TEST_F(Frame, DrawsFewerBladesAtLowerDetail) {
  blow({1.0f, 0.0f});
  long long before = settledStats().bladesDrawn;
  EXPECT_GT(before, 1000);
  EXPECT_LE(before, 2 * settledStats().bladesTotal);
  for (const float detail : {0.5f, 0.2f, 0.08f}) {
    m_input.quality.detail = detail;
    const long long now = settledStats().bladesDrawn;
    EXPECT_LT(now, before) << detail;
    EXPECT_GT(now, 50) << detail;
    before = now;
  }
}

TEST_F(Frame, LowerDetailKeepsTheMeadowClosed) {
  blow({2.0f, 0.0f});
  const glm::vec3 full = picture().mean({0, 110}, {320, 180});
  m_input.quality.detail = 0.15f;
  const glm::vec3 low = picture().mean({0, 110}, {320, 180});
  EXPECT_LT(glm::length(full - low), 30.0f) << "the mean colour hardly changes";
}

TEST_F(Frame, CullsWhatIsBehindTheCamera) {
  m_input.camera.position = {0.0f, 1.7f, 60.0f};
  m_input.camera.target = {0.0f, 1.7f, 100.0f};
  EXPECT_EQ(settledStats().bladesDrawn, 0);
}

TEST_F(Frame, NoGrassStandsInASolid) {
  setObstacle(0.05f);  // low: grass in it would stick out
  m_input.camera = above({0.0f, 0.0f}, 12.0f);
  m_input.size = {240, 240};
  const Picture p = picture();
  // In this light stone is warm grey and grass green.
  const auto green = [](glm::vec3 c) { return c.y - c.x; };
  float most = -255.0f;
  for (int y = 90; y < 150; ++y) {
    for (int x = 90; x < 150; ++x) most = std::max(most, green(p.at(x, y)));
  }
  EXPECT_LT(most, 2.0f);
  EXPECT_GT(green(p.mean({0, 0}, {30, 240})), 3.0f);
}

TEST_F(Frame, GrassStandsInTheNotchOfAPolygonOnly) {
  Obstacle notched;
  notched.id = 5;
  notched.shape = ObstacleShape::Polygon;
  notched.height = 0.05f;
  // 8 m square with a notch from its low z side to the middle.
  notched.points = {{-4, -4}, {-1.5f, -4}, {-1.5f, 1}, {1.5f, 1}, {1.5f, -4}, {4, -4}, {4, 4}, {-4, 4}};
  m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{notched});
  setGrass([](GrassSettings& grass) { grass.density = 120.0f; });
  m_input.camera = above({0.0f, 0.0f}, 12.0f);
  m_input.size = {240, 240};  // 20 pixels a metre
  const Picture p = picture();
  const auto green = [](glm::vec3 c) { return c.y - c.x; };
  EXPECT_LT(green(p.mean({60, 80}, {80, 180})), 2.0f) << "stone at low x";
  EXPECT_LT(green(p.mean({160, 80}, {180, 180})), 2.0f) << "stone at high x";
  EXPECT_LT(green(p.mean({60, 160}, {180, 185})), 2.0f) << "stone behind the notch";
  EXPECT_GT(green(p.mean({105, 60}, {135, 110})), 3.0f) << "grass in the notch";
}

TEST_F(Frame, APolygonThrowsTheShadowOfItsDrum) {
  setGrass([](GrassSettings& grass) { grass.density = 20.0f; });
  m_input.camera = above({0.0f, 0.0f}, 24.0f);
  m_input.size = {240, 240};
  setObstacle(3.0f);
  const Picture drum = picture();
  Obstacle round = m_project.obstacles->front();
  round.shape = ObstacleShape::Polygon;
  for (int i = 0; i < 64; ++i) {
    const float angle = 6.2831853f * float(i) / 64;
    round.points.emplace_back(3.0f * std::cos(angle), 3.0f * std::sin(angle));
  }
  m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{round});
  EXPECT_LT(difference(drum, picture()), 1.5f);
}

TEST_F(Frame, SolidsThrowShadows) {
  setGrass([](GrassSettings& grass) { grass.density = 20.0f; });
  m_input.camera = above({0.0f, 0.0f}, 24.0f);
  m_input.size = {240, 240};
  const glm::vec3 open = picture().mean({150, 150}, {170, 170});
  setObstacle(3.0f);
  const glm::vec3 shaded = picture().mean({150, 150}, {170, 170});
  EXPECT_LT(shaded.y, 0.8f * open.y) << "the sun stands north-west, so the shadow lies south-east";
}

TEST_F(Frame, QuadraticDeformationDiffersFromArc) {
  blow({6.0f, 0.0f});
  const Picture arc = picture();
  setGrass([](GrassSettings& grass) { grass.deformation = Deformation::Quadratic; });
  EXPECT_GT(difference(arc, picture()), 3.0f);
}

TEST_F(Frame, DrawsAMeadowWithoutGrassAndWithoutWind) {
  setGrass([](GrassSettings& grass) { grass.density = 0.0f; });
  const Picture p = picture();
  EXPECT_GT(p.mean({0, 120}, {320, 180}).y, 5.0f);
  EXPECT_EQ(settledStats().bladesDrawn, 0);
}

TEST_F(Frame, KeepsToItsPlaceInTheTarget) {
  auto target = gpu::Framebuffer::create("test picture", {400, 300}, {.colour = GL_RGBA8, .depth = 0});
  ASSERT_TRUE(target.ok());
  target->clearColour({1.0f, 0.0f, 1.0f, 1.0f});
  m_input.framebuffer = target->name();
  m_input.origin = {50, 60};
  m_renderer->render(m_input);
  const Picture p{{400, 300}, target->readRgba8()};
  const glm::vec3 untouched(255.0f, 0.0f, 255.0f);
  EXPECT_EQ(p.at(49, 150), untouched);
  EXPECT_EQ(p.at(371, 150), untouched);
  EXPECT_EQ(p.at(200, 300 - 60), untouched);
  EXPECT_EQ(p.at(200, 300 - 60 - 180 - 1), untouched);
  EXPECT_NE(p.at(50, 300 - 61), untouched);
  EXPECT_NE(p.at(369, 300 - 240), untouched);
}

}  // namespace
}  // namespace windloom
