#include "engine/render/collider_pass.hpp"

#include "engine/model/collider_motion.hpp"
#include "engine/render/frame_block.hpp"
#include "tests/gpu/render/render_fixture.hpp"
#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

using testing::difference;
using testing::Picture;

class Colliders : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setField(40);
    setDensity(0.0f);
    m_input.camera = testing::above({0, 0}, 3.0f);
  }
  void show(std::vector<Collider> colliders) {
    m_project.colliders = std::make_shared<std::vector<Collider>>(std::move(colliders));
  }
  Picture pictureOf(std::vector<Collider> colliders) {
    show(std::move(colliders));
    return picture();
  }
};

/// A square of 1 m that lies level, 0.2 m over its origin.
std::shared_ptr<PlantMesh> tile(glm::vec4 colour) {
  auto mesh = std::make_shared<PlantMesh>();
  mesh->file = "tile.glb";
  for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(1, 1)}) {
    mesh->vertices.push_back({{at.x - 0.5f, 0.2f, at.y - 0.5f}, {0, 1, 0}, at, colour});
  }
  mesh->indices = {0, 2, 1, 1, 2, 3};
  mesh->low = {-0.5f, 0.0f, -0.5f};
  mesh->high = {0.5f, 0.2f, 0.5f};
  return mesh;
}

Collider placed(std::shared_ptr<const PlantMesh> mesh) {
  Collider collider;
  collider.shape = ColliderShape::Mesh;
  collider.mesh = std::move(mesh);
  return collider;
}

glm::vec3 middle(const Picture& picture) {
  const glm::ivec2 half = picture.size / 2;
  return picture.mean(half - 10, half + 10);
}

TEST_F(Colliders, EachShapeIsSeenWhereItIsAndNotWhereItIsHidden) {
  const Picture bare = pictureOf({});
  Collider ball;
  Collider capsule;
  capsule.shape = ColliderShape::Capsule;
  capsule.radius = 0.3f;
  for (Collider collider : {ball, capsule, placed(tile(glm::vec4(1.0f)))}) {
    const Picture shown = pictureOf({collider});
    EXPECT_GT(glm::distance(middle(shown), middle(bare)), 15.0f) << int(collider.shape);
    EXPECT_LT(glm::distance(shown.mean({0, 0}, {20, 20}), bare.mean({0, 0}, {20, 20})), 12.0f);
    collider.hidden = true;
    EXPECT_EQ(pictureOf({collider}).rgba, bare.rgba) << int(collider.shape);
    collider.hidden = false;
    collider.muted = true;
    EXPECT_EQ(pictureOf({collider}).rgba, shown.rgba) << "muted only for the grass";
  }
}

TEST_F(Colliders, ABallThatRolledShowsOtherPanels) {
  Collider resting;
  resting.keys = {{0, {0, 0, 0}}};
  const Picture before = pictureOf({resting});
  Collider rolled;  // ends at the same place
  rolled.position = {-0.9f, 0.2f};
  rolled.keys = {{0, {0, 0, 0}}, {1, {0.9f, 0, -0.2f}}};
  rolled.loop = false;
  m_input.time = 2.0;
  EXPECT_GT(difference(pictureOf({rolled}), before), 1.0f);
  rolled.roll = resting.roll = false;
  resting.rotation = glm::degrees(colliderHeading(rolled, 2.0));
  m_input.time = 2.0;
  EXPECT_LT(difference(pictureOf({rolled}), pictureOf({resting})), 0.05f);
}

TEST_F(Colliders, AnObstacleInFrontHidesThem) {
  Obstacle stone;
  stone.height = 4.0f;
  m_project.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{stone});
  const Picture before = pictureOf({});
  Collider inside;
  inside.radius = 0.1f;  // its shadow ends in the stone, too
  EXPECT_EQ(pictureOf({inside}).rgba, before.rgba);
}

