// Pictures of Bezier grass.
#include <gtest/gtest.h>

#include "tests/gpu/render/render_fixture.hpp"

namespace windloom::testing {
namespace {

class BezierPicture : public RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setField(16);
    setGrass([](GrassSettings& grass) {
      grass.kind = GrassKind::Bezier;
      grass.density = 60.0f;
    });
    m_input.camera.position = {0.0f, 2.5f, 16.0f};
    m_input.camera.target = {0.0f, 0.3f, 0.0f};
    m_wind = uniformWind({0.0f, 0.0f});
    blow({0.0f, 0.0f});
  }
  template <class Change>
  void setBezier(const Change& change) {
    BezierSettings bezier = *m_project.bezier;
    change(bezier);
    m_project.bezier = std::make_shared<BezierSettings>(bezier);
  }
  BezierCounts counts() {
    picture();
    return rendered().bezier;  // of the frame before, which picture() waited for
  }
  static int blue(const Picture& shown) {
    int count = 0;
    for (int y = shown.size.y / 2; y < shown.size.y; ++y) {
      for (int x = 0; x < shown.size.x; ++x) count += shown.at(x, y).b > 1.2f * shown.at(x, y).g ? 1 : 0;
    }
    return count;
  }
};

TEST_F(BezierPicture, GrassIsGreenAndBareGroundIsNot) {
  const glm::vec3 grass = meadow(picture());
  setGrass([](GrassSettings& g) { g.kind = GrassKind::None; });
  const glm::vec3 bare = meadow(picture());
  EXPECT_GT(grass.g, grass.r);
  EXPECT_GT(grass.g, 1.3f * grass.b);
  EXPECT_GT(glm::length(grass - bare), 20.0f);
}

TEST_F(BezierPicture, IsAsBrightAsTheInstancedMeadow) {
  const float bezier = meadow(picture()).g;
  setGrass([](GrassSettings& g) { g.kind = GrassKind::Instanced; });
  EXPECT_NEAR(bezier / meadow(picture()).g, 1.0f, 0.15f);
}

TEST_F(BezierPicture, AStillMeadowIsTheSamePictureAgain) {
  setGrass([](GrassSettings& g) { g.flutter = 0.0f; });
  const Picture first = picture();
  EXPECT_LT(difference(first, picture()), 0.02f);
}

TEST_F(BezierPicture, WindBendsIt) {
  const Picture still = picture();
  blow({9.0f, 0.0f});
  m_input.time = 20.0;  // a jump: grass stands in the wind of that time
  EXPECT_GT(difference(still, picture()), 6.0f);
}

TEST_F(BezierPicture, NothingGrowsInASolid) {
  const BezierCounts open = counts();
  Obstacle wall;
  wall.id = 5;
  wall.shape = ObstacleShape::Circle;
  wall.radius = 4.0f;
  wall.centre = {0.0f, 4.0f};
  wall.height = 0.0f;
  m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{wall});
  m_input.bezierCulling = {false, false, false, false};
  const BezierCounts less = counts();
  EXPECT_NEAR(static_cast<double>(less.inPatches - less.drawn), 60.0 * 3.14159 * 16.0, 300.0);
  EXPECT_EQ(less.inPatches, open.inPatches);
}

TEST_F(BezierPicture, LessDetailDrawsFewerBladesOfTheSameBrightness) {
  const float full = meadow(picture()).g;
  const long long all = counts().drawn;
  m_input.quality.detail = 0.5f;
  EXPECT_NEAR(meadow(picture()).g / full, 1.0f, 0.05f);
  EXPECT_LT(counts().drawn, all * 6 / 10);
}

TEST_F(BezierPicture, CullingChangesLittleOfThePicture) {
  const Picture culled = picture();
  m_input.bezierCulling = {false, false, false, false};
  const Picture whole = picture();
  EXPECT_NEAR(meadow(culled).g / meadow(whole).g, 1.0f, 0.04f);
  EXPECT_LT(difference(culled, whole), 14.0f);
}

TEST_F(BezierPicture, DebugViewsShowWhatTheySay) {
  setBezier([](BezierSettings& b) { b.reach = 20.0f; });
  const Picture normal = picture();
  m_input.grassView = GrassView::Culled;
  const Picture culled = picture();
  m_input.bezierCulling = {false, false, false, false};
  const Picture drawn = picture();
  EXPECT_LT(blue(drawn), 20) << "blades that are drawn are green";
  EXPECT_GT(blue(culled), 1000) << "those thinned by distance are blue";
  m_input.bezierCulling = {};
  m_input.grassView = GrassView::Strength;
  const glm::vec3 strength = meadow(picture());
  EXPECT_LT(strength.g, meadow(normal).g) << "nothing was touched";
  m_input.grassView = GrassView::Patches;
  EXPECT_GT(difference(normal, picture()), 10.0f);
  m_input.grassView = GrassView::Wireframe;
  EXPECT_GT(difference(normal, picture()), 5.0f);
  m_input.grassView = GrassView::Normal;
  EXPECT_LT(difference(normal, picture()), 0.5f) << "a view leaves nothing behind";
}

TEST_F(BezierPicture, DoesNotWaitForBladesWhereTheFrameMustGoOn) {
  m_input.quality.complete = false;
  FrameStats stats = rendered();
  for (int frame = 0; !stats.complete && frame < 2000; ++frame) stats = rendered();
  EXPECT_TRUE(stats.complete);
  EXPECT_GT(meadow(picture()).g, 40.0f);
  EXPECT_EQ(counts().blades, rendered().bladesTotal);
}

TEST_F(BezierPicture, FormsDifferInThePicture) {
  m_input.camera.position = {0.0f, 0.8f, 14.0f};
  m_input.camera.target = {0.0f, 0.4f, 12.0f};
  Picture before;
  for (const BladeForm form : {BladeForm::Quad, BladeForm::Triangle, BladeForm::Quadratic, BladeForm::TriangleTip}) {
    setBezier([&](BezierSettings& b) { b.form = form; });
    const Picture shown = picture();
    if (!before.rgba.empty()) {
      EXPECT_GT(difference(before, shown), 1.0f) << static_cast<int>(form);
    }
    before = shown;
  }
  setBezier([](BezierSettings& b) { b.dandelions = 0.5f; });
  EXPECT_GT(difference(before, picture()), 2.0f);
}

TEST_F(BezierPicture, EightSamplesAreDrawnWhereTheMachineCan) {
  m_input.quality.samples = 8;
  const glm::vec3 eight = meadow(picture());
  m_input.quality.samples = 1;
  EXPECT_NEAR(meadow(picture()).g / eight.g, 1.0f, 0.05f);
}

}  // namespace
}  // namespace windloom::testing
