#include "engine/io/plant_file.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/core/file.hpp"
#include "engine/io/image.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/io/gltf_fixture.hpp"

namespace windloom {
namespace {

using testing::GltfBuilder;
using testing::standingTriangle;

class PlantFiles : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& bytes, const std::string& name = "plant.glb") {
    const std::filesystem::path path = m_folder.path() / name;
    EXPECT_TRUE(writeFileAtomically(path, bytes).ok());
    return path;
  }
  std::shared_ptr<PlantMesh> read(const GltfBuilder& builder, MeshUse use = MeshUse::Plant) {
    auto mesh = readPlantFile(write(builder.glb()), use);
    EXPECT_TRUE(mesh.ok()) << mesh.error().text();
    return mesh ? *mesh : nullptr;
  }
  std::string refusal(const GltfBuilder& builder, MeshUse use = MeshUse::Plant) {
    const auto mesh = readPlantFile(write(builder.glb()), use);
    EXPECT_FALSE(mesh.ok());
    if (mesh.ok()) return {};
    EXPECT_NE(mesh.error().text().find("plant.glb"), std::string::npos) << "names its file: " << mesh.error().text();
    return mesh.error().text();
  }
  /// A PNG of one colour and alpha.
  std::string picture(int side, std::array<std::uint8_t, 4> colour) {
    Image image(side, side, 4);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = colour[i % 4];
    const std::filesystem::path path = m_folder.path() / "made.png";
    EXPECT_TRUE(writePng(path, image).ok());
    return *readFile(path);
  }
  /// The triangle with coordinates and one texture of the picture.
  GltfBuilder textured(const std::string& bytes, const std::string& alpha = "") {
    GltfBuilder builder = standingTriangle();
    builder.attribute("TEXCOORD_0", builder.add<float>({0, 1, 1, 1, 0, 0}, 5126, "VEC2", 2));
    const int view = builder.addPicture(bytes);
    builder.images = R"({"mimeType": "image/png", "bufferView": )" + std::to_string(view) + "}";
    builder.textures = R"({"source": 0})";
    builder.materials = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}})" + alpha + "}";
    builder.primitiveRest += R"(, "material": 0)";
    return builder;
  }
  TemporaryFolder m_folder;
};

TEST_F(PlantFiles, ReadsATriangleAndMakesItsNormals) {
  const auto mesh = read(standingTriangle());
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->indices.size(), 3u);
  EXPECT_EQ(mesh->high, glm::vec3(1, 2, 0));
  for (const PlantVertex& vertex : mesh->vertices) {
    EXPECT_NEAR(glm::length(vertex.normal - glm::vec3(0, 0, 1)), 0.0f, 1e-6f);
    EXPECT_EQ(vertex.colour, glm::vec4(1.0f));
  }
  EXPECT_EQ(mesh->textureSize, glm::ivec2(0));
}

TEST_F(PlantFiles, PlacesByNodesAndTurnsMirroredTriangles) {
  GltfBuilder builder = standingTriangle();
  builder.nodes = R"({"children": [1], "translation": [0, 1, 0]}, {"mesh": 0, "scale": [-1, 2, 1]})";
  const auto mesh = read(builder);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->low, glm::vec3(-1, 1, 0));
  EXPECT_EQ(mesh->high, glm::vec3(0, 5, 0));
  const auto at = [&](std::size_t i) { return mesh->vertices[mesh->indices[i]].position; };
  EXPECT_GT(glm::cross(at(1) - at(0), at(2) - at(0)).z, 0.0f) << "still counter-clockwise from its front";
}

TEST_F(PlantFiles, ReadsColoursAsBytesTimesTheFactor) {
  GltfBuilder builder = standingTriangle();
  builder.attribute("COLOR_0",
                    builder.add<std::uint8_t>({255, 0, 51, 255, 255, 0, 51, 255, 255, 0, 51, 102}, 5121, "VEC4", 4));
  builder.materials =
      R"({"pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1]}, "alphaMode": "MASK", "alphaCutoff": 0.25})";
  builder.primitiveRest += R"(, "material": 0)";
  const auto mesh = read(builder);
  ASSERT_TRUE(mesh);
  EXPECT_NEAR(mesh->vertices[0].colour.r, 0.5f, 1e-6f);
  EXPECT_NEAR(mesh->vertices[0].colour.b, 0.2f, 1e-6f);
  EXPECT_NEAR(mesh->vertices[2].colour.a, 0.4f, 1e-6f);
  EXPECT_FLOAT_EQ(mesh->alphaCutoff, 0.25f);
}

TEST_F(PlantFiles, ReadsATextureWithItsAlpha) {
  const auto mesh = read(textured(picture(8, {10, 200, 30, 77}), R"(, "alphaMode": "MASK")"));
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->textureSize, glm::ivec2(8, 8));
  EXPECT_EQ(mesh->texture[1], 200);
  EXPECT_EQ(mesh->texture[3], 77);
  EXPECT_EQ(mesh->vertices[1].uv, glm::vec2(1, 1));
}

