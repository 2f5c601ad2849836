#include "engine/io/terrain_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "engine/core/file.hpp"
#include "engine/io/asset_copy.hpp"
#include "engine/io/image.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/terrain_mesh.hpp"
#include "engine/model/edit.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

/// A glTF file with two triangles over 4 x 2 m, 3 m high in one corner.
struct Gltf {
  std::vector<float> positions{0, 0, 0, 4, 0, 0, 4, 3, 2, 0, 0, 2};
  std::vector<std::uint16_t> indices{0, 1, 2, 0, 2, 3};
  std::string node = R"("mesh": 0)";
  std::string buffer = R"("uri": "ground.bin", "byteLength": 60)";
  int viewBytes = 12;

  [[nodiscard]] std::string bin() const {
    std::string bytes(60, '\0');
    std::memcpy(bytes.data(), positions.data(), 48);
    std::memcpy(bytes.data() + 48, indices.data(), 12);
    return bytes;
  }
  [[nodiscard]] std::string json() const {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{)" + node + R"(}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0,0,0], "max": [4,3,2]},
                    {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
      "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": )" +
           std::to_string(viewBytes) + "}],\n\"buffers\": [{" + buffer + "}]}";
  }
  /// The same as one binary file.
  [[nodiscard]] std::string glb() const {
    Gltf inner = *this;
    inner.buffer = R"("byteLength": 60)";
    std::string text = inner.json();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto number = [](std::size_t value) {
      const auto n = static_cast<std::uint32_t>(value);
      return std::string(reinterpret_cast<const char*>(&n), 4);
    };
    return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + 60) + number(text.size()) + "JSON" + text +
           number(60) + std::string("BIN\0", 4) + bin();
  }
};

}  // namespace

