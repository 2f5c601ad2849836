#include "engine/grass/virtual_blades.hpp"

#include <gtest/gtest.h>

#include "tests/gpu/grass/grass_fixture.hpp"

namespace windloom {
namespace {

constexpr float kDt = 1.0f / 60.0f;
constexpr int kSegments = CHAIN_SEGMENTS;

class VirtualBladesGpu : public testing::GrassPassTest {
 protected:
  void SetUp() override {
    GrassPassTest::SetUp();
    auto made = VirtualBlades::create(shaders());
    ASSERT_TRUE(made.ok()) << made.error().text();
    m_blades.emplace(std::move(*made));
    m_queries = testing::taken(gpu::Buffer::create("test queries", sizeof(glm::vec4) * 64, gpu::BufferUse::Dynamic));
    m_answers = testing::taken(gpu::Buffer::create("test answers", sizeof(glm::vec4) * 128, gpu::BufferUse::Static));
  }
  void TearDown() override {
    m_blades.reset();
    m_queries = {};
    m_answers = {};
    GrassPassTest::TearDown();
  }

  void configure(int most = 512) {
    const Status status = m_blades->configure(m_scene->grass, m_scene->field.resolution, most);
    ASSERT_TRUE(status.ok()) << status.error().text();
  }
  void step(float seconds, bool jumped = false) {
    m_scene->bindFrame(0.0);
    m_blades->step({seconds, jumped});
  }

  /// What the texture holds.
  std::vector<ChainLeans> moments() {
    const glm::ivec2 size = m_blades->grid();
    const std::size_t count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    std::vector<glm::vec4> texels(2 * count);
    m_blades->moments().read(GL_RGBA, GL_FLOAT, texels.data(), texels.size() * sizeof(glm::vec4));
    std::vector<ChainLeans> found(count);
    for (std::size_t i = 0; i < count; ++i) {
      const glm::vec4 low = texels[i], high = texels[count + i];
      found[i] = {{{low.x, low.y}, {low.z, low.w}, {high.x, high.y}, {high.z, high.w}}};
    }
    return found;
  }

  std::vector<ChainLeans> drawnAt(const std::vector<glm::vec4>& queries, float factor) {
    m_queries.write(std::span<const glm::vec4>(queries));
    gpu::Program& program = testProgram("virtual_leans.comp");
    m_scene->bindFrame(0.0);
    m_blades->bind();
    m_queries.bindStorage(0);
    m_answers.bindStorage(1);
    program.set("factor", factor);
    program.dispatch(static_cast<int>(queries.size()));
    std::vector<glm::vec4> answers(2 * queries.size());
    m_answers.read(answers.data(), answers.size() * sizeof(glm::vec4));
    std::vector<ChainLeans> leans;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const glm::vec4 low = answers[2 * i], high = answers[2 * i + 1];
      leans.push_back({{{low.x, low.y}, {low.z, low.w}, {high.x, high.y}, {high.z, high.w}}});
    }
    return leans;
  }

