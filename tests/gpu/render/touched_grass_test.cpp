// Grass that colliders touch, as it is seen in pictures.
#include <cmath>

#include "tests/gpu/render/render_fixture.hpp"

namespace windloom {
namespace {

using testing::difference;
using testing::draw;
using testing::Picture;

constexpr float kRadiusM = 0.4f;
constexpr float kToleranceM = 0.005f;
constexpr int kSide = 200;       // pixels of a picture through the ball
constexpr float kSeenM = 1.0f;   // its height
constexpr float kSlabM = 0.04f;  // of the world that it shows

class TouchedGrass : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setField(40);
    GrassSettings grass;
    grass.density = 300.0f;
    grass.width = 0.004f;
    grass.swingRate = 0.8f;
    grass.swingDamping = 0.4f;
    grass.interacting = 40'000;
    m_project.grass = std::make_shared<GrassSettings>(grass);
    auto made = FrameRenderer::create(context(), shaders());
    ASSERT_TRUE(made.ok()) << made.error().text();
    m_bare = std::move(*made);
    m_ball.radius = kRadiusM;
    m_ball.hidden = true;  // seen is the grass alone
  }
  void TearDown() override {
    m_bare.reset();
    RenderTest::TearDown();
  }
  void show(const Collider& collider) {
    m_project.colliders = std::make_shared<std::vector<Collider>>(std::vector{collider});
  }
  /// Steps to a time as a playing session does.
  void play(double from, double to, double frame = 1.0 / 30) {
    const int frames = static_cast<int>(std::lround((to - from) / frame));
    for (int i = 0; i <= frames; ++i) {
      m_input.time = from + i * frame;
      m_renderer->advance(m_input);
    }
  }
  void lookThrough(glm::vec3 centre, glm::vec3 direction, float from) {
    m_input.size = {kSide, kSide};
    ViewCamera& camera = m_input.camera;
    camera = {};
    camera.orthographic = true;
    camera.orthographicHeight = kSeenM;
    camera.up = std::abs(direction.y) > 0.5f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    camera.position = centre + direction * (from - 1.0f);
    camera.target = centre + direction * 10.0f;
    camera.nearPlane = 1.0f;
    camera.farPlane = 1.0f + kSlabM;
  }
  /// Pixels of grass within a ball, in slabs along an axis. The ball stands free of the ground's plane in all of them.
  int pixelsInside(glm::vec3 centre, glm::vec3 direction) {
    const Project touched = m_project;
    Project bare = m_project;
    GrassSettings none;
    none.kind = GrassKind::None;
    bare.grass = std::make_shared<GrassSettings>(none);
    int found = 0;
    for (float from = -kRadiusM; from < kRadiusM; from += kSlabM) {
      lookThrough(centre, direction, from);
      m_project = bare;
      const Picture behind = draw(*m_bare, m_input);
      m_project = touched;
      const Picture seen = picture();
      const float deepest = std::max(std::abs(from), std::abs(from + kSlabM));
      const float within = kRadiusM * kRadiusM - deepest * deepest;
      const float radius = (within > 0.0f ? std::sqrt(within) - kToleranceM : 0.0f) / kSeenM * float(kSide) - 1.0f;
      found += unlike(seen, behind, radius);
    }
    return found;
  }
  /// Pixels of a disc that differ.
  static int unlike(const Picture& a, const Picture& b, float radius) {
    int count = 0;
    const float middle = 0.5f * float(kSide);
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const float away = glm::length(glm::vec2(float(x) + 0.5f, float(y) + 0.5f) - middle);
        count += away <= radius && glm::distance(a.at(x, y), b.at(x, y)) > 6.0f ? 1 : 0;
      }
    }
    return count;
  }

  Collider m_ball;
  std::unique_ptr<FrameRenderer> m_bare;  // shows what is behind all grass
};

TEST_F(TouchedGrass, NoBladeReachesIntoARestingBall) {
  m_ball.muted = true;
  show(m_ball);
  const glm::vec3 centre(0.0f, kRadiusM, 0.0f);
  EXPECT_GT(pixelsInside(centre, {1, 0, 0}), 2000) << "untouched, blades stand in its place";
  m_ball.muted = false;
  show(m_ball);
  play(0.0, 1.0);
  for (const glm::vec3 direction : {glm::vec3(1, 0, 0), glm::vec3(0, 0, -1), glm::vec3(0, 1, 0)}) {
    EXPECT_EQ(pixelsInside(centre, direction), 0) << direction.x << ' ' << direction.y << ' ' << direction.z;
  }
}

