// Overlays over known winds.
#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/gpu/render/render_fixture.hpp"
#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

using testing::above;
using testing::difference;
using testing::draw;
using testing::Picture;

constexpr int kCells = 64;

/// A field of 40 m on 64 x 64 cells seen from above, 30 m of it at 6 pixels a metre: pixel (160, 90) is its centre.
class Overlay : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setDensity(10.0f);
    setField(kCells);
    WindGraph graph;
    graph.points.resize(2);
    graph.points[0].id = 1;
    graph.points[0].position = {-12.0f, 0.0f};
    graph.points[1].id = 2;
    graph.points[1].position = {12.0f, 0.0f};
    Arrow arrow;
    arrow.id = 10;
    arrow.from = 1;
    arrow.to = 2;
    graph.arrows.push_back(arrow);
    m_project.graph = std::make_shared<WindGraph>(graph);
    m_input.camera = above({0.0f, 0.0f}, 30.0f);
    m_input.overlays.speedRange = 10.0f;
    m_input.time = 3.0;
    blow([](glm::vec2) { return glm::vec2(0.0f); });
  }

  /// Wind m/s at places in m.
  void blow(const std::function<glm::vec2(glm::vec2)>& wind) {
    auto texture = gpu::Texture::create2D("test wind", {kCells, kCells}, GL_RG32F, {.filter = gpu::Filter::Nearest});
    ASSERT_TRUE(texture.ok());
    std::vector<glm::vec2> values;
    for (int k = 0; k < kCells; ++k) {
      for (int i = 0; i < kCells; ++i)
        values.push_back(wind((glm::vec2(i, k) + 0.5f) * (kFieldM / kCells) - 0.5f * kFieldM));
    }
    texture->upload(GL_RG, GL_FLOAT, values.data());
    m_wind = std::move(*texture);
    m_input.wind = {m_wind.name(), makeGridMapping({0.0f, 0.0f}, {kFieldM, kFieldM}, {kCells, kCells})};
  }
  void setObstacle() {
    Obstacle stone;
    stone.id = 5;
    stone.radius = 6.0f;
    stone.height = 0.02f;
    m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{stone});
  }
  /// The picture with an overlay, and with none.
  std::pair<Picture, Picture> withAndWithout(const char* name) {
    const Overlays kept = m_input.overlays;
    const Picture plain = picture();
    setOn(m_input.overlays, *findOverlay(name), true);
    Picture marked = picture();
    m_input.overlays = kept;
    return {std::move(marked), plain};
  }
};

float change(const std::pair<Picture, Picture>& pair, int x, int y) {
  return glm::length(pair.first.at(x, y) - pair.second.at(x, y));
}

/// How much the picture changes from pixel to pixel along x and along y, where an overlay drew.
glm::vec2 roughness(const Picture& p, const Picture& plain) {
  glm::dvec2 sum(0.0);
  for (int y = 5; y + 6 < p.size.y; ++y) {
    for (int x = 5; x + 6 < p.size.x; ++x) {
      if (glm::length(p.at(x, y) - plain.at(x, y)) < 12.0f) continue;
      sum.x += static_cast<double>(std::abs(p.light(x + 2, y) - p.light(x, y)));
      sum.y += static_cast<double>(std::abs(p.light(x, y + 2) - p.light(x, y)));
    }
  }
  return glm::vec2(sum);
}

TEST_F(Overlay, ArrowsLieOnTheMeadowBetweenTheirPoints) {
  const auto pair = withAndWithout("arrows");
  EXPECT_GT(change(pair, 160, 90), 30.0f);
  EXPECT_GT(change(pair, 160 + 72, 90), 30.0f) << "the end point, 12 m east at 6 pixels a metre";
  EXPECT_GT(change(pair, 160 + 60, 90), 30.0f) << "the head";
  EXPECT_LT(change(pair, 160, 20), 3.0f);
}

