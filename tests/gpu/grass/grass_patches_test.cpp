#include "engine/grass/grass_patches.hpp"

#include <gtest/gtest.h>

#include "engine/grass/segment_chain.hpp"
#include "engine/grass/virtual_blades.hpp"
#include "tests/gpu/grass/grass_fixture.hpp"

namespace windloom {
namespace {

constexpr float kDt = 1.0f / 60.0f;
constexpr int kSegments = CHAIN_SEGMENTS;

/// As patch_leans.comp writes it.
struct Seen {
  glm::vec4 root;
  glm::vec4 points[kSegments];
  glm::vec4 low, high;
  glm::uvec4 tile;

  [[nodiscard]] bool drawn() const { return root.w > 0.5f; }
  [[nodiscard]] int slot() const { return static_cast<int>(points[0].w); }
  [[nodiscard]] glm::vec2 lean(int i) const {
    const glm::vec4 pair = i < 2 ? low : high;
    return i % 2 == 0 ? glm::vec2(pair.x, pair.y) : glm::vec2(pair.z, pair.w);
  }
};

class GrassPatchesGpu : public testing::GrassPassTest {
 protected:
  void SetUp() override {
    GrassPassTest::SetUp();
    m_scene->grass.density = 150.0f;
    auto patches = GrassPatches::create(shaders());
    ASSERT_TRUE(patches.ok()) << patches.error().text();
    m_patches.emplace(std::move(*patches));
    auto blades = VirtualBlades::create(shaders());
    ASSERT_TRUE(blades.ok()) << blades.error().text();
    m_blades.emplace(std::move(*blades));
    m_answers = testing::taken(gpu::Buffer::create("test answers", sizeof(Seen) * 4096, gpu::BufferUse::Static));
    m_scene->blow({3.0f, 1.0f});
  }
  void TearDown() override {
    m_patches.reset();
    m_blades.reset();
    m_answers = {};
    GrassPassTest::TearDown();
  }

  void configure() {
    Status status = m_patches->configure(m_scene->grass, m_scene->layout(),
                                         m_scene->grass.height * (1.0f + m_scene->grass.heightVariation));
    ASSERT_TRUE(status.ok()) << status.error().text();
    status = m_blades->configure(m_scene->grass, m_scene->field.resolution);
    ASSERT_TRUE(status.ok()) << status.error().text();
  }

  void step(const std::vector<ColliderPrimitive>& primitives, DynamicsStep step = {kDt, false}) {
    m_time += static_cast<double>(step.seconds);
    m_scene->bindFrame(m_time);
    m_blades->step(step);
    m_blades->bind();
    m_patches->step(step, primitives, m_scene->heights.get());
  }