TEST_F(Colliders, AMeshHasItsColoursItsTextureAndItsHoles) {
  const glm::vec3 blue = middle(pictureOf({placed(tile({0.02f, 0.02f, 0.8f, 1.0f}))}));
  EXPECT_GT(blue.b, 2.0f * blue.r);
  auto textured = tile(glm::vec4(1.0f));
  textured->textureSize = {2, 1};
  textured->texture = {255, 0, 0, 255, 255, 0, 0, 255};
  const glm::vec3 red = middle(pictureOf({placed(textured)}));
  EXPECT_GT(red.r, 2.0f * red.b);
  const Picture bare = pictureOf({});
  auto hole = tile({1, 1, 1, 0.2f});
  EXPECT_LT(glm::distance(middle(pictureOf({placed(hole)})), middle(bare)), 1.0f);
}

TEST_F(Colliders, TheyStandOnUnevenGround) {
  const auto high = testing::heightsFrom({33, 33}, {32, 32}, [](glm::vec2) { return 3.0f; });
  const Picture flat = pictureOf({Collider{}});
  m_project.terrain = testing::terrainOf(high);
  const Picture raised = picture();
  EXPECT_LT(glm::distance(middle(raised), middle(flat)), 12.0f) << "the same ball, 3 m higher";
}

constexpr glm::vec3 kSun{0.0f, 0.6f, 0.8f};

TEST(ColliderShades, NothingTakesNoLight) {
  const ColliderShadeBlock block = makeColliderShades({}, 0.0, {0, 0, 0}, kSun);
  EXPECT_EQ(block.low.w, 0.0f);
  EXPECT_GT(block.low.x, block.high.x);
}

TEST(ColliderShades, ReachToTheEndOfTheShadow) {
  Project project;
  Collider ball;
  ball.lift = 2.0f;
  project.colliders = std::make_shared<std::vector<Collider>>(std::vector{ball});
  const ColliderShadeBlock block = makeColliderShades(project, 0.0, {0, 0, 0}, kSun);
  EXPECT_EQ(block.low.w, 1.0f);
  EXPECT_EQ(block.spheres[0], glm::vec4(0, 2.5f, 0, 0.5f));
  // Its shadow's middle lies where the ray from the sun through the centre meets the ground.
  EXPECT_LT(block.low.z, -2.5f * 0.8f / 0.6f - 0.5f / 0.6f);
  EXPECT_LE(block.low.y, 0.0f);
  ball.hidden = true;
  project.colliders = std::make_shared<std::vector<Collider>>(std::vector{ball});
  EXPECT_EQ(makeColliderShades(project, 0.0, {0, 0, 0}, kSun).low.w, 0.0f);
}

TEST(ColliderShades, OfTooManyTheNearestCount) {
  Project project;
  std::vector<Collider> many(100);
  for (std::size_t i = 0; i < many.size(); ++i) many[i].position.x = static_cast<float>(i);
  project.colliders = std::make_shared<std::vector<Collider>>(many);
  const ColliderShadeBlock block = makeColliderShades(project, 0.0, {99, 0, 0}, kSun);
  EXPECT_EQ(block.low.w, float(COLLIDER_SHADE_SPHERES));
  for (const glm::vec4& sphere : block.spheres) EXPECT_GE(sphere.x, 100.0f - COLLIDER_SHADE_SPHERES);
}

TEST(ColliderShades, AMeshIsItsLargestSpheres) {
  Project project;
  auto mesh = tile(glm::vec4(1.0f));
  for (int i = 0; i < 40; ++i) mesh->spheres.emplace_back(0, 0, 0, 0.01f * float(i + 1));
  project.colliders = std::make_shared<std::vector<Collider>>(std::vector{placed(mesh)});
  const ColliderShadeBlock block = makeColliderShades(project, 0.0, {0, 0, 0}, kSun);
  ASSERT_EQ(block.low.w, 16.0f);
  for (int i = 0; i < 16; ++i) EXPECT_GT(block.spheres[i].w, 0.2f);
}

}  // namespace
}  // namespace windloom