class TerrainFiles : public ::testing::Test {
 protected:
  void put(const fs::path& name, const std::string& bytes) const {
    ASSERT_TRUE(makeFolder((m_folder / name).parent_path()));
    ASSERT_TRUE(writeFileAtomically(m_folder / name, bytes));
  }
  fs::path putGltf(const Gltf& gltf, const fs::path& name = "ground.gltf") const {
    put(name, gltf.json());
    put(name.parent_path() / "ground.bin", gltf.bin());
    return m_folder / name;
  }
  fs::path putPicture(const fs::path& name, int width = 3, int height = 2, std::uint16_t last = 65535) const {
    Image16 image(width, height, 1);
    image.pixels.back() = last;
    EXPECT_TRUE(makeFolder((m_folder / name).parent_path()));
    EXPECT_TRUE(writePng(m_folder / name, image));
    return m_folder / name;
  }
  static std::string refusal(const fs::path& file, TerrainKind kind) {
    const auto source = readTerrainFile(file, kind);
    if (source) return "accepted";
    EXPECT_EQ(source.error().kind, ErrorKind::BadInput);
    EXPECT_NE(source.error().text().find(file.filename().string()), std::string::npos) << source.error().text();
    return source.error().text();
  }
  static std::string meshRefusal(const fs::path& file) { return refusal(file, TerrainKind::Mesh); }
  TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
};

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST_F(TerrainFiles, PicturesBecomeHeights) {
  const auto source = readTerrainFile(putPicture("a.png"), TerrainKind::HeightMap);
  ASSERT_TRUE(source.ok()) << source.error().text();
  EXPECT_EQ((*source)->samples, glm::ivec2(3, 2));
  EXPECT_EQ((*source)->values, (std::vector<float>{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ((*source)->highest, 1.0f);
}

TEST_F(TerrainFiles, LargePicturesAreMadeSmallerWithoutMoving) {
  Image16 ramp(4096, 2, 1);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4096; ++x) *ramp.at(x, y) = static_cast<std::uint16_t>(x * 16);
  }
  ASSERT_TRUE(writePng(m_folder / "ramp.png", ramp));
  const auto source = readTerrainFile(m_folder / "ramp.png", TerrainKind::HeightMap);
  ASSERT_TRUE(source.ok());
  ASSERT_EQ((*source)->samples.x, kMaxHeightSamples);
  for (const int i : {0, 5, 1024, 2047}) {
    const float wanted = static_cast<float>(i) / 2047.0f * 4095.0f * 16.0f / 65535.0f;
    EXPECT_NEAR((*source)->values[static_cast<std::size_t>(i)], wanted, 3e-4f) << i;
  }
}

TEST_F(TerrainFiles, RefusesBrokenPictures) {
  const fs::path good = putPicture("good.png", 64, 64);
  const std::string bytes = *readFile(good);
  put("short.png", bytes.substr(0, bytes.size() / 2));
  EXPECT_SAYS(refusal(m_folder / "short.png", TerrainKind::HeightMap), "damaged");
  put("text.png", "hello, I am no picture");
  EXPECT_SAYS(refusal(m_folder / "text.png", TerrainKind::HeightMap), "is not a PNG file");
  EXPECT_NE(refusal(m_folder / "none.png", TerrainKind::HeightMap), "accepted");
  EXPECT_SAYS(refusal(putPicture("line.png", 8, 1), TerrainKind::HeightMap), "fewer than 2 pixels");
  EXPECT_SAYS(refusal(good, TerrainKind::Mesh), "is no mesh");
  EXPECT_SAYS(refusal(putGltf({}), TerrainKind::HeightMap), "is no height map");
}

TEST_F(TerrainFiles, MeshesAreSeenFromAbove) {
  put("ground.glb", Gltf{}.glb());
  for (const fs::path& file : {putGltf({}), m_folder / "ground.glb"}) {
    const auto source = readTerrainFile(file, TerrainKind::Mesh);
    ASSERT_TRUE(source.ok()) << source.error().text();
    EXPECT_EQ((*source)->triangles, 2u);
    EXPECT_EQ((*source)->samples, glm::ivec2(256, 128));
    EXPECT_EQ((*source)->size, glm::vec2(4, 2));
    TerrainSettings terrain;
    terrain.kind = TerrainKind::Mesh;
    terrain.centre = {10, 0};
    terrain.base = 1;
    terrain.scale = 2;
    const auto field = placeHeights(terrain, *source);
    EXPECT_NEAR(heightAt(*field, {18, 4}), 7.0f, 1e-3f);
    EXPECT_NEAR(heightAt(*field, {10, 0}), 1.0f, 1e-3f);
    EXPECT_NEAR(heightAt(*field, {14, 2}), 4.0f, 0.05f) << "half-way up the diagonal";
  }
}

TEST_F(TerrainFiles, NodesPlaceTheirMeshes) {
  Gltf turned;  // a quarter turn about y takes +x to -z; then twice as large, 5 m up
  turned.node =
      R"("mesh": 0, "translation": [0, 5, 0], "rotation": [0, 0.70710678, 0, 0.70710678], "scale": [2, 2, 2])";
  const auto source = readTerrainFile(putGltf(turned), TerrainKind::Mesh);
  ASSERT_TRUE(source.ok()) << source.error().text();
  EXPECT_NEAR((*source)->low.x, 0, 1e-4f);
  EXPECT_NEAR((*source)->low.y, -8, 1e-4f);
  EXPECT_NEAR((*source)->size.x, 4, 1e-4f);
  EXPECT_NEAR((*source)->size.y, 8, 1e-4f);
  EXPECT_NEAR((*source)->highest, 11, 1e-3f);
  EXPECT_NEAR((*source)->lowest, 5, 1e-3f);
}

TEST_F(TerrainFiles, HolesTakeTheirNeighboursHeights) {
  Gltf half;  // only one of the two triangles
  half.indices = {0, 1, 2, 0, 1, 2};
  const auto source = readTerrainFile(putGltf(half), TerrainKind::Mesh);
  ASSERT_TRUE(source.ok());
  for (const float value : (*source)->values) {
    EXPECT_GE(value, 0.0f);
    EXPECT_LE(value, 3.0f);
  }
}

TEST_F(TerrainFiles, RefusesBrokenMeshes) {
  EXPECT_NE(meshRefusal(m_folder / "none.glb"), "accepted");
  put("text.gltf", "hello");
  EXPECT_SAYS(meshRefusal(m_folder / "text.gltf"), "no glTF file");
  const std::string glb = Gltf{}.glb();
  for (const std::size_t length : {std::size_t{6}, std::size_t{30}, glb.size() / 2, glb.size() - 20}) {
    put("short.glb", glb.substr(0, length));
    EXPECT_SAYS(meshRefusal(m_folder / "short.glb"), "no glTF file");
  }
  Gltf missing;
  missing.buffer = R"("uri": "lost.bin", "byteLength": 60)";
  EXPECT_SAYS(meshRefusal(putGltf(missing)), "lost.bin");
  Gltf leaving;
  leaving.buffer = R"("uri": "../ground.bin", "byteLength": 60)";
  put("ground.bin", Gltf{}.bin());
  EXPECT_NE(meshRefusal(putGltf(leaving, "inner/ground.gltf")), "accepted") << "buffers lie beside the file";
  Gltf beyond;
  beyond.indices[4] = 9;
  EXPECT_SAYS(meshRefusal(putGltf(beyond)), "index 9");
  Gltf nowhere;
  nowhere.positions[4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_SAYS(meshRefusal(putGltf(nowhere)), "not finite");
  Gltf cut;
  cut.viewBytes = 8;
  EXPECT_SAYS(meshRefusal(putGltf(cut)), "beyond its buffer");
  Gltf wall;
  wall.positions = {0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 0};
  EXPECT_SAYS(meshRefusal(putGltf(wall)), "covers no ground");
  Gltf ring;
  ring.node = R"("children": [0])";
  EXPECT_SAYS(meshRefusal(putGltf(ring)), "no triangles");
  Gltf empty;
  empty.node = R"("name": "nothing")";
  EXPECT_SAYS(meshRefusal(putGltf(empty)), "no triangles");
}

TEST_F(TerrainFiles, StopsWhenTold) {
  const auto source = readTerrainFile(putGltf({}), TerrainKind::Mesh, [](std::string_view) { return false; });
  ASSERT_FALSE(source.ok());
  EXPECT_EQ(source.error().kind, ErrorKind::Usage);
}

TEST(TerrainMesh, AsksOftenWhetherToStopWhereTrianglesLieOverEachOther) {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 0, 10}};
  for (int triangle = 0; triangle < 2000; ++triangle) mesh.indices.insert(mesh.indices.end(), {0, 1, 2});
  int asked = 0;
  EXPECT_FALSE(heightsOfMesh(mesh, "pile.glb", [&](std::string_view) { return ++asked < 5; }).ok());
  EXPECT_EQ(asked, 5);
}

