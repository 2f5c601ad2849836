// What the culling of Bezier grass counts, against every blade looked at on the processor.
#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include "engine/gpu/framebuffer.hpp"
#include "engine/grass/bezier_grass.hpp"
#include "shaders/shared/bezier_cull.h"
#include "shaders/shared/bezier_pose.h"
#include "tests/gpu/gpu_test.hpp"
#include "tests/gpu/grass/grass_scene.hpp"

namespace windloom::testing {
namespace {

using namespace shared;

constexpr glm::ivec2 kSize{255, 191};  // odd: a texel of what hides is 2 x 2 pixels, cut at the edge

class BezierCullGpu : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    m_scene.emplace(shaders());
    m_scene->size = kSize;
    m_scene->camera.position = {1.0f, 2.2f, 9.0f};
    m_scene->camera.target = {0.0f, 0.2f, -2.0f};
    m_scene->grass.density = 90.0f;
    m_scene->grass.kind = GrassKind::Bezier;
    m_grass.emplace(taken(BezierGrass::create(shaders())));
    m_target = taken(gpu::Framebuffer::create("test target", kSize, {.colour = GL_RGBA8}));
    BezierSettings bezier;
    bezier.reach = 30.0f;
    bezier.dandelions = 0.1f;
    m_project.bezier = std::make_shared<BezierSettings>(bezier);
  }
  void TearDown() override {
    m_grass.reset();
    m_scene.reset();
    m_target = {};
    GpuTest::TearDown();
  }

  BezierCounts count(const BezierCulling& tests) {
    m_project.field = std::make_shared<FieldSettings>(m_scene->field);
    m_project.grass = std::make_shared<GrassSettings>(m_scene->grass);
    m_scene->bindFrame(0.0);
    BezierFrame frame;
    frame.tests = tests;
    EXPECT_TRUE(m_grass->configure(m_project, Placement::Wait).ok());
    EXPECT_TRUE(m_grass->bindSettings(m_project, frame).ok());
    m_grass->findSeen();
    m_target.clearColour(glm::vec4(0.0f));
    m_target.clearDepth(1.0f);
    const gpu::PassState state{
        .framebuffer = m_target.name(), .viewport = {0, 0, kSize.x, kSize.y}, .depth = gpu::Depth::TestAndWrite};
    using Round = BezierGrass::Round;
    m_grass->cull(Round::First, m_target.depth());
    m_grass->draw(Round::First, state);
    m_depths.resize(static_cast<std::size_t>(kSize.x * kSize.y));
    m_target.depth().read(GL_DEPTH_COMPONENT, GL_FLOAT, m_depths.data(), m_depths.size() * sizeof(float));
    m_grass->cull(Round::Rest, m_target.depth());
    m_grass->draw(Round::Rest, state);
    glFinish();
    return m_grass->counts();
  }

