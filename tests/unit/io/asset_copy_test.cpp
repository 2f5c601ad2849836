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