TEST_F(TerrainFiles, ProjectsReadAndKeepTheirTerrain) {
  putPicture("terrain/hills.png");
  Project project;
  TerrainSettings terrain;
  terrain.kind = TerrainKind::HeightMap;
  terrain.file = "terrain/hills.png";
  terrain.size = {40, 20};
  terrain.height = 7;
  project.terrain = std::make_shared<TerrainSettings>(terrain);
  ASSERT_TRUE(saveProject(project, m_folder / "a.wind.json"));
  const auto loaded = loadProject(m_folder / "a.wind.json");
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  EXPECT_TRUE(loaded->missing.empty());
  ASSERT_TRUE(loaded->project.terrain->heights != nullptr);
  EXPECT_FLOAT_EQ(heightAt(*loaded->project.terrain->heights, {20, 10}), 7.0f);
  EXPECT_EQ(writeProject(loaded->project), *readFile(m_folder / "a.wind.json"));

  fs::remove(m_folder / "terrain/hills.png");
  const auto without = loadProject(m_folder / "a.wind.json");
  ASSERT_TRUE(without.ok()) << "the rest of the project is good";
  ASSERT_EQ(without->missing.size(), 1u);
  EXPECT_EQ(without->missing[0].pointer, "/terrain/file");
  EXPECT_SAYS(without->missing[0].text(), "hills.png");
  EXPECT_EQ(without->project.terrain->heights, nullptr);
  EXPECT_EQ(writeProject(without->project), *readFile(m_folder / "a.wind.json")) << "saving loses nothing";
}

TEST_F(TerrainFiles, FlatGroundIsWrittenAsShortAsEver) {
  EXPECT_SAYS(writeProject(Project{}), "\"terrain\": {\"kind\": \"flat\", \"colour\": [0.17, 0.15, 0.08]}");
}