  [[nodiscard]] glm::vec3 eye() const { return m_scene->camera.position; }
  [[nodiscard]] float pixelsAt(glm::vec3 place) const {
    return m_scene->frame.pixelScale.x /
           std::max(glm::dot(place - eye(), glm::vec3(m_scene->frame.viewForward)), 0.05f);
  }
  [[nodiscard]] float farthestAt(glm::vec2 uv) const {
    const glm::ivec2 half = glm::ivec2(uv * glm::vec2(kSize)) / 2;
    float farthest = 0.0f;
    for (int i = 0; i < 4; ++i) {
      const glm::ivec2 pixel = glm::min(2 * half + glm::ivec2(i & 1, i >> 1), kSize - 1);
      farthest = std::max(farthest, m_depths[static_cast<std::size_t>(pixel.y * kSize.x + pixel.x)]);
    }
    return farthest;
  }
  [[nodiscard]] bool hidden(glm::vec3 place) const {
    const glm::vec3 nearer = place + glm::normalize(eye() - place) * 0.06f;
    const glm::vec4 clip = m_scene->frame.viewProjection * glm::vec4(nearer, 1.0f);
    const glm::vec2 uv = 0.5f + 0.5f * glm::vec2(clip) / clip.w;
    if (clip.w <= 0.0f || glm::any(glm::lessThan(uv, glm::vec2(0.0f))) ||
        glm::any(glm::greaterThanEqual(uv, glm::vec2(1.0f)))) {
      return false;
    }
    return 0.5f + 0.5f * clip.z / clip.w > farthestAt(uv);
  }
  [[nodiscard]] bool inSight(const BezierPatch& part) const {
    for (const glm::vec4& plane : m_scene->frame.frustum) {
      const float reach = glm::dot(glm::abs(glm::vec3(plane)), glm::vec3(part.reach));
      if (glm::dot(glm::vec3(plane), glm::vec3(part.centre)) + plane.w < -reach) return false;
    }
    return true;
  }
  /// Large blades; of the other patches the first blades are, too.
  [[nodiscard]] bool drawnFirst(const BezierPatch& part) const {
    const glm::vec3 centre(part.centre), reach(part.reach);
    return m_scene->grass.height * pixelsAt(glm::clamp(eye(), centre - reach, centre + reach)) > BEZIER_FIRST_PIXELS;
  }
  [[nodiscard]] bool outside(glm::vec3 root, glm::vec2 sizes, const BezierCurve& curve) const {
    const glm::vec2 pixel = 2.0f / glm::vec2(kSize);
    for (const float v : {0.0f, 0.5f, 1.0f}) {
      const glm::vec4 clip = m_scene->frame.viewProjection * glm::vec4(root + bezierPoint(curve, v), 1.0f);
      if (insideClip(clip, 2.0f * sizes.y * m_scene->frame.pixelScale.x * pixel + pixel * clip.w)) return false;
    }
    return true;
  }

  /// Every blade of the patches in sight, one after the other.
  [[nodiscard]] BezierCounts bruteForce(const BezierCulling& tests) const {
    const BezierMeadow meadow = placeBezier(m_project);
    BezierCounts counts;
    for (std::size_t p = 0; p < meadow.patches.size(); ++p) {
      const BezierPatch& part = meadow.patches[p];
      if (!inSight(part)) continue;
      ++counts.patchesSeen;
      const int blades = static_cast<int>(part.centre.w);
      counts.inPatches += blades;
      for (int lane = 0; lane < blades; ++lane) {
        const BezierBlade& blade = meadow.blades[p * BEZIER_PATCH + static_cast<std::size_t>(lane)];
        const glm::vec3 root(blade.x, blade.y, blade.z), up = octahedralVector(glm::unpackSnorm2x16(blade.up));
        const glm::vec2 sizes = glm::unpackHalf2x16(blade.sizes);
        const BezierCurve curve = bezierValid(up * sizes.x, up, sizes.x);
        const glm::vec3 across = bezierAcross(up, static_cast<float>(blade.growth >> 16u) / 65535.0f);
        const float kept =
            keptAtDistance(distanceOverGround(root, up, eye()), 30.0f, sizes.y * pixelsAt(root), BEZIER_THIN_PIXELS);
        const float rank = (static_cast<float>(lane) + 0.5f) / static_cast<float>(blades);
        if (tests.orientation && seenFromSide(across, glm::normalize(root - eye()), 0.9f) <= 0.0f) {
          ++counts.orientation;
        } else if (tests.frustum && outside(root, sizes, curve)) {
          ++counts.frustum;
        } else if (tests.distance && grownAtRank(rank, kept, 8.0f) <= 0.0f) {
          ++counts.distance;
        } else if (tests.occlusion && !drawnFirst(part) &&
                   lane >= static_cast<int>(static_cast<float>(blades) * BEZIER_FIRST_PART) &&
                   hidden(root + curve.tip) && hidden(root + bezierPoint(curve, 0.5f)) &&
                   hidden(root + bezierPoint(curve, 0.8f)) && hidden(root)) {
          ++counts.occlusion;
        } else {
          ++counts.drawn;
        }
      }
    }
    return counts;
  }

