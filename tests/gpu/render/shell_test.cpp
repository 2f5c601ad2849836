// Pictures of shell grass.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/gpu/memory.hpp"
#include "tests/gpu/render/render_fixture.hpp"

namespace windloom::testing {
namespace {

class ShellPicture : public RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setField(16);
    setGrass([](GrassSettings& grass) { grass.kind = GrassKind::Shell; });
    setShell([](ShellSettings& shell) { shell.texels = 512; });
    m_input.camera.position = {0.0f, 2.5f, 16.0f};
    m_input.camera.target = {0.0f, 0.3f, 0.0f};
    blow({0.0f, 0.0f});
  }
  template <class Change>
  void setShell(const Change& change) {
    ShellSettings shell = *m_project.shell;
    change(shell);
    m_project.shell = std::make_shared<ShellSettings>(shell);
  }
  void lookDown(float distance) {
    const float down = 0.6f;  // rad
    m_input.camera.target = {0.0f, 0.3f, 0.0f};
    m_input.camera.position = {0.0f, 0.3f + distance * std::sin(down), distance * std::cos(down)};
  }
  /// Of a part in the middle, where the ground is as far away as what is looked at.
  static glm::vec3 middle(const Picture& shown) { return shown.mean(shown.size * 2 / 5, shown.size * 3 / 5); }
};

TEST_F(ShellPicture, GrassIsGreenAndBareGroundIsNot) {
  const glm::vec3 grass = meadow(picture());
  setGrass([](GrassSettings& g) { g.kind = GrassKind::None; });
  const glm::vec3 bare = meadow(picture());
  EXPECT_GT(grass.g, grass.r);
  EXPECT_GT(grass.g, 1.3f * grass.b);
  EXPECT_GT(glm::length(grass - bare), 20.0f);
}

TEST_F(ShellPicture, IsAsBrightAsTheInstancedMeadow) {
  const float shells = meadow(picture()).g;
  setGrass([](GrassSettings& g) { g.kind = GrassKind::Instanced; });
  EXPECT_NEAR(shells / meadow(picture()).g, 1.0f, 0.15f);
}

TEST_F(ShellPicture, AFewFilledShellsShowWhatManyPlainOnesDo) {
  lookDown(5.0f);
  m_input.quality.thinning = false;
  const Picture filled = picture();
  setShell([](ShellSettings& s) {
    s.method = ShellMethod::Plain;
    s.shells = 64;
  });
  const Picture plain = picture();
  setShell([](ShellSettings& s) { s.shells = 8; });
  const Picture few = picture();
  EXPECT_NEAR(middle(filled).g / middle(plain).g, 1.0f, 0.04f);
  EXPECT_LT(difference(filled, plain), 0.6f * difference(few, plain)) << "8 plain shells show slices";
}

TEST_F(ShellPicture, ItIsAsBrightFromFarAwayAsFromNearby) {
  lookDown(4.0f);
  const glm::vec3 near = middle(picture());
  for (const float distance : {8.0f, 16.0f, 32.0f, 64.0f}) {
    lookDown(distance);
    EXPECT_NEAR(middle(picture()).g / near.g, 1.0f, 0.12f) << distance << " m";
  }
}

TEST_F(ShellPicture, AStillMeadowIsTheSamePictureAgain) {
  setGrass([](GrassSettings& g) { g.flutter = 0.0f; });
  const Picture first = picture();
  EXPECT_EQ(difference(first, picture()), 0.0f);
}

TEST_F(ShellPicture, WindBendsIt) {
  const Picture still = picture();
  blow({9.0f, 0.0f});
  EXPECT_GT(difference(still, picture()), 6.0f);
}

TEST_F(ShellPicture, TheSourceSwingsItWithoutAnyWind) {
  setShell([](ShellSettings& s) {
    s.wind = ShellWind::Source;
    s.source = {0.0f, -10.0f};
  });
  const Picture first = picture();
  m_input.time = 0.25 * static_cast<double>(m_project.shell->sourcePeriod);
  const Picture later = picture();
  EXPECT_GT(difference(first, later), 4.0f);
  blow({9.0f, 0.0f});
  EXPECT_LT(difference(later, picture()), 6.0f) << "the field's wind doesn't bend it";
}

TEST_F(ShellPicture, WindAtEveryTexelIsTheSameWhereItIsEven) {
  blow({5.0f, 2.0f});
  setGrass([](GrassSettings& g) { g.flutter = 0.0f; });
  lookDown(6.0f);
  const Picture corners = picture();
  setShell([](ShellSettings& s) { s.sampling = ShellSampling::Texel; });
  EXPECT_LT(difference(corners, picture()), 1.0f);
}

TEST_F(ShellPicture, NothingGrowsInASolid) {
  m_input.camera.position = {0.0f, 12.0f, 0.1f};
  m_input.camera.target = {0.0f, 0.0f, 0.0f};
  Obstacle plate;
  plate.id = 5;
  plate.shape = ObstacleShape::Circle;
  plate.radius = 4.0f;
  plate.centre = {0.0f, 0.0f};
  plate.height = 0.02f;
  m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{plate});
  const Picture grown = picture();
  setGrass([](GrassSettings& g) { g.kind = GrassKind::None; });
  const Picture bare = picture();
  const glm::ivec2 half = grown.size / 2;
  const glm::vec3 inside = grown.mean(half - 20, half + 20) - bare.mean(half - 20, half + 20);
  EXPECT_LT(glm::length(inside), 2.0f);
}