TEST_F(Overlay, ArrowsHaveTheColourOfTheirStrength) {
  WindGraph graph = *m_project.graph;
  std::vector<float> light;
  for (const float strength : {1.0f, 5.0f, 9.5f}) {
    graph.arrows[0].strength = strength;
    m_project.graph = std::make_shared<WindGraph>(graph);
    const auto [marked, plain] = withAndWithout("arrows");
    const glm::vec3 seen = marked.mean({120, 88}, {200, 93}) / 255.0f;
    const glm::vec3 wanted = speedColour(strength / 10.0f);
    EXPECT_LT(glm::length(seen - wanted), 0.45f) << strength << " m/s; chevrons lighten it";
    light.push_back(glm::dot(seen, glm::vec3(0.3f, 0.6f, 0.1f)));
  }
  EXPECT_LT(light[0], light[1]);
  EXPECT_LT(light[1], light[2]);
}

TEST_F(Overlay, SelectedArrowsTakeTheAccentColour) {
  m_input.overlays.arrows = true;
  const Id selected[] = {10};
  m_input.highlight.selected = selected;
  const glm::vec3 c = picture().mean({120, 88}, {200, 93});
  EXPECT_GT(c.x, c.z + 40.0f) << "orange";
}

TEST_F(Overlay, APulseIsSeenToRunAlongItsArrow) {
  WindGraph graph = *m_project.graph;
  Signal pulse;
  pulse.root = 1;
  pulse.kind = SignalKind::Pulse;
  pulse.attack = 0.1f;
  pulse.on = 0.6f;
  pulse.release = 0.2f;
  graph.signals.push_back(pulse);
  graph.arrows[0].strength = 9.0f;
  m_project.graph = std::make_shared<WindGraph>(graph);
  const GraphEvaluator evaluator(graph);
  m_input.graph = &evaluator;
  m_input.overlays.arrows = true;
  // 24 m at 10 m/s: after 0.5 s it fills the first 5 m, after 1.8 s it is beyond the middle.
  const auto light = [](const Picture& p, int x) {
    const glm::vec3 c = p.mean({x - 9, 88}, {x + 9, 93});
    return c.x + c.y + c.z;
  };
  m_input.time = 0.5;
  const Picture early = picture();
  m_input.time = 1.8;
  const Picture late = picture();
  const int start = 160 - 54, far = 160 + 30;  // 3 m and 17 m along
  EXPECT_GT(light(early, start), light(late, start) + 60.0f);
  EXPECT_GT(light(late, far), light(early, far) + 60.0f);
}

TEST_F(Overlay, MutedArrowsAreGrey) {
  WindGraph graph = *m_project.graph;
  graph.arrows[0].muted = true;
  graph.arrows[0].strength = 5.0f;
  m_project.graph = std::make_shared<WindGraph>(graph);
  const auto muted = withAndWithout("arrows");
  graph.arrows[0].muted = false;
  m_project.graph = std::make_shared<WindGraph>(graph);
  const auto loud = withAndWithout("arrows");
  const auto chroma = [](const Picture& p) {
    const glm::vec3 c = p.mean({120, 88}, {200, 93});
    return std::max({c.x, c.y, c.z}) - std::min({c.x, c.y, c.z});
  };
  EXPECT_LT(chroma(muted.first), 0.6f * chroma(loud.first));
}

TEST_F(Overlay, SpeedMapShowsTheColourOfTheSpeed) {
  m_input.overlays.map = GroundMap::Speed;
  blow([](glm::vec2) { return glm::vec2(0.5f, 0.0f); });
  const glm::vec3 slow = picture().mean({100, 40}, {220, 80});
  blow([](glm::vec2) { return glm::vec2(9.8f, 0.0f); });
  const glm::vec3 fast = picture().mean({100, 40}, {220, 80});
  EXPECT_GT(fast.x, slow.x + 60.0f);
  EXPECT_GT(slow.z, slow.x) << "violet";
  EXPECT_GT(fast.x, fast.z) << "yellow";
}

TEST_F(Overlay, QuickMapsLookLikeFullOnes) {
  m_input.overlays.divergenceRange = 1.0f;
  blow([](glm::vec2 at) { return glm::vec2(2.0f * std::sin(0.4f * at.x), 0.0f); });
  for (const char* name : {"speed", "divergence"}) {
    m_input.quality.detail = 0.59f;  // quick on a software renderer
    const auto quick = withAndWithout(name);
    m_input.quality.detail = 0.61f;
    const auto full = withAndWithout(name);
    for (const int x : {70, 120, 160, 201, 260}) {
      const glm::vec3 a = quick.first.mean({x, 40}, {x + 8, 140}) - quick.second.mean({x, 40}, {x + 8, 140});
      const glm::vec3 b = full.first.mean({x, 40}, {x + 8, 140}) - full.second.mean({x, 40}, {x + 8, 140});
      EXPECT_LT(glm::length(a - b), 9.0f) << name << " at " << x;
    }
  }
}