/// A JPEG of 8 x 8 pixels in about (200, 40, 30).
std::string redJpeg() {
  const std::string hex =
      "ffd8ffe000104a46494600010100000100010000ffdb0043000d090a0b0a080d0b0a0b0e0e0d0f13201513121213271c1e17202e293130"
      "2e292d2c333a4a3e333646372c2d405741464c4e525352323e5a615a50604a51524fffdb0043010e0e0e131113261515264f352d354f4f"
      "4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4f4fffc00011080008"
      "000803012200021101031101ffc4001500010100000000000000000000000000000005ffc4001410010000000000000000000000000000"
      "0000ffc4001501010100000000000000000000000000000506ffc40014110100000000000000000000000000000000ffda000c03010002"
      "110311003f008c00d573ffd9";
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
  return bytes;
}

TEST_F(PlantFiles, ReadsJpegs) {
  const auto mesh = read(textured(redJpeg()));
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->textureSize, glm::ivec2(8, 8));
  EXPECT_NEAR(mesh->texture[0], 200, 6);
  EXPECT_NEAR(mesh->texture[1], 40, 6);
  EXPECT_EQ(mesh->texture[3], 255);
  EXPECT_NE(refusal(textured(redJpeg().substr(0, 60))).find("damaged JPEG"), std::string::npos);
}

TEST_F(PlantFiles, RefusesJpegsOfMoreScansThanAnyProgressiveOneHas) {
  const auto withScans = [this](std::size_t count) {
    std::string bytes = redJpeg();
    const std::string scan("\xff\xda\x00\x08\x01\x01\x00\x00\x00\x10", 10);
    for (std::size_t i = 1; i < count; ++i) bytes.insert(bytes.size() - 2, scan);
    return refusal(textured(bytes));
  };
  EXPECT_NE(withScans(101).find("more than 100 scans"), std::string::npos);
  EXPECT_EQ(withScans(100).find("scans"), std::string::npos);
}

TEST_F(PlantFiles, IgnoresTheAlphaOfAnOpaqueMaterial) {
  const auto mesh = read(textured(picture(8, {10, 200, 30, 77})));
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->texture[3], 255);
}

TEST_F(PlantFiles, PacksSeveralTexturesIntoOne) {
  GltfBuilder builder = standingTriangle();
  builder.attribute("TEXCOORD_0", builder.add<float>({0, 1, 1, 1, 0, 0}, 5126, "VEC2", 2));
  const int red = builder.addPicture(picture(8, {255, 0, 0, 255})),
            blue = builder.addPicture(picture(16, {0, 0, 255, 255}));
  builder.images = R"({"mimeType": "image/png", "bufferView": )" + std::to_string(red) +
                   R"(}, {"mimeType": "image/png", "bufferView": )" + std::to_string(blue) + "}";
  builder.textures = R"({"source": 0}, {"source": 1})";
  builder.materials =
      R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}, {"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}}})";
  const std::string second = R"(}, {"attributes": {)" + builder.attributes + R"(}, "indices": 1, "material": 1)";
  builder.primitiveRest += R"(, "material": 0)" + second;
  const auto mesh = read(builder);
  ASSERT_TRUE(mesh);
  ASSERT_EQ(mesh->indices.size(), 6u);
  const auto colourAt = [&](const PlantVertex& vertex, glm::vec2 inwards) {
    const glm::ivec2 at = glm::ivec2(vertex.uv * glm::vec2(mesh->textureSize) + inwards);
    const std::size_t i = 4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(mesh->textureSize.x) +
                               static_cast<std::size_t>(at.x));
    return glm::ivec3(mesh->texture[i], mesh->texture[i + 1], mesh->texture[i + 2]);
  };
  EXPECT_EQ(colourAt(mesh->vertices[mesh->indices[2]], {1, 1}), glm::ivec3(255, 0, 0));
  EXPECT_EQ(colourAt(mesh->vertices[mesh->indices[5]], {1, 1}), glm::ivec3(0, 0, 255));
  EXPECT_EQ(colourAt(mesh->vertices[mesh->indices[1]], {-1, -1}), glm::ivec3(255, 0, 0));
}

TEST_F(PlantFiles, RefusesWhatIsNoPlant) {
  GltfBuilder none = standingTriangle();
  none.sceneNodes = "";
  EXPECT_NE(refusal(none).find("no triangles"), std::string::npos);
  GltfBuilder lines = standingTriangle();
  lines.primitiveRest += R"(, "mode": 1)";
  EXPECT_NE(refusal(lines).find("no triangles"), std::string::npos);
  GltfBuilder below = standingTriangle();
  below.nodes = R"({"mesh": 0, "translation": [0, -5, 0]})";
  EXPECT_NE(refusal(below).find("root"), std::string::npos);
  EXPECT_FALSE(readPlantFile(write("glTF, but not really"), MeshUse::Plant).ok());
  EXPECT_FALSE(readPlantFile(m_folder.path() / "missing.glb", MeshUse::Plant).ok());
  EXPECT_FALSE(readPlantFile(write("x", "plant.txt"), MeshUse::Plant).ok());
}