TEST_F(TerrainFiles, FilesFromElsewhereAreCopiedUnderAFreeName) {
  const fs::path project = m_folder / "project";
  ASSERT_TRUE(makeFolder(project));
  const fs::path one = putPicture("one/hill.png"), two = putPicture("two/hill.png", 3, 2, 99);
  EXPECT_EQ(*bringAsset(one, project), "assets/hill.png");
  EXPECT_EQ(*bringAsset(one, project), "assets/hill.png") << "the same file again";
  EXPECT_EQ(*bringAsset(two, project), "assets/hill-2.png");
  EXPECT_EQ(*readFile(project / "assets/hill.png"), *readFile(one));
  EXPECT_EQ(*readFile(project / "assets/hill-2.png"), *readFile(two));
  EXPECT_EQ(*bringAsset(project / "assets/hill-2.png", project), "assets/hill-2.png") << "inside already";
}

TEST_F(TerrainFiles, MeshesBringWhatTheyReferTo) {
  const fs::path project = m_folder / "project";
  ASSERT_TRUE(makeFolder(project));
  const auto name = bringAsset(putGltf({}, "model/ground.gltf"), project);
  ASSERT_TRUE(name.ok()) << name.error().text();
  EXPECT_EQ(*name, "assets/ground/ground.gltf");
  EXPECT_TRUE(readTerrainFile(project / *name, TerrainKind::Mesh).ok());

  Gltf web;
  web.buffer = R"("uri": "https://example.org/ground.bin", "byteLength": 60)";
  const auto refused = bringAsset(putGltf(web, "web/ground.gltf"), project);
  ASSERT_FALSE(refused.ok());
  EXPECT_SAYS(refused.error().text(), "https://example.org/ground.bin");
  fs::remove(m_folder / "model/ground.bin");
  const auto lost = bringAsset(m_folder / "model/ground.gltf", project);
  ASSERT_FALSE(lost.ok());
  EXPECT_SAYS(lost.error().text(), "ground.bin");
}

TEST_F(TerrainFiles, MeshesBringWhatTheyReferToWhateverTheirEnding) {
  const fs::path project = m_folder / "project";
  ASSERT_TRUE(makeFolder(project));
  fs::rename(putGltf({}, "model/loud.gltf"), m_folder / "model/LOUD.GLTF");
  const auto loud = bringAsset(m_folder / "model/LOUD.GLTF", project);
  ASSERT_TRUE(loud.ok()) << loud.error().text();
  EXPECT_TRUE(readTerrainFile(project / *loud, TerrainKind::Mesh).ok());

  const std::string json = Gltf{}.json();
  std::string binary = "glTF";
  const auto add = [&](std::uint32_t value) { binary.append(reinterpret_cast<const char*>(&value), sizeof value); };
  add(2);
  const std::string padded = json + std::string((4 - json.size() % 4) % 4, ' ');
  add(static_cast<std::uint32_t>(20 + padded.size()));
  add(static_cast<std::uint32_t>(padded.size()));
  binary += "JSON" + padded;
  put("model/outside.glb", binary);
  const auto outside = bringAsset(m_folder / "model/outside.glb", project);
  ASSERT_TRUE(outside.ok()) << outside.error().text();
  EXPECT_TRUE(readTerrainFile(project / *outside, TerrainKind::Mesh).ok()) << "its buffer lies in a file of its own";
}

TEST_F(TerrainFiles, GoAlongButNeverOverAnotherFile) {
  putGltf({}, "a/terrain/ground.gltf");
  ASSERT_TRUE(makeFolder(m_folder / "b"));
  ASSERT_TRUE(copyAssetsAlong({"terrain/ground.gltf"}, m_folder / "a", m_folder / "b"));
  EXPECT_TRUE(readTerrainFile(m_folder / "b/terrain/ground.gltf", TerrainKind::Mesh).ok());
  ASSERT_TRUE(copyAssetsAlong({"terrain/ground.gltf"}, m_folder / "a", m_folder / "b")) << "twice is well";
  put("c/terrain/ground.bin", "something else");
  const Status refused = copyAssetsAlong({"terrain/ground.gltf"}, m_folder / "a", m_folder / "c");
  ASSERT_FALSE(refused.ok());
  EXPECT_SAYS(refused.error().text(), "ground.bin");
  EXPECT_EQ(*readFile(m_folder / "c/terrain/ground.bin"), "something else");
  EXPECT_FALSE(fs::exists(m_folder / "c/terrain/ground.gltf"));
  EXPECT_TRUE(copyAssetsAlong({"lost.png"}, m_folder / "a", m_folder / "b")) << "what is lost already can't go along";
}

}  // namespace windloom
