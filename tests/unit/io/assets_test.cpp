#include "engine/io/assets.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "engine/io/image.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/io/gltf_fixture.hpp"

namespace windloom {
namespace {

class Assets : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(writeFileAtomically(m_folder.path() / "tuft.glb", testing::standingTriangle().glb()).ok());
    Image grey(4, 2, 1);
    for (std::size_t i = 0; i < grey.pixels.size(); ++i) grey.pixels[i] = static_cast<std::uint8_t>(30 * i);
    ASSERT_TRUE(writePng(m_folder.path() / "mask.png", grey).ok());
  }
  std::filesystem::path file() const { return m_folder.path() / "a.wind.json"; }
  static Species meshSpecies(Id id, const std::string& name) {
    Species species;
    species.id = id;
    species.shape = PlantShape::Mesh;
    species.file = name;
    return species;
  }
  static Project with(std::vector<Species> species) {
    Project project;
    project.species = std::make_shared<std::vector<Species>>(std::move(species));
    return project;
  }
  /// A picture one pixel high.
  void putBlades(const char* name, std::vector<std::uint8_t> alphas) const {
    Image image(static_cast<int>(alphas.size()), 1, 4);
    for (std::size_t i = 0; i < alphas.size(); ++i) image.pixels[4 * i + 3] = alphas[i];
    ASSERT_TRUE(writePng(m_folder.path() / name, image).ok());
  }
  static void setPicture(Project& project, const char* name) {
    ShellSettings shell = *project.shell;
    shell.texture = name;
    project.shell = std::make_shared<ShellSettings>(shell);
  }
  TemporaryFolder m_folder;
};

TEST_F(Assets, FillsMeshesAndMapsAndSharesThem) {
  Project project = with({meshSpecies(1, "tuft.glb"), Species{}, meshSpecies(2, "tuft.glb")});
  Collider collider;
  collider.shape = ColliderShape::Mesh;
  collider.file = "tuft.glb";
  project.colliders = std::make_shared<std::vector<Collider>>(std::vector{collider});
  Surface surface;
  surface.shape = SurfaceShape::Mesh;
  surface.file = "tuft.glb";
  Surface lost = surface;
  lost.shape = SurfaceShape::Hare;
  lost.file = "gone.glb";
  project.surfaces = std::make_shared<std::vector<Surface>>(std::vector{surface, lost});
  GrassSettings grass;
  grass.densityMap = grass.colourMap = "mask.png";
  project.grass = std::make_shared<GrassSettings>(grass);
  const Status loaded = loadAssets(project, file());
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  const auto& species = *project.species;
  ASSERT_TRUE(species[0].mesh);
  EXPECT_EQ(species[0].mesh, species[2].mesh);
  EXPECT_FALSE(species[1].mesh);
  EXPECT_EQ(species[0].mesh->file, "tuft.glb");
  ASSERT_TRUE((*project.colliders)[0].mesh);
  EXPECT_FALSE((*project.colliders)[0].mesh->spheres.empty());
  ASSERT_TRUE((*project.surfaces)[0].mesh);
  EXPECT_EQ((*project.surfaces)[0].mesh->file, "tuft.glb");
  EXPECT_TRUE((*project.surfaces)[0].mesh->spheres.empty()) << "nothing bumps into it";
  EXPECT_FALSE((*project.surfaces)[1].mesh) << "built-in shapes need no file";
  ASSERT_TRUE(project.grass->densityPixels);
  EXPECT_EQ(project.grass->densityPixels, project.grass->colourPixels);
  EXPECT_FALSE(project.grass->heightPixels);
  const auto speciesBefore = project.species;
  const auto grassBefore = project.grass;
  const auto surfacesBefore = project.surfaces;
  ASSERT_TRUE(loadAssets(project, file()).ok());
  EXPECT_EQ(project.species, speciesBefore) << "nothing is read again";
  EXPECT_EQ(project.grass, grassBefore);
  EXPECT_EQ(project.surfaces, surfacesBefore);
}

TEST_F(Assets, PacksAsManySpheresAsAColliderAsksFor) {
  Project project = with({});
  Collider usual;
  usual.shape = ColliderShape::Mesh;
  usual.file = "tuft.glb";
  Collider few = usual, fewToo = usual;
  few.spheres = fewToo.spheres = 2;
  project.colliders = std::make_shared<std::vector<Collider>>(std::vector{usual, few, fewToo});
  ASSERT_TRUE(loadAssets(project, file()).ok());
  const std::vector<Collider>& read = *project.colliders;
  ASSERT_TRUE(read[0].mesh && read[1].mesh);
  EXPECT_GT(read[0].mesh->spheres.size(), 2u);
  EXPECT_EQ(read[1].mesh->spheres.size(), 2u);
  EXPECT_EQ(read[1].mesh, read[2].mesh) << "one mesh for all that want the same";
  const auto before = project.colliders;
  ASSERT_TRUE(loadAssets(project, file()).ok());
  EXPECT_EQ(project.colliders, before) << "nothing is packed again";
}

