// Meshes that grass is to grow on: whatever a file holds, it is read or refused with a message.
#include <gtest/gtest.h>

#include <limits>

#include "engine/core/file.hpp"
#include "engine/io/plant_file.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/io/gltf_fixture.hpp"

namespace windloom {
namespace {

using testing::GltfBuilder;
using testing::standingTriangle;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

GltfBuilder triangles(const std::vector<float>& places) {
  GltfBuilder builder;
  builder.attribute("POSITION", builder.add<float>(places, 5126, "VEC3", 3));
  return builder;
}

class SurfaceFiles : public ::testing::Test {
 protected:
  Result<std::shared_ptr<PlantMesh>> read(const GltfBuilder& builder) {
    const std::filesystem::path path = m_folder.path() / "hill.glb";
    EXPECT_TRUE(writeFileAtomically(path, builder.glb()).ok());
    return readPlantFile(path, MeshUse::Surface);
  }
  std::string refusal(const GltfBuilder& builder) {
    const auto mesh = read(builder);
    if (mesh.ok()) return "taken";
    EXPECT_NE(mesh.error().text().find("hill.glb"), std::string::npos) << "names its file: " << mesh.error().text();
    return mesh.error().text();
  }
  TemporaryFolder m_folder;
};

TEST_F(SurfaceFiles, MakesNormalsThatAreMissing) {
  const auto mesh = read(triangles({0, 0, 0, 0, 0, 1, 1, 0, 0}));
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  ASSERT_EQ((*mesh)->vertices.size(), 3u);
  for (const PlantVertex& vertex : (*mesh)->vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 1, 0));
  EXPECT_TRUE((*mesh)->spheres.empty());
}

TEST_F(SurfaceFiles, KeepsNormalsThatAreThereAndMakesThemUnitVectors) {
  GltfBuilder builder = triangles({0, 0, 0, 0, 0, 1, 1, 0, 0});
  builder.attribute("NORMAL", builder.add<float>({3, 0, 0, 0, -2, 0, 0, 0, 0}, 5126, "VEC3", 3));
  const auto mesh = read(builder);
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  EXPECT_EQ((*mesh)->vertices[0].normal, glm::vec3(1, 0, 0));
  EXPECT_EQ((*mesh)->vertices[1].normal, glm::vec3(0, -1, 0));
  EXPECT_NEAR(glm::length((*mesh)->vertices[2].normal), 1.0f, 1e-6f) << "none given: still a direction";
}

TEST_F(SurfaceFiles, TakesTrianglesWithoutAreaAmongOthers) {
  const auto mesh = read(triangles({0, 0, 0, 0, 0, 1, 1, 0, 0,  //
                                    2, 0, 0, 2, 0, 0, 2, 0, 0,  //
                                    0, 0, 0, 1, 1, 1, 2, 2, 2}));
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  EXPECT_EQ((*mesh)->indices.size(), 9u);
  for (const PlantVertex& vertex : (*mesh)->vertices) {
    EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-6f);
    EXPECT_TRUE(glm::length(vertex.position) < 10.0f);
  }
}

TEST_F(SurfaceFiles, RefusesMeshesWithoutAnyArea) {
  EXPECT_NE(refusal(triangles({0, 0, 0, 1, 1, 1, 2, 2, 2})).find("has no area"), std::string::npos);
  EXPECT_NE(refusal(triangles({1, 1, 1, 1, 1, 1, 1, 1, 1})).find("expected 0.1 mm to 1 km"), std::string::npos);
}

TEST_F(SurfaceFiles, RefusesFilesWithoutTriangles) {
  GltfBuilder lines = triangles({0, 0, 0, 1, 0, 0, 0, 1, 0});
  lines.primitiveRest = R"(, "mode": 1)";
  EXPECT_NE(refusal(lines).find("has no triangles"), std::string::npos);
  EXPECT_NE(refusal(triangles({0, 0, 0, 1, 0, 0})).find("has no triangles"), std::string::npos);
  GltfBuilder nothing = standingTriangle();
  nothing.sceneNodes = "";
  EXPECT_NE(refusal(nothing).find("has no triangles"), std::string::npos);
}

TEST_F(SurfaceFiles, RefusesPlacesAndNormalsThatAreNoNumbers) {
  EXPECT_NE(refusal(triangles({0, 0, 0, 0, kNan, 1, 1, 0, 0})).find("vertex (1) that is nowhere"), std::string::npos);
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_NE(refusal(triangles({0, 0, 0, 0, 0, 1, infinite, 0, 0})).find("nowhere"), std::string::npos);
  GltfBuilder builder = triangles({0, 0, 0, 0, 0, 1, 1, 0, 0});
  builder.attribute("NORMAL", builder.add<float>({0, 1, 0, 0, kNan, 0, 0, 1, 0}, 5126, "VEC3", 3));
  EXPECT_NE(refusal(builder).find("NORMAL that holds a value that is not finite"), std::string::npos);
}

TEST_F(SurfaceFiles, RefusesTenMillionTrianglesWithTheLimit) {
  GltfBuilder builder;
  builder.attribute("POSITION", builder.add<float>({0, 0, 0, 1, 0, 0, 0, 2, 0}, 5126, "VEC3", 3));
  std::vector<std::uint8_t> indices(30'000'000);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint8_t>(i % 3);
  builder.add<std::uint8_t>(indices, 5121, "SCALAR", 1);
  builder.primitiveRest = R"(, "indices": 1)";
  EXPECT_NE(refusal(builder).find("has more than 2 million triangles"), std::string::npos);
}

TEST_F(SurfaceFiles, TakesAsManyTrianglesAsThereMayBe) {
  GltfBuilder builder;
  builder.attribute("POSITION", builder.add<float>({0, 0, 0, 1, 0, 0, 0, 2, 0}, 5126, "VEC3", 3));
  std::vector<std::uint8_t> indices(3 * kMaxSurfaceTriangles);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint8_t>(i % 3);
  builder.add<std::uint8_t>(indices, 5121, "SCALAR", 1);
  builder.primitiveRest = R"(, "indices": 1)";
  const auto mesh = read(builder);
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  EXPECT_EQ((*mesh)->indices.size(), indices.size());
}

TEST_F(SurfaceFiles, NeedsNoColoursAndTextures) {
  GltfBuilder builder = standingTriangle();
  builder.materials = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}})";
  builder.textures = R"({"source": 0})";
  builder.images = R"({"uri": "lost.png"})";
  builder.primitiveRest += R"(, "material": 0)";
  const auto mesh = read(builder);
  ASSERT_TRUE(mesh.ok()) << mesh.error().text();
  EXPECT_EQ((*mesh)->textureSize, glm::ivec2(0));
}

}  // namespace
}  // namespace windloom
