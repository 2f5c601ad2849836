#include "engine/render/collider_pass.hpp"
#include "engine/render/surface_pass.hpp"
#include "tests/gpu/grass/grass_fixture.hpp"
#include "tests/gpu/render/picture.hpp"

namespace windloom {
namespace {

using testing::Picture;

constexpr glm::ivec2 kSize{160, 160};

/// Surfaces alone, seen from (0, 3, 10) towards -z, in all that a frame binds.
class Surfaces : public testing::GrassPassTest {
 protected:
  void SetUp() override {
    GrassPassTest::SetUp();
    m_pass.emplace(testing::taken(SurfacePass::create(shaders())));
    m_colliders.emplace(testing::taken(ColliderPass::create(shaders())));
  }
  void TearDown() override {
    m_pass.reset();
    m_colliders.reset();
    GrassPassTest::TearDown();
  }

  Picture pictureOf(const std::vector<Surface>& surfaces) {
    const Status status = m_pass->configure(surfaces, m_scene->heights.get());
    EXPECT_TRUE(status.ok());
    auto target = testing::taken(
        gpu::Framebuffer::create("test picture", kSize, {.colour = GL_RGBA8, .depth = GL_DEPTH_COMPONENT32F}));
    target.clearColour({1.0f, 0.0f, 1.0f, 0.0f});
    target.clearDepth(1.0f);
    m_scene->bindFrame(0.0);
    m_colliders->bindShades({}, 0.0, glm::vec3(0.0f), defaultLight().sunDirection, {});
    m_pass->draw(
        {.framebuffer = target.name(), .viewport = {0, 0, kSize.x, kSize.y}, .depth = gpu::Depth::TestAndWrite});
    return {kSize, target.readRgba8()};
  }
  static int covered(const Picture& picture) {
    int count = 0;
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) count += picture.rgba[i] == 255 ? 1 : 0;
    return count;
  }

  std::optional<SurfacePass> m_pass;
  std::optional<ColliderPass> m_colliders;
};

Surface surfaceOf(SurfaceShape shape) {
  Surface surface;
  surface.id = 1;
  surface.shape = shape;
  surface.colour = {0.3f, 0.2f, 0.1f};
  surface.lift = 1.0f;
  return surface;
}

TEST_F(Surfaces, EachBuiltInShapeIsSeenAndHiddenOnesAreNot) {
  std::vector<int> areas;
  for (const SurfaceShape shape :
       {SurfaceShape::Moebius, SurfaceShape::Torus, SurfaceShape::Sphere, SurfaceShape::Hare}) {
    Surface surface = surfaceOf(shape);
    const Picture shown = pictureOf({surface});
    areas.push_back(covered(shown));
    EXPECT_GT(areas.back(), 300) << static_cast<int>(shape);
    EXPECT_TRUE(m_pass->any());
    surface.hidden = true;
    EXPECT_EQ(covered(pictureOf({surface})), 0) << static_cast<int>(shape);
    EXPECT_FALSE(m_pass->any());
  }
  EXPECT_GT(areas[2], areas[1]) << "the sphere has no hole";
}

TEST_F(Surfaces, TakeTheirColourAndTheirLightFromTheSun) {
  Surface surface = surfaceOf(SurfaceShape::Sphere);
  const Picture brown = pictureOf({surface});
  surface.colour = {0.1f, 0.2f, 0.3f};
  const Picture blue = pictureOf({surface});
  const auto covered = [](const Picture& picture, int x, int y) {
    return picture.rgba[static_cast<std::size_t>(y * kSize.x + x) * 4 + 3] == 255;
  };
  std::vector<int> rows;  // of the sphere
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x && (rows.empty() || rows.back() != y); ++x) {
      if (covered(brown, x, y)) rows.push_back(y);
    }
  }
  ASSERT_GT(rows.size(), 20u);
  const int middle = rows[rows.size() / 2];
  const auto meanOf = [&](const Picture& picture, bool upper) {
    glm::vec3 sum(0.0f);
    int count = 0;
    for (int y = upper ? 0 : middle; y < (upper ? middle : kSize.y); ++y) {
      for (int x = 0; x < kSize.x; ++x) {
        if (!covered(picture, x, y)) continue;
        sum += picture.at(x, y);
        ++count;
      }
    }
    return sum / static_cast<float>(std::max(count, 1));
  };
  EXPECT_GT(meanOf(brown, true).r, meanOf(brown, true).b + 10.0f);
  EXPECT_GT(meanOf(blue, false).b, meanOf(blue, false).r + 10.0f);
  EXPECT_GT(meanOf(brown, true).g, 1.15f * meanOf(brown, false).g);
}

TEST_F(Surfaces, StandOnTheGroundAndHideWhatIsBehindThem) {
  Surface near = surfaceOf(SurfaceShape::Sphere);
  near.position = {0.0f, 2.0f};
  Surface behind = near;
  behind.position.y = -3.0f;
  behind.colour = {0.0f, 0.0f, 0.9f};
  behind.size = 1.0f;
  EXPECT_EQ(pictureOf({near, behind}).rgba, pictureOf({near}).rgba);
  EXPECT_EQ(pictureOf({behind, near}).rgba, pictureOf({near}).rgba);
  const auto topOf = [](const Picture& picture) {
    for (int y = 0; y < kSize.y; ++y) {
      for (int x = 0; x < kSize.x; ++x) {
        if (picture.rgba[static_cast<std::size_t>(y * kSize.x + x) * 4 + 3] == 255) return y;
      }
    }
    return kSize.y;
  };
  near.size = 1.0f;
  near.position = {3.0f, 0.0f};
  const int flat = topOf(pictureOf({near}));
  m_scene->setSlope(0.3f);
  EXPECT_LT(topOf(pictureOf({near})), flat - 5) << "the ground is 0.9 m higher";
}

TEST_F(Surfaces, WithoutTrianglesOrFileAreLeftOut) {
  Surface unread = surfaceOf(SurfaceShape::Mesh);
  unread.file = "assets/none.glb";
  EXPECT_EQ(covered(pictureOf({unread})), 0);
  unread.mesh = std::make_shared<PlantMesh>();
  EXPECT_EQ(covered(pictureOf({unread})), 0);
  EXPECT_EQ(covered(pictureOf({})), 0);
}

}  // namespace
}  // namespace windloom