TEST_F(PlantFiles, RefusesBrokenNumbers) {
  GltfBuilder nowhere = standingTriangle();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(nowhere.parts[0].bytes.data() + 16, &nan, 4);
  EXPECT_NE(refusal(nowhere).find("vertex"), std::string::npos);
  GltfBuilder beyond = standingTriangle();
  beyond.parts[1].bytes[4] = 9;
  EXPECT_NE(refusal(beyond).find("index 9"), std::string::npos);
  GltfBuilder missing = standingTriangle();
  missing.primitiveRest = R"(, "indices": 7)";
  EXPECT_NE(refusal(missing), "");
  GltfBuilder shortOfBytes = standingTriangle();
  shortOfBytes.parts[0].count = 30;
  EXPECT_NE(refusal(shortOfBytes).find("beyond its buffer"), std::string::npos);
  GltfBuilder normals = standingTriangle();
  normals.attribute("NORMAL", normals.add<float>({0, 0, 1}, 5126, "VEC3", 3));
  EXPECT_NE(refusal(normals).find("NORMAL"), std::string::npos);
}

TEST_F(PlantFiles, RefusesBrokenPictures) {
  std::string cut = picture(64, {1, 2, 3, 255});
  cut.resize(cut.size() / 2);
  EXPECT_NE(refusal(textured(cut)).find("/images/0"), std::string::npos);
  EXPECT_NE(refusal(textured("GIF89a, so no")).find("PNG or JPEG"), std::string::npos);
  GltfBuilder missing = textured(picture(8, {1, 2, 3, 255}));
  missing.images = R"({"uri": "elsewhere.png"})";
  EXPECT_NE(refusal(missing).find("elsewhere.png"), std::string::npos);
  GltfBuilder unplaced = textured(picture(8, {1, 2, 3, 255}));
  unplaced.materials = R"({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 3}}})";
  EXPECT_NE(refusal(unplaced).find("TEXCOORD_3"), std::string::npos);
  std::string huge = picture(8, {1, 2, 3, 255});
  huge[18] = 0x40;  // 16392 pixels wide, says its header
  EXPECT_NE(refusal(textured(huge)).find("8192"), std::string::npos);
}

TEST_F(PlantFiles, RefusesBuffersThatEndTooEarly) {
  GltfBuilder empty;
  EXPECT_NE(refusal(empty).find("no glTF file that can be read"), std::string::npos);

  // After 9 floats, 3 indices and 6 floats, each at a multiple of 4, comes the picture: as many bytes, but from later
  // on.
  std::string late = textured(picture(8, {1, 2, 3, 255})).glb();
  const std::size_t offset = late.find(R"("byteOffset": 68)");
  ASSERT_NE(offset, std::string::npos);
  late.replace(offset, 16, R"("byteOffset": 99)");
  const auto beyond = readPlantFile(write(late), MeshUse::Plant);
  ASSERT_FALSE(beyond.ok());
  EXPECT_NE(beyond.error().text().find("a picture ends beyond its buffer"), std::string::npos) << beyond.error().text();

  std::string cut = standingTriangle().glb();
  cut.resize(cut.size() - 8);
  const auto number = static_cast<std::uint32_t>(cut.size());
  std::memcpy(cut.data() + 8, &number, sizeof number);  // as the header then says
  const auto shorter = readPlantFile(write(cut), MeshUse::Plant);
  ASSERT_FALSE(shorter.ok());
  EXPECT_NE(shorter.error().text().find("second chunk ends beyond the file"), std::string::npos)
      << shorter.error().text();
}

TEST_F(PlantFiles, RefusesMoreTrianglesThanAPlantMayHave) {
  GltfBuilder builder = standingTriangle();
  std::vector<std::uint16_t> many;
  for (std::size_t i = 0; i <= kMaxPlantTriangles; ++i) many.insert(many.end(), {0, 1, 2});
  builder.add(many, 5123, "SCALAR", 1);
  builder.primitiveRest = R"(, "indices": 2)";
  EXPECT_NE(refusal(builder).find("20000 triangles"), std::string::npos);
  EXPECT_TRUE(read(builder, MeshUse::Object)) << "an object may have more";
}

TEST_F(PlantFiles, GivesObjectsSpheres) {
  const auto mesh = read(standingTriangle(), MeshUse::Object);
  ASSERT_TRUE(mesh);
  EXPECT_FALSE(mesh->spheres.empty());
  EXPECT_TRUE(read(standingTriangle())->spheres.empty());
}

TEST_F(PlantFiles, LeavesObjectsTheirColours) {
  GltfBuilder builder = standingTriangle();
  builder.materials = R"({"pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0.75, 1]}})";
  builder.primitiveRest += R"(, "material": 0)";
  const auto mesh = read(builder, MeshUse::Object);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->vertices.front().colour, glm::vec4(0.25f, 0.5f, 0.75f, 1.0f));
}

}  // namespace
}  // namespace windloom