TEST_F(Overlay, DivergenceOfUniformWindIsNone) {
  const auto still = withAndWithout("divergence");
  blow([](glm::vec2) { return glm::vec2(7.0f, -3.0f); });
  const auto even = withAndWithout("divergence");
  const glm::vec3 a = still.first.mean({60, 40}, {260, 140}), b = even.first.mean({60, 40}, {260, 140});
  EXPECT_LT(std::abs(a.x - a.z - (b.x - b.z)), 14.0f) << "neither orange nor blue, but for the grass underneath";
}

TEST_F(Overlay, DivergenceTellsSourcesFromSinks) {
  m_input.overlays.divergenceRange = 1.0f;
  blow([](glm::vec2 at) { return 0.4f * at; });  // divergence 0.8 1/s everywhere
  const auto [source, plainSource] = withAndWithout("divergence");
  const glm::vec3 orange = source.mean({60, 40}, {260, 140});
  EXPECT_GT(orange.x, orange.z + 80.0f);
  blow([](glm::vec2 at) { return -0.4f * at; });
  const auto [sink, plainSink] = withAndWithout("divergence");
  const glm::vec3 blue = sink.mean({60, 40}, {260, 140});
  EXPECT_GT(blue.z, blue.x + 50.0f);
}

TEST_F(Overlay, VorticityIsTwiceTheRateOfASolidRotation) {
  // 0.45 1/s from +X towards +Z: vorticity 0.9 1/s. The colour must be that of 0.9, found by range.
  blow([](glm::vec2 at) { return 0.45f * glm::vec2(-at.y, at.x); });
  m_input.overlays.vorticityRange = 1.2f;
  const auto [turning, plain] = withAndWithout("vorticity");
  const glm::vec3 under = plain.mean({60, 40}, {260, 140}), seen = turning.mean({60, 40}, {260, 140});
  const float alpha = 0.85f;  // from 0.6 of the range on
  const glm::vec3 own = (seen - (1.0f - alpha) * under) / alpha / 255.0f;
  EXPECT_LT(glm::length(own - divergingColour(0.75f)), 0.06f) << own.x << " " << own.y << " " << own.z;
}

TEST_F(Overlay, StreamlinesRunAlongTheWind) {
  blow([](glm::vec2) { return glm::vec2(6.0f, 0.0f); });
  const auto [alongX, plainX] = withAndWithout("streamlines");
  const glm::vec2 x = roughness(alongX, plainX);
  EXPECT_GT(x.y, 1.6f * x.x) << "lines along x";
  blow([](glm::vec2) { return glm::vec2(0.0f, -6.0f); });
  const auto [alongZ, plainZ] = withAndWithout("streamlines");
  const glm::vec2 z = roughness(alongZ, plainZ);
  EXPECT_GT(z.x, 1.6f * z.y) << "lines along z";
}

TEST_F(Overlay, StreamlinesMoveAndRestWithTheTime) {
  blow([](glm::vec2) { return glm::vec2(6.0f, 0.0f); });
  m_input.overlays.streamlines = true;
  const Picture first = picture(), again = picture();
  EXPECT_EQ(first.rgba, again.rgba);
  m_input.time += 0.2;
  EXPECT_GT(difference(first, picture()), 0.5f);
}

TEST_F(Overlay, StreaksLieAlongTheWind) {
  blow([](glm::vec2) { return glm::vec2(8.0f, 0.0f); });
  const auto [alongX, plainX] = withAndWithout("lic");
  const glm::vec2 x = roughness(alongX, plainX);
  EXPECT_GT(x.y, 1.8f * x.x);
  blow([](glm::vec2) { return glm::vec2(0.0f, 8.0f); });
  const auto [alongZ, plainZ] = withAndWithout("lic");
  const glm::vec2 z = roughness(alongZ, plainZ);
  EXPECT_GT(z.x, 1.8f * z.y);
}