  std::vector<Seen> blades(glm::ivec2 tile) {
    const GrassLayout tiles = m_scene->layout();
    gpu::Program& program = testProgram("patch_leans.comp");
    m_scene->bindFrame(m_time);
    m_blades->bind();
    m_patches->bind();
    m_answers.bindStorage(0);
    program.set("tile", tile);
    const int count = static_cast<int>(tiles.bladesInTile);
    program.dispatch(count);
    std::vector<Seen> seen(static_cast<std::size_t>(count));
    m_answers.read(seen.data(), seen.size() * sizeof(Seen));
    return seen;
  }
  std::vector<Seen> bladesOfPatches() {
    std::vector<Seen> all;
    for (const GrassPatch& patch : m_patches->cells().patches()) {
      const auto some = blades({patch.x, patch.z});
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }
  [[nodiscard]] glm::ivec2 tileOf(glm::vec2 place) const {
    return glm::ivec2(glm::floor(place / m_scene->layout().tileSideM));
  }

  std::optional<GrassPatches> m_patches;
  std::optional<VirtualBlades> m_blades;
  gpu::Buffer m_answers;
  double m_time = 10.0;
};

ColliderPrimitive ball(glm::vec3 centre, float radius) {
  return {glm::vec4(centre, radius), glm::vec4(centre, 0.0f)};
}

/// The slope that blades stand on and their axes: fixture's slope rises along x.
glm::vec3 planted(glm::vec3 v, float rise, float align) {
  const glm::vec3 normal = glm::normalize(glm::vec3(-rise, 1.0f, 0.0f));
  const glm::vec3 up = glm::normalize(glm::mix(glm::vec3(0, 1, 0), normal, align));
  const glm::vec3 axis(up.z, 0.0f, -up.x);
  return v * up.y + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0f + up.y));
}

/// The least distance of a blade's points to the primitives, m.
float leastDistance(const Seen& blade, const std::vector<ColliderPrimitive>& primitives, float rise, float align) {
  float least = 1e9f;
  glm::vec3 before(0.0f);
  for (const glm::vec4& end : blade.points) {
    for (int n = 0; n <= 12; ++n) {
      const glm::vec3 local = glm::mix(before, glm::vec3(end), static_cast<float>(n) / 12.0f);
      const glm::vec3 point = glm::vec3(blade.root) + (rise == 0.0f ? local : planted(local, rise, align));
      for (const ColliderPrimitive& primitive : primitives)
        least = std::min(least, shared::colliderDistance(primitive, point));
    }
    before = glm::vec3(end);
  }
  return least;
}

TEST_F(GrassPatchesGpu, NoBladeStaysInsideOfWhatMovesThroughIt) {
  for (const Deformation deformation : {Deformation::Arc, Deformation::Quadratic, Deformation::Inertial}) {
    for (const float rise : {0.0f, 0.3f}) {
      m_scene->grass.deformation = deformation;
      m_scene->setSlope(rise);
      configure();
      step({}, {0.0f, true});
      int bent = 0, hidden = 0;
      for (int n = 0; n < 50; ++n) {
        const float x = -1.0f + 0.04f * static_cast<float>(n);
        const std::vector<ColliderPrimitive> primitives{
            ball({x, 0.35f + x * rise, 0.2f}, 0.35f),
            {glm::vec4(x, 0.12f + x * rise, 1.6f, 0.1f), glm::vec4(x + 0.2f, 0.14f + (x + 0.2f) * rise, 1.7f, 0.0f)}};
        step(primitives);
        if (n % 7 != 6) continue;
        for (const Seen& blade : bladesOfPatches()) {
          if (!blade.drawn()) {
            ++hidden;
            continue;
          }
          const float away = leastDistance(blade, primitives, rise, m_scene->grass.slopeAlign);
          ASSERT_GT(away, 0.001f) << "step " << n << " root " << blade.root.x << ", " << blade.root.z;
          bent += glm::length(blade.lean(3)) > 0.1f ? 1 : 0;
        }
      }
      EXPECT_GT(bent, 300) << "deformation " << static_cast<int>(deformation);
      EXPECT_LT(hidden, bent / 3);
    }
  }
}

TEST_F(GrassPatchesGpu, BladesThatNothingTouchedStandAsInTheirBlock) {
  configure();
  step({}, {0.0f, true});
  const std::vector<ColliderPrimitive> beside{ball({0.0f, 1.0f, 0.0f}, 0.1f)};
  for (int n = 0; n < 5; ++n) step(beside);
  ASSERT_FALSE(m_patches->cells().patches().empty());
  for (const Seen& blade : bladesOfPatches()) {
    ASSERT_TRUE(blade.drawn());
    ASSERT_GE(blade.slot(), 0);
    for (int i = 0; i < kSegments; ++i) ASSERT_EQ(glm::length(blade.lean(i)), 0.0f);
  }
}

TEST_F(GrassPatchesGpu, TilesThatAreNoPatchesAreNotFound) {
  configure();
  step({}, {0.0f, true});
  EXPECT_EQ(blades({0, 0})[0].slot(), -1);
  step({ball({0.5f, 0.3f, 0.5f}, 0.3f)});
  EXPECT_GE(blades(tileOf({0.5f, 0.5f}))[0].slot(), 0);
  EXPECT_EQ(blades(tileOf({-7.5f, 7.5f}))[0].slot(), -1);
}

/// The joints of a patch's blade as they are remembered.
std::vector<glm::vec4> remembered(const GrassPatches& patches, std::uint32_t slot, std::size_t index) {
  const auto stride = static_cast<std::size_t>(patches.cells().stride());
  const std::size_t all = stride * static_cast<std::size_t>(patches.cells().slots());
  std::vector<glm::vec4> joints(kSegments);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    patches.state().read(&joints[i], sizeof(glm::vec4), (i * all + slot * stride + index) * sizeof(glm::vec4));
  }
  return joints;
}

TEST_F(GrassPatchesGpu, BladesRiseAsDampedSwingsAndOvershoot) {
  configure();
  step({}, {0.0f, true});
  for (int n = 0; n < 20; ++n) step({ball({0.4f, 0.4f, 0.4f}, 0.4f)});
  const glm::ivec2 tile = tileOf({0.4f, 0.4f});
  const auto pressed = blades(tile);
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    if (pressed[i].drawn() && glm::length(pressed[i].lean(3)) > glm::length(pressed[chosen].lean(3))) chosen = i;
  }
  ASSERT_GT(glm::length(pressed[chosen].lean(3)), 0.5f);
  const auto slot = static_cast<std::uint32_t>(pressed[chosen].slot());
  std::vector<glm::vec4> joints = remembered(*m_patches, slot, chosen);
  int still = 0;
  for (const glm::vec4& joint : joints) still += joint.x != 0.0f && joint.z == 0.0f && joint.w == 0.0f ? 1 : 0;
  EXPECT_GT(still, 0) << "what was bent stands still";

  // Each joint by the chain's own rule on the processor.
  const float rate = shared::patchRate(pressed[chosen].tile.x, static_cast<std::uint32_t>(chosen));
  const float omega0 = 2.0f * 3.14159265f * m_scene->grass.swingRate * rate;
  const float damping = 2.0f * m_scene->grass.swingDamping * omega0;
  const int parts = shared::chainParts(kDt, omega0 * omega0);
  float across = 1.0f;  // least of the lean along the first one
  for (int n = 0; n < 60; ++n) {
    step({});
    glm::vec2 lean(0.0f);
    for (glm::vec4& joint : joints) {
      glm::vec3 psi(joint.x, 0.0f, joint.y), omega(joint.z, 0.0f, joint.w);
      for (int part = 0; part < parts; ++part) {
        const float dt = kDt / static_cast<float>(parts);
        const glm::vec3 mean = shared::chainMeanOmega(psi, omega, glm::vec3(0.0f), omega0 * omega0, damping, dt);
        omega = 2.0f * mean - omega;
        psi += mean * dt;
      }
      joint = {psi.x, psi.z, omega.x, omega.z};
      lean += glm::vec2(joint.x, joint.y);
    }
    const glm::vec2 got = blades(tile)[chosen].lean(3);
    ASSERT_LT(glm::length(got - lean), 2e-3f) << n;
    across = std::min(across, glm::dot(got, glm::normalize(pressed[chosen].lean(3))));
  }
  EXPECT_LT(across, -0.15f) << "it swings through";
}