TEST_F(ShellPicture, TilesWhereNothingGrowsAreNotDrawn) {
  const ShellCounts all = rendered().shell;
  auto black = std::make_shared<GrassMap>();
  black->size = {64, 64};
  for (int i = 0; i < 64 * 64; ++i) {
    const std::uint8_t value = i % 64 < 32 ? 0 : 255;
    black->pixels.insert(black->pixels.end(), {value, value, value, 255});
  }
  setGrass([&](GrassSettings& g) { g.densityPixels = black; });
  const ShellCounts half = rendered().shell;
  EXPECT_GT(all.tiles, 0);
  EXPECT_LT(half.tiles, all.tiles);
  EXPECT_LT(half.layers, all.layers);
}

TEST_F(ShellPicture, ShellsThatNoBladeReachesAreLeftOut) {
  auto low = std::make_shared<GrassMap>();
  low->size = {64, 64};
  low->pixels.resize(4u * 64 * 64);
  for (std::size_t i = 0; i < low->pixels.size(); i += 4) {
    low->pixels[i] = 60, low->pixels[i + 1] = 140, low->pixels[i + 2] = 30;
    low->pixels[i + 3] = (i / 4) % 3 == 0 ? 70 : 0;
  }
  setShell([&](ShellSettings& s) { s.pixels = low; });
  const ShellCounts counts = rendered().shell;
  EXPECT_GT(counts.skippedLayers, 0);
  EXPECT_LT(counts.nearShells, m_project.shell->shells);
}

TEST_F(ShellPicture, FewerShellsAreDrawnFarAway) {
  const auto perTile = [&] {
    const ShellCounts counts = rendered().shell;
    return static_cast<float>(counts.layers) / static_cast<float>(counts.tiles);
  };
  lookDown(3.0f);
  const float near = perTile();
  lookDown(60.0f);
  EXPECT_LT(perTile(), 0.5f * near);
}

TEST_F(ShellPicture, GrowsOnSurfaces) {
  Surface ball;
  ball.id = 9;
  ball.shape = SurfaceShape::Sphere;
  ball.size = 3.0f;
  ball.lift = 1.0f;
  m_project.surfaces = std::make_shared<std::vector<Surface>>(std::vector{ball});
  m_input.camera.target = {0.0f, 2.5f, 0.0f};
  m_input.camera.position = {0.0f, 5.0f, 6.0f};
  setGrass([](GrassSettings& g) { g.density = 0.0f; });
  const auto shown = [this](GrassKind kind) {
    setGrass([kind](GrassSettings& g) { g.kind = kind; });
    return picture();
  };
  const Picture bare = shown(GrassKind::None), grown = shown(GrassKind::Shell);
  EXPECT_GT(middle(grown).g, middle(grown).r);
  EXPECT_GT(glm::length(middle(grown) - middle(bare)), 15.0f);
  // Nearer, where the ball fills more of the picture.
  m_input.camera.position = {0.0f, 4.0f, 4.0f};
  EXPECT_GT(difference(shown(GrassKind::None), shown(GrassKind::Shell)), 3.0f);
}

TEST_F(ShellPicture, TexturesStayWithinTheirMemory) {
  setShell([](ShellSettings& s) { s.texels = 1024; });
  picture();
  EXPECT_LE(gpu::bytesInUse("shell"), 32u << 20);
  EXPECT_GT(gpu::bytesInUse("shell"), 8u << 20);
}

TEST_F(ShellPicture, DoesNotWaitForItsTextureWhereTheFrameMustGoOn) {
  m_input.quality.complete = false;
  FrameStats stats = rendered();
  EXPECT_FALSE(stats.complete);
  EXPECT_EQ(stats.shell.layers, 0);
  for (int frame = 0; !stats.complete && frame < 5000; ++frame) stats = rendered();
  EXPECT_TRUE(stats.complete);
  EXPECT_GT(rendered().shell.layers, 0);
}

TEST_F(ShellPicture, IsThereFromStraightAbove) {
  m_input.camera.position = {0.0f, 60.0f, 0.1f};
  m_input.camera.target = {0.0f, 0.0f, 0.0f};
  const glm::vec3 perspective = middle(picture());
  m_input.camera.orthographic = true;
  for (const float height : {4.0f, 12.0f, 40.0f}) {
    m_input.camera.orthographicHeight = height;
    const glm::vec3 seen = middle(picture());
    EXPECT_GT(seen.g, 1.3f * seen.b) << height;
    EXPECT_NEAR(seen.g / perspective.g, 1.0f, 0.3f) << height << " m";
  }
}

TEST_F(ShellPicture, MoreSamplesAreOfTheSameBrightness) {
  m_input.quality.samples = 4;
  const glm::vec3 four = meadow(picture());
  m_input.quality.samples = 1;
  EXPECT_NEAR(meadow(picture()).g / four.g, 1.0f, 0.05f);
}

}  // namespace
}  // namespace windloom::testing