TEST_F(Overlay, StreaksMoveDownstream) {
  blow([](glm::vec2) { return glm::vec2(8.0f, 0.0f); });
  m_input.overlays.map = GroundMap::Lic;
  const Picture now = picture();
  m_input.time += 0.12;
  const Picture later = picture();
  double with = 0, against = 0;
  for (int y = 20; y < 160; ++y) {
    for (int x = 60; x < 260; ++x) {
      with += static_cast<double>(std::abs(later.light(x + 2, y) - now.light(x, y)));
      against += static_cast<double>(std::abs(later.light(x - 2, y) - now.light(x, y)));
    }
  }
  EXPECT_LT(with, against) << "the pattern of before lies 2 pixels downstream";
}

TEST_F(Overlay, StreaksFollowAChangedRangeWhileTheTimeRests) {
  blow([](glm::vec2) { return glm::vec2(4.0f, 0.0f); });
  m_input.overlays.map = GroundMap::Lic;
  const Picture before = picture();
  EXPECT_EQ(before.rgba, picture().rgba);
  m_input.overlays.speedRange = 5.0f;
  EXPECT_GT(difference(before, picture()), 10.0f);
}

TEST_F(Overlay, StreaksFollowChangedGroundWhileTheTimeRests) {
  blow([](glm::vec2) { return glm::vec2(4.0f, 0.0f); });
  m_input.overlays.map = GroundMap::Lic;
  m_input.camera.position += glm::vec3(0.0f, 0.0f, 8.0f);  // from above nothing moves with its height
  m_input.camera.target = {0.0f, 0.0f, 0.0f};
  (void)picture();
  m_project.terrain = testing::terrainOf(testing::heightsFrom({9, 9}, {60, 60}, [](glm::vec2) { return 6.0f; }));
  const Picture after = picture();
  m_input.time += 1e-9;  // drawn anew
  EXPECT_LT(difference(after, picture()), 0.01f);
}

TEST_F(Overlay, WindVectorsShow) {
  blow([](glm::vec2) { return glm::vec2(8.0f, 0.0f); });
  const auto [marked, plain] = withAndWithout("vectors");
  EXPECT_GT(difference(plain, marked), 1.0f);
}

TEST_F(Overlay, NothingMovesInStillAir) {
  for (const char* name : {"streamlines", "vectors", "lic"}) {
    const auto [marked, plain] = withAndWithout(name);
    EXPECT_LT(difference(marked, plain), 0.05f) << name;
  }
  for (const char* name : {"speed", "divergence", "vorticity"}) {
    const auto [marked, plain] = withAndWithout(name);
    // Even: as rough as the meadow, or less.
    const glm::vec2 rough = roughness(marked, plain), meadow = roughness(plain, marked);
    EXPECT_LE(rough.x + rough.y, 1.05f * (meadow.x + meadow.y)) << name;
  }
}

TEST_F(Overlay, NothingIsDrawnInsideObstacles) {
  setObstacle();
  blow([](glm::vec2) { return glm::vec2(8.0f, 1.0f); });
  for (const OverlayKind& kind : overlayKinds()) {
    if (kind.name == "arrows") continue;
    const auto pair = withAndWithout(std::string(kind.name).c_str());
    float inside = 0, outside = 0;
    for (int y = 76; y < 104; ++y) {
      for (int x = 146; x < 174; ++x) inside = std::max(inside, change(pair, x, y));
    }
    for (int y = 20; y < 40; ++y) {
      for (int x = 40; x < 280; ++x) outside = std::max(outside, change(pair, x, y));
    }
    EXPECT_LT(inside, 4.0f) << kind.name;
    EXPECT_GT(outside, 25.0f) << kind.name;
  }
}

TEST_F(Overlay, SurvivesWindThatIsNotANumber) {
  blow([](glm::vec2 at) { return at.x > 0.0f ? glm::vec2(std::nanf("")) : glm::vec2(3.0f, 0.0f); });
  for (const OverlayKind& kind : overlayKinds()) (void)withAndWithout(std::string(kind.name).c_str());
}

}  // namespace
}  // namespace windloom
