#include "engine/io/asset_copy.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

using Names = std::vector<std::string>;

class AssetCopy : public ::testing::Test {
 protected:
  void put(const std::string& name, const std::string& bytes) {
    ASSERT_TRUE(makeFolder((m_folder / name).parent_path()));
    ASSERT_TRUE(writeFileAtomically(m_folder / name, bytes));
  }
  [[nodiscard]] std::string textOf(const std::string& name) const {
    const Result<std::string> text = readFile(m_folder / name);
    return text ? *text : "missing";
  }

  TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
};

}  // namespace

TEST_F(AssetCopy, AProjectsFilesAreNamedOnceInTheOrderOfItsFile) {
  Project project;
  EXPECT_EQ(assetFiles(project), Names{});
  auto terrain = std::make_shared<TerrainSettings>();
  terrain->file = "hills.png";
  auto grass = std::make_shared<GrassSettings>();
  grass->densityMap = "mask.png";
  grass->colourMap = "hills.png";
  Species tuft;
  tuft.file = "tuft.glb";
  Collider stone;
  stone.file = "stone.glb";
  Collider twin = stone;
  Surface hill;
  hill.file = "hill.glb";
  project.surfaces = std::make_shared<std::vector<Surface>>(1, hill);
  project.terrain = terrain;
  project.grass = grass;
  auto shell = std::make_shared<ShellSettings>();
  shell->texture = "blades.png";
  project.shell = shell;
  project.species = std::make_shared<std::vector<Species>>(1, tuft);
  project.colliders = std::make_shared<std::vector<Collider>>(std::vector{stone, twin});
  EXPECT_EQ(assetFiles(project), (Names{"hills.png", "mask.png", "blades.png", "tuft.glb", "stone.glb", "hill.glb"}));
}

TEST_F(AssetCopy, AllOfAProjectsFilesGoAlong) {
  put("a/hills.png", "hills");
  put("a/assets/mask.png", "mask");
  put("a/assets/tuft/tuft.gltf", R"({"buffers": [{"uri": "tuft.bin"}], "images": [{"uri": "leaf%20a.png"}]})");
  put("a/assets/tuft/tuft.bin", "bin");
  put("a/assets/tuft/leaf a.png", "leaf");
  ASSERT_TRUE(makeFolder(m_folder / "b"));
  const Names files{"hills.png", "assets/mask.png", "assets/tuft/tuft.gltf", "assets/lost.glb"};
  const Status copied = copyAssetsAlong(files, m_folder / "a", m_folder / "b");
  ASSERT_TRUE(copied.ok()) << copied.error().text();
  EXPECT_EQ(textOf("b/hills.png"), "hills");
  EXPECT_EQ(textOf("b/assets/mask.png"), "mask");
  EXPECT_EQ(textOf("b/assets/tuft/tuft.bin"), "bin");
  EXPECT_EQ(textOf("b/assets/tuft/leaf a.png"), "leaf");
  EXPECT_EQ(textOf("b/assets/tuft/tuft.gltf"), textOf("a/assets/tuft/tuft.gltf"));
  EXPECT_TRUE(copyAssetsAlong(files, m_folder / "a", m_folder / "b")) << "twice is well";
  EXPECT_TRUE(copyAssetsAlong(files, m_folder / "a", m_folder / "a")) << "and so is the same folder";
}

TEST_F(AssetCopy, NothingIsCopiedWhereOneWouldHideAnother) {
  put("a/hills.png", "hills");
  put("a/mask.png", "mask");
  put("b/mask.png", "another mask");
  const Status refused = copyAssetsAlong({"hills.png", "mask.png"}, m_folder / "a", m_folder / "b");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().kind, ErrorKind::BadInput);
  EXPECT_NE(refused.error().text().find("mask.png"), std::string::npos);
  EXPECT_EQ(textOf("b/hills.png"), "missing");
  EXPECT_EQ(textOf("b/mask.png"), "another mask");
}