TEST_F(Assets, ReportsEachFailureAtItsPlaceAndFillsTheRest) {
  Project project = with({meshSpecies(1, "gone.glb"), meshSpecies(2, "tuft.glb"), meshSpecies(3, "mask.png")});
  Surface surface;
  surface.shape = SurfaceShape::Mesh;
  surface.file = "gone.glb";
  project.surfaces = std::make_shared<std::vector<Surface>>(1, surface);
  GrassSettings grass;
  grass.heightMap = "gone.png";
  grass.densityMap = "mask.png";
  project.grass = std::make_shared<GrassSettings>(grass);
  const Status loaded = loadAssets(project, file());
  ASSERT_FALSE(loaded.ok());
  const std::vector<Problem>& problems = loaded.error().problems;
  ASSERT_EQ(problems.size(), 4u);
  EXPECT_EQ(problems[0].pointer, "/species/0/file");
  EXPECT_NE(problems[0].message.find("gone.glb"), std::string::npos);
  EXPECT_EQ(problems[1].pointer, "/species/2/file");
  EXPECT_EQ(problems[2].pointer, "/surfaces/0/file");
  EXPECT_EQ(problems[3].pointer, "/grass/maps/height");
  EXPECT_FALSE((*project.species)[0].mesh);
  EXPECT_TRUE((*project.species)[1].mesh);
  EXPECT_TRUE(project.grass->densityPixels);
}

TEST_F(Assets, KeepsTheLastGoodMeshWhereTheNewFileIsBroken) {
  Project project = with({meshSpecies(1, "tuft.glb")});
  ASSERT_TRUE(loadAssets(project, file()).ok());
  const auto mesh = (*project.species)[0].mesh;
  std::vector<Species> species = *project.species;
  species[0].file = "gone.glb";
  project.species = std::make_shared<std::vector<Species>>(species);
  EXPECT_FALSE(loadAssets(project, file()).ok());
  EXPECT_EQ((*project.species)[0].mesh, mesh);
}

TEST_F(Assets, FillsThePictureOfShellGrassAndKeepsItWhereTheNewOneIsBad) {
  putBlades("blades.png", {0, 200});
  Project project = with({});
  setPicture(project, "blades.png");
  const Status loaded = loadAssets(project, file());
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  const auto pixels = project.shell->pixels;
  ASSERT_TRUE(pixels);
  EXPECT_EQ(pixels->file, "blades.png");
  EXPECT_EQ(pixels->size, glm::ivec2(2, 1));
  EXPECT_EQ(pixels->pixels[7], 200);
  const auto before = project.shell;
  ASSERT_TRUE(loadAssets(project, file()).ok());
  EXPECT_EQ(project.shell, before) << "nothing is read again";
  setPicture(project, "gone.png");
  EXPECT_FALSE(loadAssets(project, file()).ok());
  EXPECT_EQ(project.shell->pixels, pixels);
  setPicture(project, "");
  EXPECT_TRUE(loadAssets(project, file()).ok());
  EXPECT_FALSE(project.shell->pixels);
}

TEST_F(Assets, SaysWhatIsWrongWithAPictureOfShellGrass) {
  putBlades("solid.png", {255, 255});
  putBlades("empty.png", {0, 0});
  ASSERT_TRUE(writeFileAtomically(m_folder.path() / "bad.png", "no picture").ok());
  const auto problem = [&](const char* name) {
    Project project = with({});
    setPicture(project, name);
    // As a map of the field it would do.
    GrassSettings grass;
    grass.densityMap = std::string(name) == "mask.png" ? name : "";
    project.grass = std::make_shared<GrassSettings>(grass);
    const Status loaded = loadAssets(project, file());
    EXPECT_FALSE(loaded.ok()) << name;
    EXPECT_FALSE(project.shell->pixels) << name;
    return loaded.ok() ? Problem{} : loaded.error().problems.front();
  };
  for (const char* name : {"gone.png", "bad.png", "solid.png", "empty.png", "mask.png"}) {
    EXPECT_EQ(problem(name).pointer, "/shell/texture/file") << name;
    EXPECT_NE(problem(name).message.find(name), std::string::npos) << problem(name).message;
  }
  EXPECT_NE(problem("solid.png").message.find("has no transparency"), std::string::npos);
  EXPECT_NE(problem("mask.png").message.find("has no transparency"), std::string::npos) << "it has no alpha at all";
  EXPECT_NE(problem("empty.png").message.find("holds no blade"), std::string::npos);
}

TEST_F(Assets, AveragesLargeMapsDown) {
  const int side = kMaxGrassMap + 500;
  Image16 image(side, 3, 1);
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < 3; ++y) *image.at(x, y) = x % 2 == 0 ? 0 : 65535;
  }
  ASSERT_TRUE(writePng(m_folder.path() / "large.png", image).ok());
  const auto map = readGrassMap(m_folder.path() / "large.png");
  ASSERT_TRUE(map.ok()) << map.error().text();
  EXPECT_EQ((*map)->size, glm::ivec2(side / 2, 2));
  EXPECT_EQ((*map)->pixels[0], 128);
  EXPECT_EQ((*map)->pixels[3], 255);
}

TEST_F(Assets, KeepsTheOrderOfPixels) {
  const auto map = readGrassMap(m_folder.path() / "mask.png");
  ASSERT_TRUE(map.ok());
  EXPECT_EQ((*map)->size, glm::ivec2(4, 2));
  EXPECT_EQ((*map)->pixels[4 * 3], 90) << "along x first";
  EXPECT_EQ((*map)->pixels[4 * 4], 120) << "then along z";
}

}  // namespace
}  // namespace windloom