TEST_F(TouchedGrass, NoBladeReachesIntoAMovingBall) {
  m_ball.keys = {{0, {-2, 0, 0}}, {1, {0, 0, 0.1f}}, {2, {2, 0, 0.4f}}};
  m_ball.loop = false;
  show(m_ball);
  play(0.0, 1.0);
  const glm::vec3 centre(0.0f, kRadiusM, 0.1f);
  for (const glm::vec3 direction : {glm::vec3(1, 0, 0), glm::vec3(0, 0, -1)}) {
    EXPECT_EQ(pixelsInside(centre, direction), 0) << direction.x << ' ' << direction.y << ' ' << direction.z;
  }
}

TEST_F(TouchedGrass, LongAfterTheBallHasPassedNothingIsLeft) {
  m_ball.keys = {{0, {-1.5f, 0, 0}}, {1, {1.5f, 0, 0}}, {2, {14, 0, 0}}};
  m_ball.loop = false;
  m_input.camera = testing::above({0, 0}, 3.0f);
  m_input.camera.position = {0, 2.0f, 2.5f};
  m_input.camera.orthographicHeight = 2.0f;
  Collider muted = m_ball;
  muted.muted = true;
  show(muted);
  m_input.time = 1.2;
  const Picture before = picture();
  m_input.time = 10.0;
  const Picture without = picture();
  show(m_ball);
  play(0.0, 1.2);
  EXPECT_GT(difference(picture(), before), 0.5f) << "its trail is seen";
  play(1.2, 10.0, 0.2);
  EXPECT_EQ(picture().rgba, without.rgba);
}

TEST_F(TouchedGrass, AJumpInTimeShowsWhatPlayingShows) {
  m_ball.keys = {{0, {-1.5f, 0, 0}}, {1, {1.5f, 0, 0}}};
  m_ball.loop = false;
  m_input.camera.position = {0, 2.0f, 2.5f};
  m_input.camera.target = {0, 0, 0};
  show(m_ball);
  m_input.time = 1.2;
  const Picture jumped = picture();
  play(0.0, 1.2);
  const Picture played = picture();
  m_input.time = 0.0;
  const Picture start = picture();
  EXPECT_GT(difference(start, played), 1.0f);
  EXPECT_LT(difference(jumped, played), 0.25f * difference(start, played));
  m_input.time = 1.2;
  EXPECT_EQ(picture().rgba, jumped.rgba) << "each jump to a time shows the same";
}

TEST_F(TouchedGrass, GoingBackShowsNothingOfLater) {
  m_ball.keys = {{1, {-30, 0, 0}}, {2, {0, 0, 0}}, {3, {1, 0, 0}}};
  m_ball.loop = false;
  m_input.camera.position = {0, 2.0f, 2.5f};
  m_input.camera.target = {0, 0, 0};
  show(m_ball);
  m_input.time = 0.5;
  const Picture early = picture();
  play(0.5, 2.5);
  EXPECT_GT(difference(picture(), early), 0.5f);
  m_input.time = 0.5;
  EXPECT_EQ(picture().rgba, early.rgba);
}

TEST_F(TouchedGrass, AnEditedColliderIsFollowedWhileTimeStands) {
  m_input.camera.position = {0, 2.0f, 2.5f};
  m_input.camera.target = {0, 0, 0};
  m_input.time = 1.0;
  m_ball.position = {20.0f, 0.0f};
  show(m_ball);
  const Picture away = picture();
  m_ball.position = {0.0f, 0.0f};
  show(m_ball);
  EXPECT_GT(difference(picture(), away), 0.2f);
  m_ball.position = {20.0f, 0.0f};
  show(m_ball);
  EXPECT_EQ(picture().rgba, away.rgba) << "no dent is left where it was";
}

TEST_F(TouchedGrass, TheGroundBesideABallIsDarkerAwayFromTheSun) {
  setDensity(0.0f);
  m_ball.hidden = false;
  m_input.camera = testing::above({0, 0}, 4.0f);
  const glm::vec2 half(m_input.size / 2);
  m_project.colliders = std::make_shared<std::vector<Collider>>();
  const Picture bare = picture();
  show(m_ball);
  const Picture shaded = picture();
  // The sun stands at -x, -z: the shadow falls to +x, +z, which from above is right and down.
  const float pixels = float(m_input.size.y) / 4.0f;
  const glm::ivec2 shadow(half + glm::vec2(0.68f, 0.74f) * 0.9f * pixels);
  const glm::ivec2 lit(half - glm::vec2(0.68f, 0.74f) * 1.9f * pixels);
  const auto light = [](const Picture& at, glm::ivec2 place) {
    return glm::dot(at.mean(place - 4, place + 4), glm::vec3(0.3f, 0.6f, 0.1f));
  };
  EXPECT_LT(light(shaded, shadow), 0.8f * light(bare, shadow));
  EXPECT_NEAR(light(shaded, lit), light(bare, lit), 0.05f * light(bare, lit));
}

}  // namespace
}  // namespace windloom