  std::optional<VirtualBlades> m_blades;
  gpu::Buffer m_queries, m_answers;
};

float difference(const ChainLeans& a, const ChainLeans& b) {
  float most = 0.0f;
  for (int i = 0; i < kSegments; ++i) most = std::max(most, glm::length(a.e[i] - b.e[i]));
  return most;
}

glm::vec2 windAt(int x, int z, int n) {
  const float gust = n < 20 ? 2.0f : n < 50 ? 11.0f : 4.0f;
  return {gust + 0.5f * static_cast<float>(x), 0.8f * static_cast<float>(z) - 3.0f};
}

TEST_F(VirtualBladesGpu, SwingAsTheChainOfTheProcessor) {
  configure();
  m_scene->blow([](int x, int z) { return windAt(x, z, 0); });
  step(0.0f, true);
  std::vector<ChainState> states;
  for (int i = 0; i < 64; ++i) states.push_back(shared::chainSteadyState(m_blades->chain(), windAt(i % 8, i / 8, 0)));
  for (int n = 0; n < 90; ++n) {
    const float dt = n == 55 ? 0.1f : kDt;
    m_scene->blow([&](int x, int z) { return windAt(x, z, n); });
    step(dt);
    for (int i = 0; i < 64; ++i) {
      auto& state = states[static_cast<std::size_t>(i)];
      state = shared::chainStep(m_blades->chain(), state, windAt(i % 8, i / 8, n), dt);
    }
    if (n % 10 != 9) continue;
    const auto found = moments();
    for (std::size_t i = 0; i < 64; ++i) {
      const ChainLeans wanted = shared::chainMoments(m_blades->chain(), shared::chainLeans(states[i]));
      ASSERT_LT(difference(found[i], wanted), 2e-3f) << "step " << n << " blade " << i;
    }
  }
}

TEST_F(VirtualBladesGpu, BeginAtRestInThePresentWindAndAfterJumps) {
  configure();
  m_scene->blow({9.0f, 2.0f});
  step(kDt);  // nothing yet to go on from
  const ChainLeans calm =
      shared::chainMoments(m_blades->chain(), shared::chainSteadyLeans(m_blades->chain(), {9.0f, 2.0f}));
  for (const ChainLeans& found : moments()) ASSERT_LT(difference(found, calm), 1e-3f);
  m_scene->blow({-4.0f, 0.0f});
  step(0.0f, true);
  const ChainLeans other =
      shared::chainMoments(m_blades->chain(), shared::chainSteadyLeans(m_blades->chain(), {-4.0f, 0.0f}));
  for (const ChainLeans& found : moments()) ASSERT_LT(difference(found, other), 1e-3f);
}

TEST_F(VirtualBladesGpu, StandStillWhileTimeDoes) {
  configure();
  m_scene->blow({2.0f, 0.0f});
  step(0.0f, true);
  m_scene->blow({9.0f, 0.0f});
  for (int n = 0; n < 10; ++n) step(kDt);
  const auto before = moments();
  step(0.0f);
  const auto after = moments();
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(difference(before[i], after[i]), 0.0f);
}

TEST_F(VirtualBladesGpu, DrawnBladesOvershootAndSettleAfterAGust) {
  configure();
  m_scene->blow({0.5f, 0.0f});
  step(0.0f, true);
  m_scene->blow({6.0f, 0.0f});
  float peak = 0.0f, last = 0.0f;
  for (int n = 0; n < 240; ++n) {
    step(kDt);
    last = drawnAt({{1.3f, -2.2f, 0.1f, 0.0f}}, m_blades->chain().wind.w)[0].e[3].x;
    peak = std::max(peak, last);
  }
  EXPECT_GT(peak, 1.15f * last);
  const ChainLeans moments =
      shared::chainMoments(m_blades->chain(), shared::chainSteadyLeans(m_blades->chain(), {6.0f, 0.0f}));
  const glm::vec2 rest(0.1f, 0.0f);
  const ChainLeans steady = shared::chainEquilibrium(m_blades->chain(), moments, rest,
                                                     shared::chainSoftness(m_blades->chain(), moments, rest, 1.0f));
  EXPECT_NEAR(last, steady.e[3].x, 0.02f);
}

TEST_F(VirtualBladesGpu, DrawnBladesReadBetweenTexelsAndFeelTheAmbientWindOutside) {
  m_scene->ambient.speed = 5.0f;
  configure();
  m_scene->blow([](int x, int) { return glm::vec2(2.0f * static_cast<float>(x), 1.0f); });
  step(0.0f, true);
  const auto texels = moments();
  // Centres of cells lie at -7, -5 .. 7 m.
  const glm::vec2 rest(0.0f, 0.25f);
  const auto drawn =
      drawnAt({{-1.0f, 1.0f, rest}, {-0.5f, 1.0f, rest}, {60.0f, 0.0f, rest}}, 1.2f * m_blades->chain().wind.w);
  const auto expected = [&](const ChainLeans& held) {
    return shared::chainEquilibrium(m_blades->chain(), held, rest,
                                    shared::chainSoftness(m_blades->chain(), held, rest, 1.2f));
  };
  const ChainLeans here = texels[4 * 8 + 3], beside = texels[4 * 8 + 4];
  EXPECT_LT(difference(drawn[0], expected(here)), 2e-3f);
  ChainLeans between;
  for (int i = 0; i < kSegments; ++i) between.e[i] = glm::mix(here.e[i], beside.e[i], 0.25f);
  EXPECT_LT(difference(drawn[1], expected(between)), 3e-3f);
  EXPECT_GT(difference(drawn[0], drawn[1]), 0.02f);
  const ChainLeans outside =
      shared::chainMoments(m_blades->chain(), shared::chainSteadyLeans(m_blades->chain(), {5.0f, 0.0f}));
  EXPECT_LT(difference(drawn[2], expected(outside)), 2e-3f);
}

TEST_F(VirtualBladesGpu, TheGridIsAWholePartOfTheWinds) {
  EXPECT_EQ(virtualGrid({8, 8}, 512), glm::ivec2(8, 8));
  EXPECT_EQ(virtualGrid({512, 300}, 512), glm::ivec2(512, 300));
  EXPECT_EQ(virtualGrid({1000, 1000}, 512), glm::ivec2(500, 500));
  EXPECT_EQ(virtualGrid({1000, 10}, 128), glm::ivec2(125, 2));
  EXPECT_EQ(virtualGrid({4096, 4096}, 512), glm::ivec2(512, 512));
  configure(4);
  EXPECT_EQ(m_blades->grid(), glm::ivec2(4, 4));
  m_scene->blow([](int x, int) { return glm::vec2(x % 2 == 0 ? 2.0f : 6.0f, 0.0f); });
  step(0.0f, true);
  const ChainLeans mean =
      shared::chainMoments(m_blades->chain(), shared::chainSteadyLeans(m_blades->chain(), {4.0f, 0.0f}));
  for (const ChainLeans& found : moments())
    EXPECT_LT(difference(found, mean), 2e-3f) << "a blade reads the mean of its cells";
}

TEST_F(VirtualBladesGpu, NoWindLeavesBladesAsTheyRest) {
  configure();
  const auto drawn = drawnAt({{0.0f, 0.0f, 0.3f, 0.2f}, {40.0f, 0.0f, 0.0f, 0.0f}}, 0.06f);
  for (const ChainLeans& leans : drawn) {
    for (const glm::vec2 lean : leans.e) EXPECT_LT(glm::length(lean), 1e-4f);
  }
}

}  // namespace
}  // namespace windloom