  void compare(const BezierCulling& tests) {
    const BezierCounts gpu = count(tests), cpu = bruteForce(tests);
    // Blades within a rounding error of a limit may fall to either side.
    const long long slack = std::max(3LL, cpu.inPatches / 10'000);
    EXPECT_EQ(gpu.patchesSeen, cpu.patchesSeen);
    EXPECT_EQ(gpu.inPatches, cpu.inPatches);
    EXPECT_NEAR(static_cast<double>(gpu.orientation), static_cast<double>(cpu.orientation), static_cast<double>(slack));
    EXPECT_NEAR(static_cast<double>(gpu.frustum), static_cast<double>(cpu.frustum), static_cast<double>(slack));
    EXPECT_NEAR(static_cast<double>(gpu.distance), static_cast<double>(cpu.distance), static_cast<double>(slack));
    EXPECT_NEAR(static_cast<double>(gpu.occlusion), static_cast<double>(cpu.occlusion), static_cast<double>(slack));
    EXPECT_NEAR(static_cast<double>(gpu.drawn), static_cast<double>(cpu.drawn), static_cast<double>(slack));
    EXPECT_EQ(gpu.inPatches, gpu.orientation + gpu.frustum + gpu.distance + gpu.occlusion + gpu.drawn);
    EXPECT_GT(gpu.inPatches, 10'000);
    EXPECT_GT(gpu.orientation, tests.orientation ? 1000 : -1);
    EXPECT_GT(gpu.frustum, tests.frustum ? 100 : -1);
    EXPECT_GT(gpu.distance, tests.distance ? 1000 : -1);
    EXPECT_GT(gpu.occlusion, tests.occlusion ? 100 : -1);
  }

  std::optional<GrassScene> m_scene;
  std::optional<BezierGrass> m_grass;
  gpu::Framebuffer m_target;
  Project m_project;
  std::vector<float> m_depths;
};

constexpr BezierCulling kNone{false, false, false, false};

TEST_F(BezierCullGpu, WithoutTestsEveryBladeOfThePatchesInSightIsDrawn) {
  const BezierCounts counts = count(kNone);
  EXPECT_EQ(counts.drawn, counts.inPatches);
  compare(kNone);
}

TEST_F(BezierCullGpu, CountsBladesSeenEdgeOn) {
  BezierCulling tests = kNone;
  tests.orientation = true;
  compare(tests);
}

TEST_F(BezierCullGpu, CountsBladesOutOfSight) {
  BezierCulling tests = kNone;
  tests.frustum = true;
  compare(tests);
}

TEST_F(BezierCullGpu, CountsBladesThinnedByDistance) {
  BezierCulling tests = kNone;
  tests.distance = true;
  compare(tests);
}

TEST_F(BezierCullGpu, CountsBladesHiddenByThoseDrawnFirst) {
  BezierCulling tests = kNone;
  tests.occlusion = true;
  m_scene->camera.position = {1.0f, 0.7f, 9.0f};
  compare(tests);
}

TEST_F(BezierCullGpu, CountsABladeForTheFirstTestThatLeavesItOut) {
  m_scene->camera.position = {1.0f, 0.7f, 9.0f};
  compare({});
}

TEST_F(BezierCullGpu, WithoutCullingNotEvenPatchesAreLeftOut) {
  m_scene->bindFrame(0.0);
  m_project.field = std::make_shared<FieldSettings>(m_scene->field);
  m_project.grass = std::make_shared<GrassSettings>(m_scene->grass);
  ASSERT_TRUE(m_grass->configure(m_project, Placement::Wait).ok());
  BezierFrame frame;
  frame.culling = false;
  frame.thinning = false;
  ASSERT_TRUE(m_grass->bindSettings(m_project, frame).ok());
  m_grass->findSeen();
  const gpu::PassState state{.framebuffer = m_target.name(), .viewport = {0, 0, kSize.x, kSize.y}};
  m_grass->cull(BezierGrass::Round::First, m_target.depth());
  m_grass->draw(BezierGrass::Round::First, state);
  m_grass->cull(BezierGrass::Round::Rest, m_target.depth());
  m_grass->draw(BezierGrass::Round::Rest, state);
  glFinish();
  EXPECT_EQ(m_grass->counts().drawn, m_grass->counts().blades);
}

}  // namespace
}  // namespace windloom::testing