TEST_F(GrassPatchesGpu, KinksSpreadAlongTheBladeWhileItRises) {
  m_scene->grass.swingRate = 0.3f;
  configure();
  step({}, {0.0f, true});
  for (int n = 0; n < 20; ++n) step({ball({0.4f, 0.4f, 0.4f}, 0.4f)});
  const glm::ivec2 tile = tileOf({0.4f, 0.4f});
  /// How unevenly the bends of the bent blades lie along them.
  const auto unevenness = [&] {
    float spread = 0.0f, whole = 0.0f;
    for (const Seen& blade : blades(tile)) {
      if (!blade.drawn()) continue;
      whole += glm::length(blade.lean(3));
      for (int i = 0; i < kSegments; ++i) {
        const glm::vec2 below = i == 0 ? glm::vec2(0.0f) : blade.lean(i - 1);
        spread += glm::length(blade.lean(i) - below - 0.25f * blade.lean(3));
      }
    }
    return spread / whole;
  };
  step({});
  const float before = unevenness();
  for (int n = 0; n < 15; ++n) step({});
  EXPECT_GT(before, 0.1f);
  EXPECT_LT(unevenness(), 0.35f * before) << "after a quarter of a second, long before it stands";
}

TEST_F(GrassPatchesGpu, SettledPatchesReturnToBlocksUnseen) {
  m_scene->grass.swingDamping = 0.6f;
  configure();
  step({}, {0.0f, true});
  for (int n = 0; n < 10; ++n) step({ball({0.4f, 0.4f, 0.4f}, 0.4f)});
  const glm::ivec2 tile = tileOf({0.4f, 0.4f});
  step({});
  float last = 1.0f;
  int steps = 0;
  for (; steps < 1000 && blades(tile)[0].slot() >= 0; ++steps) {
    last = 0.0f;
    for (const Seen& blade : blades(tile)) {
      ASSERT_TRUE(blade.drawn());
      last = std::max(last, glm::length(blade.lean(3)));
    }
    step({});
  }
  EXPECT_LT(steps, 1000);
  EXPECT_LT(last * m_scene->grass.height, 0.0015f) << "m that any tip moves by as the patch becomes a block";
}

TEST_F(GrassPatchesGpu, AJumpInTimeLetsAllBladesUp) {
  configure();
  step({}, {0.0f, true});
  for (int n = 0; n < 5; ++n) step({ball({0.4f, 0.4f, 0.4f}, 0.4f)});
  ASSERT_FALSE(m_patches->cells().patches().empty());
  step({}, {0.0f, true});
  EXPECT_TRUE(m_patches->cells().patches().empty());
  EXPECT_EQ(blades(tileOf({0.4f, 0.4f}))[0].slot(), -1);
  // The slot's next owner knows nothing of it.
  step({ball({-5.0f, 1.0f, -5.0f}, 0.1f)});
  ASSERT_FALSE(m_patches->cells().patches().empty());
  for (const Seen& blade : bladesOfPatches()) ASSERT_EQ(glm::length(blade.lean(3)), 0.0f);
}

TEST_F(GrassPatchesGpu, BendsWhilePausedToo) {
  configure();
  step({}, {0.0f, true});
  step({ball({0.4f, 0.4f, 0.4f}, 0.4f)}, {0.0f, false});
  float most = 0.0f;
  for (const Seen& blade : bladesOfPatches()) most = std::max(most, blade.drawn() ? glm::length(blade.lean(3)) : 0.0f);
  EXPECT_GT(most, 0.5f);
}

TEST_F(GrassPatchesGpu, NothingIsRememberedWhereNothingMay) {
  m_scene->grass.interacting = 0;
  configure();
  step({}, {0.0f, true});
  step({ball({0.4f, 0.4f, 0.4f}, 0.4f)});
  EXPECT_TRUE(m_patches->cells().patches().empty());
  EXPECT_EQ(blades(tileOf({0.4f, 0.4f}))[0].slot(), -1);
}

}  // namespace
}  // namespace windloom