TEST_F(AssetCopy, NothingIsCopiedThroughALinkThatLeadsOut) {
  put("elsewhere/m.gltf", R"({"buffers": [{"uri": "sub/evil.desktop"}]})");
  put("elsewhere/sub/evil.desktop", "evil");
  put("elsewhere/mask.png", "mask");
  put("victim/own.txt", "own");
  ASSERT_TRUE(makeFolder(m_folder / "project"));
  const auto refused = [](const auto& result) {
    if (result) return false;
    return result.error().kind == ErrorKind::BadInput &&
           result.error().text().find("leads out of the project's folder") != std::string::npos;
  };
  fs::create_symlink("../victim", m_folder / "project/assets");
  EXPECT_TRUE(refused(bringAsset(m_folder / "elsewhere/m.gltf", m_folder / "project")));
  EXPECT_TRUE(refused(bringAsset(m_folder / "elsewhere/mask.png", m_folder / "project")));
  put("a/hills.png", "hills");
  put("a/assets/mask.png", "mask");
  EXPECT_TRUE(refused(copyAssetsAlong({"hills.png", "assets/mask.png"}, m_folder / "a", m_folder / "project")));
  EXPECT_EQ(textOf("project/hills.png"), "missing") << "all is looked at before anything is copied";

  // A link deeper down, and one that leads nowhere yet.
  fs::remove(m_folder / "project/assets");
  ASSERT_TRUE(makeFolder(m_folder / "project/assets/m"));
  fs::create_symlink("../../../victim", m_folder / "project/assets/m/sub");
  EXPECT_TRUE(refused(bringAsset(m_folder / "elsewhere/m.gltf", m_folder / "project")));
  fs::remove_all(m_folder / "project/assets");
  fs::create_symlink("../nowhere", m_folder / "project/assets");
  EXPECT_FALSE(bringAsset(m_folder / "elsewhere/m.gltf", m_folder / "project").ok());
  EXPECT_FALSE(fs::exists(m_folder / "nowhere"));
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(m_folder / "victim"), {}), 1) << "its own file";

  // Links within the folder are the project's own matter, and the folder may be one itself.
  fs::remove(m_folder / "project/assets");
  ASSERT_TRUE(makeFolder(m_folder / "project/pictures"));
  fs::create_symlink("pictures", m_folder / "project/assets");
  fs::create_symlink("project", m_folder / "alias");
  EXPECT_EQ(*bringAsset(m_folder / "elsewhere/mask.png", m_folder / "alias"), "assets/mask.png");
  EXPECT_EQ(textOf("project/pictures/mask.png"), "mask");
}

TEST_F(AssetCopy, MeshesOfManyKeysAndFilesTakeNoLonger) {
  std::string keys = "0", buffers;
  for (int i = 0; i < 100'000; ++i) keys += ", \"k" + std::to_string(i) + "\": 0";
  put("keys.gltf", R"({"buffers": [{"uri": "a.bin"}], "extras": {"first": )" + keys + "}}");
  // Compared each with all before it, they would take as long as all other tests together.
  EXPECT_EQ(*assetCompanions(m_folder / "keys.gltf"), Names{"a.bin"});

  put("values.gltf", R"({"extras": [)" + std::string(2'000'000, ',') + "]}");
  const auto values = assetCompanions(m_folder / "values.gltf");
  ASSERT_FALSE(values.ok());
  EXPECT_NE(values.error().text().find("more than 1000000 values"), std::string::npos) << values.error().text();

  for (int i = 0; i <= 10'000; ++i) buffers += (i > 0 ? ", " : "") + (R"({"uri": ")" + std::to_string(i)) + "\"}";
  put("files.gltf", R"({"buffers": [)" + buffers + "]}");
  const auto files = assetCompanions(m_folder / "files.gltf");
  ASSERT_FALSE(files.ok());
  EXPECT_NE(files.error().text().find("more than 10000 other files"), std::string::npos) << files.error().text();
}

TEST_F(AssetCopy, PicturesAndMeshesFromElsewhereComeIntoTheProjectsFolder) {
  put("elsewhere/mask.png", "mask");
  put("elsewhere/tuft.glb", R"({"asset": {}})");
  ASSERT_TRUE(makeFolder(m_folder / "project"));
  EXPECT_EQ(*bringAsset(m_folder / "elsewhere/mask.png", m_folder / "project"), "assets/mask.png");
  EXPECT_EQ(*bringAsset(m_folder / "elsewhere/tuft.glb", m_folder / "project"), "assets/tuft.glb");
  EXPECT_EQ(textOf("project/assets/mask.png"), "mask");
  const auto lost = bringAsset(m_folder / "elsewhere/lost.glb", m_folder / "project");
  ASSERT_FALSE(lost.ok());
  EXPECT_NE(lost.error().text().find("lost.glb"), std::string::npos);
}

}  // namespace windloom
