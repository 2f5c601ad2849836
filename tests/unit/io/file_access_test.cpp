#include "engine/io/file_access.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "engine/io/asset_copy.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/plant_file.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/io/gltf_fixture.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

/// A project's folder, and a library beside it.
class FileAccessTest : public ::testing::Test {
 protected:
  void SetUp() override {
    put("library/tuft.glb", testing::standingTriangle().glb());
    ASSERT_TRUE(makeFolder(m_folder / "project"));
  }
  void put(const std::string& name, const std::string& bytes) const {
    ASSERT_TRUE(makeFolder((m_folder / name).parent_path()).ok());
    ASSERT_TRUE(writeFileAtomically(m_folder / name, bytes).ok());
  }
  fs::path file() const { return m_folder / "project/a.wind.json"; }
  static Project planted(const std::string& name) {
    Species tuft;
    tuft.id = 1;
    tuft.shape = PlantShape::Mesh;
    tuft.file = name;
    Project project;
    project.species = std::make_shared<std::vector<Species>>(1, tuft);
    return project;
  }
  /// True where the plant was read; what was said goes to m_said.
  bool reads(const std::string& name, OutsideFiles outside) {
    Project project = planted(name);
    const Status loaded = loadAssets(project, file(), outside);
    m_said = loaded ? std::string() : loaded.error().text();
    EXPECT_EQ(loaded.ok(), project.species->front().mesh != nullptr) << m_said;
    return loaded.ok();
  }
  /// A .gltf with its triangle in `buffer`.
  void putGltf(const std::string& name, const std::string& buffer) const {
    put(name, R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
      "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0,0,0], "max": [1,1,0]}],
      "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": ")" +
                  buffer + R"(", "byteLength": 36}]})");
  }
  static std::string triangle() {
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    return {reinterpret_cast<const char*>(corners), sizeof corners};
  }

  TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
  std::string m_said;
};

}  // namespace

TEST_F(FileAccessTest, NamesThatLeaveTheFolderAreReadOnlyWhereAllowed) {
  for (const std::string& name : {std::string("../library/tuft.glb"), (m_folder / "library/tuft.glb").string()}) {
    EXPECT_FALSE(reads(name, OutsideFiles::Refuse)) << name;
    EXPECT_NE(m_said.find("/species/0/file: found '" + name), std::string::npos) << m_said;
    EXPECT_TRUE(reads(name, OutsideFiles::Allow)) << m_said;
    EXPECT_TRUE(namesFilesOutside(planted(name), file()));
  }
  EXPECT_FALSE(namesFilesOutside(planted("tuft.glb"), file()));
}

TEST_F(FileAccessTest, LinksAreFollowedToWhereTheyLead) {
  put("project/own/tuft.glb", testing::standingTriangle().glb());
  fs::create_symlink("own/tuft.glb", m_folder / "project/inside.glb");
  EXPECT_TRUE(reads("inside.glb", OutsideFiles::Refuse)) << m_said;
  fs::create_symlink("../library/tuft.glb", m_folder / "project/file.glb");
  fs::create_symlink("../library", m_folder / "project/folder");
  for (const char* name : {"file.glb", "folder/tuft.glb"}) {
    EXPECT_FALSE(reads(name, OutsideFiles::Refuse)) << name;
    EXPECT_NE(m_said.find("a link that leads out"), std::string::npos) << m_said;
    EXPECT_TRUE(reads(name, OutsideFiles::Allow)) << m_said;
  }
}

TEST_F(FileAccessTest, AProjectsFolderMayBeALinkItself) {
  put("project/tuft.glb", testing::standingTriangle().glb());
  fs::create_symlink("project", m_folder / "alias");
  Project project = planted("tuft.glb");
  EXPECT_TRUE(loadAssets(project, m_folder / "alias/a.wind.json").ok());
}

TEST_F(FileAccessTest, AGltfFilesOwnFilesAreHeldToTheSame) {
  put("library/corners.bin", triangle());
  putGltf("project/plant/near.gltf", "corners.bin");
  fs::create_symlink(m_folder / "library/corners.bin", m_folder / "project/plant/corners.bin");
  putGltf("project/plant/far.gltf", "../../library/corners.bin");
  for (const char* name : {"plant/near.gltf", "plant/far.gltf"}) {
    EXPECT_FALSE(reads(name, OutsideFiles::Refuse)) << name;
    EXPECT_NE(m_said.find("lies outside its folder"), std::string::npos) << m_said;
    EXPECT_TRUE(reads(name, OutsideFiles::Allow)) << m_said;
  }
}

TEST_F(FileAccessTest, NoNameIsShortenedAcrossALink) {
  put("library/corners.bin", triangle());
  ASSERT_TRUE(makeFolder(m_folder / "library/inner"));
  put("project/plant/corners.bin", triangle());
  putGltf("project/plant/up.gltf", "link/../corners.bin");
  fs::create_symlink("../../library/inner", m_folder / "project/plant/link");
  EXPECT_FALSE(reads("plant/up.gltf", OutsideFiles::Refuse)) << "it is library/corners.bin";
  EXPECT_NE(m_said.find("'link/../corners.bin'"), std::string::npos) << m_said;
  fs::remove(m_folder / "library/corners.bin");
  EXPECT_FALSE(reads("plant/up.gltf", OutsideFiles::Allow)) << "and not plant/corners.bin";
  put("library/corners.bin", triangle());
  EXPECT_TRUE(reads("plant/up.gltf", OutsideFiles::Allow)) << m_said;
  EXPECT_FALSE(assetCompanions(m_folder / "project/plant/up.gltf").ok());
}

TEST_F(FileAccessTest, WebAddressesAndFileAddressesAreNeverOpened) {
  put("library/corners.bin", triangle());
  const std::string absolute = (m_folder / "library/corners.bin").string();
  for (const std::string& address : {std::string("http://localhost:1/corners.bin"), "file://" + absolute, absolute}) {
    putGltf("project/web.gltf", address);
    EXPECT_FALSE(reads("web.gltf", OutsideFiles::Allow)) << address;
    EXPECT_FALSE(assetCompanions(m_folder / "project/web.gltf").ok()) << address;
  }
}

TEST_F(FileAccessTest, NothingOutsideIsCopiedAlong) {
  put("library/secret.png", "secret");
  put("project/mask.png", "mask");
  fs::create_symlink("../library/secret.png", m_folder / "project/link.png");
  ASSERT_TRUE(makeFolder(m_folder / "deep/er/copy"));
  const std::vector<std::string> files{"../library/secret.png", "link.png", "mask.png"};
  ASSERT_TRUE(copyAssetsAlong(files, m_folder / "project", m_folder / "deep/er/copy").ok());
  EXPECT_TRUE(fs::exists(m_folder / "deep/er/copy/mask.png"));
  EXPECT_FALSE(fs::exists(m_folder / "deep/er/copy/link.png"));
  EXPECT_FALSE(fs::exists(m_folder / "deep/er/library"));
  ASSERT_TRUE(copyAssetsAlong(files, m_folder / "project", m_folder / "deep/er/copy", OutsideFiles::Allow).ok());
  EXPECT_TRUE(fs::exists(m_folder / "deep/er/copy/link.png"));
  EXPECT_FALSE(fs::exists(m_folder / "deep/er/library"));
}

}  // namespace windloom
