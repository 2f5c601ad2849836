// Species, and the files of species, colliders and maps, in the editor.
#include <chrono>
#include <fstream>
#include <thread>

#include "editor/core/inspector.hpp"
#include "editor/core/project_changes.hpp"
#include "editor_bench.hpp"
#include "engine/core/file.hpp"
#include "engine/io/image.hpp"
#include "engine/io/project_json.hpp"
#include "tests/unit/editor/mesh_file.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

Id add(Bench& b, const char* action) {
  EXPECT_TRUE(b.w.actions.run(action)) << action;
  return b.w.selection.active();
}

const InspectorRow& row(const InspectorSection& section, std::string_view key) {
  for (const InspectorRow& one : section.rows)
    if (one.info.key == key) return one;
  throw std::runtime_error("no row " + std::string(key));
}

class AssetsInEditor : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(makeFolder(m_folder / "elsewhere"));
    ASSERT_TRUE(makeFolder(m_folder / "project"));
    ASSERT_TRUE(writeFileAtomically(m_folder / "elsewhere/tuft.glb", testing::meshFile(0.6f)));
    Image16 image(4, 4, 1);
    *image.at(1, 1) = 65535;
    ASSERT_TRUE(writePng(m_folder / "elsewhere/mask.png", image));
    Image16 blades(4, 4, 4);
    blades.at(1, 1)[3] = 65535;
    ASSERT_TRUE(writePng(m_folder / "elsewhere/blades.png", blades));
    m_bench.w.flow.onFailure = [this](const Error& error) { m_failure = error.text(); };
    ASSERT_TRUE(m_bench.w.document.saveAs(m_folder / "project/a.wind.json"));
  }
  void load(AssetTarget target, const char* file) {
    ASSERT_TRUE(w().loadAsset(std::move(target), m_folder / file));
    for (int i = 0; i < 5000 && w().assetLoad.running(); ++i) {
      w().tick(0.001, {});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ASSERT_FALSE(w().assetLoad.running());
  }
  Workspace& w() { return m_bench.w; }
  const Project& project() { return w().document.project(); }

  TempFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
  std::string m_failure;
  Bench m_bench;
};

}  // namespace

TEST(SpeciesInEditor, EachActionAddsItsShape) {
  Bench b;
  const std::pair<const char*, PlantShape> expected[] = {{"add.tall_grass", PlantShape::Blade},
                                                         {"add.daisies", PlantShape::Daisy},
                                                         {"add.poppies", PlantShape::Poppy},
                                                         {"add.spikes", PlantShape::Spike}};
  for (const auto& [action, shape] : expected) {
    const Species* added = findSpecies(b.project(), add(b, action));
    ASSERT_NE(added, nullptr) << action;
    EXPECT_EQ(added->shape, shape);
    EXPECT_FALSE(added->name.empty());
  }
  EXPECT_EQ(b.steps(), 4u);
}

TEST(SpeciesInEditor, AreRenamedHiddenReorderedCopiedAndDeleted) {
  Bench b;
  const Id daisies = add(b, "add.daisies"), poppies = add(b, "add.poppies");
  b.w.apply(renameEdit(b.project(), daisies, "ox-eyes"));
  EXPECT_EQ(nameOf(b.project(), daisies), "ox-eyes");
  EXPECT_EQ(describeIds(b.project(), std::vector<Id>{daisies, poppies}), "2 species");
  b.w.apply(reorderEdit(b.project(), std::vector<Id>{poppies}, daisies));
  EXPECT_EQ(b.project().species->front().id, poppies);
  b.w.selection.replace(daisies);
  b.key("H");
  EXPECT_TRUE(findSpecies(b.project(), daisies)->hidden);
  b.key("Alt+H");
  EXPECT_FALSE(findSpecies(b.project(), daisies)->hidden);
  b.w.selection.replace(daisies);
  b.key("Ctrl+D");
  ASSERT_EQ(b.project().species->size(), 3u);
  EXPECT_EQ(b.project().species->back().name, "ox-eyes");
  b.key("Ctrl+C");
  b.key("Del");
  EXPECT_EQ(b.project().species->size(), 2u);
  b.key("Ctrl+V");
  EXPECT_EQ(b.project().species->size(), 3u);
}

TEST(SpeciesInEditor, IsolatingAThingLeavesThePlantsInTheMeadow) {
  Bench b;
  const Id daisies = add(b, "add.daisies");
  const Id arrow = b.draw({-10, 0}, {10, 0});
  b.key("Q");
  b.key("C");
  b.w.selection.replace(arrow);
  b.key("Numpad /");
  EXPECT_FALSE(findSpecies(b.project(), daisies)->hidden);
  EXPECT_TRUE(b.project().colliders->front().hidden);
}

TEST(SpeciesInEditor, ShowWhatMattersForTheirShape) {
  Bench b;
  const Id id = add(b, "add.daisies");
  const InspectorTarget target{InspectorKind::Species, {id}};
  InspectorSection section = inspectSelection(b.project(), std::vector<Id>{id}).front();
  EXPECT_EQ(section.target.kind, InspectorKind::Species);
  EXPECT_FALSE(row(section, "file").relevant);
  EXPECT_TRUE(row(section, "width").relevant);
  EXPECT_TRUE(row(section, "patchSize").relevant);
  b.w.apply(setParameter(b.project(), target, "patchiness", 0.0f));
  EXPECT_FALSE(row(inspect(b.project(), target), "patchSize").relevant);
  b.w.apply(setParameter(b.project(), target, "shape", static_cast<int>(PlantShape::Mesh)));
  EXPECT_EQ(findSpecies(b.project(), id)->shape, PlantShape::Daisy) << "a mesh needs its file";
  EXPECT_NE(b.w.message().text.find("The species' file is missing"), std::string::npos) << b.w.message().text;
  b.key("C");
  const InspectorTarget ball{InspectorKind::Collider, {b.w.selection.active()}};
  section = inspect(b.project(), ball);
  for (const char* key : {"file", "scale", "length", "rotation", "loop", "roll"})
    EXPECT_FALSE(row(section, key).relevant) << key;
  EXPECT_TRUE(row(section, "radius").relevant);
  b.w.apply(setParameter(b.project(), ball, "shape", static_cast<int>(ColliderShape::Capsule)));
  section = inspect(b.project(), ball);
  for (const char* key : {"length", "rotation", "radius"}) EXPECT_TRUE(row(section, key).relevant) << key;
}

TEST(SpeciesInEditor, SwingMattersWhereBladesSwing) {
  Project project;
  GrassSettings grass;
  grass.interacting = 0;
  const auto relevant = [&](std::string_view key) {
    project.grass = std::make_shared<GrassSettings>(grass);
    return row(inspect(project, {InspectorKind::Grass, {}}), key).relevant;
  };
  EXPECT_FALSE(relevant("swing/rate"));
  EXPECT_FALSE(relevant("swing/exponent"));
  grass.interacting = 1000;
  EXPECT_TRUE(relevant("swing/rate"));
  EXPECT_FALSE(relevant("swing/exponent"));
  grass.deformation = Deformation::Inertial;
  EXPECT_TRUE(relevant("swing/exponent"));
  grass.kind = GrassKind::None;
  EXPECT_FALSE(relevant("swing/rate"));
}

TEST(SpeciesInEditor, ChangesAreTold) {
  Project before, after;
  Species daisies;
  daisies.id = 1;
  Collider ball;
  ball.id = 2;
  before.colliders = std::make_shared<std::vector<Collider>>(1, ball);
  ball.keys = {{0, {1, 0, 0}}};
  after.colliders = std::make_shared<std::vector<Collider>>(1, ball);
  daisies.name = "daisies";
  auto two = std::vector{daisies, daisies};
  two[1].id = 3;
  after.species = std::make_shared<std::vector<Species>>(two);
  EXPECT_EQ(describeChanges(before, after), (std::vector<std::string>{"2 species added", "Collider 2 changed: way"}));
}

TEST_F(AssetsInEditor, APlantFromElsewhereBecomesANewSpeciesInOneStep) {
  load({.use = AssetUse::Species}, "elsewhere/tuft.glb");
  ASSERT_EQ(project().species->size(), 1u) << m_failure;
  const Species& tuft = project().species->front();
  EXPECT_EQ(tuft.shape, PlantShape::Mesh);
  EXPECT_EQ(tuft.file, "assets/tuft.glb");
  EXPECT_EQ(tuft.name, "tuft");
  EXPECT_NEAR(tuft.height, 0.6f, 1e-4f);
  ASSERT_NE(tuft.mesh, nullptr);
  EXPECT_EQ(w().selection.active(), tuft.id);
  EXPECT_TRUE(fs::exists(m_folder / "project/assets/tuft.glb"));
  EXPECT_EQ(m_bench.steps(), 1u);
  m_bench.key("Ctrl+Z");
  EXPECT_TRUE(project().species->empty());
  m_bench.key("Ctrl+Shift+Z");
  EXPECT_NE(project().species->front().mesh, nullptr) << "redo needs no file";
  m_bench.key("Ctrl+D");
  EXPECT_EQ(project().species->back().mesh, project().species->front().mesh) << "copies share the mesh";
  ASSERT_TRUE(w().document.saveAs(m_folder / "moved/b.wind.json")) << "the folder is made by the save";
  EXPECT_TRUE(fs::exists(m_folder / "moved/assets/tuft.glb")) << "files go along";
  const auto loaded = loadProject(m_folder / "moved/b.wind.json");
  ASSERT_TRUE(loaded.ok());
  EXPECT_TRUE(loaded->missing.empty());
}

TEST_F(AssetsInEditor, AnObjectBecomesTheShapeOfTheSelectedCollider) {
  m_bench.key("C");
  const Id ball = w().selection.active();
  load({.use = AssetUse::Collider, .ids = {ball}}, "elsewhere/tuft.glb");
  const Collider& stone = *findCollider(project(), ball);
  EXPECT_EQ(stone.shape, ColliderShape::Mesh);
  EXPECT_EQ(stone.file, "assets/tuft.glb");
  ASSERT_NE(stone.mesh, nullptr) << m_failure;
  EXPECT_EQ(m_bench.steps(), 2u);
  load({.use = AssetUse::Collider, .place = {3, 4}}, "elsewhere/tuft.glb");
  ASSERT_EQ(project().colliders->size(), 2u);
  EXPECT_EQ(project().colliders->back().position, glm::vec2(3, 4));
}

TEST_F(AssetsInEditor, AFileBecomesASurfaceOrItsShape) {
  load({.use = AssetUse::Surface, .place = {3, 4}}, "elsewhere/tuft.glb");
  ASSERT_EQ(project().surfaces->size(), 1u) << m_failure;
  const Surface hill = project().surfaces->front();
  EXPECT_EQ(hill.shape, SurfaceShape::Mesh);
  EXPECT_EQ(hill.file, "assets/tuft.glb");
  EXPECT_EQ(hill.name, "tuft");
  EXPECT_EQ(hill.position, glm::vec2(3, 4));
  ASSERT_NE(hill.mesh, nullptr);
  EXPECT_TRUE(hill.mesh->spheres.empty());
  EXPECT_EQ(w().selection.active(), hill.id);
  EXPECT_TRUE(w().actions.run("add.sphere"));
  const AssetTarget ball{.use = AssetUse::Surface, .ids = {w().selection.active()}};
  EXPECT_EQ(assetFileOf(project(), ball), "");
  load(ball, "elsewhere/tuft.glb");
  EXPECT_EQ(findSurface(project(), ball.ids[0])->shape, SurfaceShape::Mesh);
  EXPECT_EQ(assetFileOf(project(), ball), "assets/tuft.glb");
  EXPECT_TRUE(isAssetRead(project(), ball));
  EXPECT_EQ(m_bench.steps(), 3u);
}

TEST_F(AssetsInEditor, AMapIsSetAndCleared) {
  load({.use = AssetUse::DensityMap}, "elsewhere/mask.png");
  EXPECT_EQ(project().grass->densityMap, "assets/mask.png") << m_failure;
  ASSERT_NE(project().grass->densityPixels, nullptr);
  EXPECT_EQ(project().grass->densityPixels->size, glm::ivec2(4, 4));
  EXPECT_EQ(project().grass->heightPixels, nullptr);
  w().apply(clearPictureEdit(project(), AssetUse::DensityMap));
  EXPECT_EQ(project().grass->densityMap, "");
  EXPECT_EQ(project().grass->densityPixels, nullptr);
  EXPECT_TRUE(clearPictureEdit(project(), AssetUse::DensityMap).steps.empty());
  m_bench.key("Ctrl+Z");
  EXPECT_NE(project().grass->densityPixels, nullptr);
}

TEST_F(AssetsInEditor, ThePictureOfShellGrassIsSetAndCleared) {
  const AssetTarget target{.use = AssetUse::ShellPicture};
  EXPECT_EQ(assetFileOf(project(), target), "");
  EXPECT_TRUE(isAssetRead(project(), target));
  load(target, "elsewhere/blades.png");
  EXPECT_EQ(assetFileOf(project(), target), "assets/blades.png") << m_failure;
  ASSERT_NE(project().shell->pixels, nullptr);
  EXPECT_EQ(project().shell->pixels->size, glm::ivec2(4, 4));
  EXPECT_TRUE(project().grass->densityMap.empty());
  EXPECT_EQ(m_bench.steps(), 1u);
  load(target, "elsewhere/mask.png");
  EXPECT_NE(m_failure.find("mask.png: has no transparency"), std::string::npos) << m_failure;
  EXPECT_EQ(assetFileOf(project(), target), "assets/blades.png") << "it stays";
  ShellSettings lost = *project().shell;
  lost.texture = "assets/lost.png";
  w().apply(Edit{"Rename", {Set<ShellSettings>{lost}}, {}});
  EXPECT_FALSE(isAssetRead(project(), target));
  m_bench.key("Ctrl+Z");
  w().apply(clearPictureEdit(project(), AssetUse::ShellPicture));
  EXPECT_EQ(assetFileOf(project(), target), "");
  EXPECT_EQ(project().shell->pixels, nullptr);
  EXPECT_TRUE(clearPictureEdit(project(), AssetUse::ShellPicture).steps.empty());
  m_bench.key("Ctrl+Z");
  EXPECT_NE(project().shell->pixels, nullptr);
}

TEST_F(AssetsInEditor, BrokenFilesAreToldAndNothingIsCopied) {
  ASSERT_TRUE(writeFileAtomically(m_folder / "elsewhere/bad.glb", "no mesh"));
  ASSERT_TRUE(writeFileAtomically(m_folder / "elsewhere/bad.png", "no picture"));
  for (const auto& [use, file] : {std::pair{AssetUse::Species, "elsewhere/bad.glb"},
                                  {AssetUse::Collider, "elsewhere/lost.glb"},
                                  {AssetUse::Surface, "elsewhere/bad.glb"},
                                  {AssetUse::ColourMap, "elsewhere/bad.png"},
                                  {AssetUse::ShellPicture, "elsewhere/lost.png"},
                                  {AssetUse::ShellPicture, "elsewhere/mask.png"}}) {
    m_failure.clear();
    load({.use = use}, file);
    EXPECT_NE(m_failure.find(fs::path(file).filename().string()), std::string::npos) << m_failure;
  }
  EXPECT_EQ(m_bench.steps(), 0u);
  EXPECT_FALSE(fs::exists(m_folder / "project/assets"));
}

TEST_F(AssetsInEditor, WhatAFileWasForMayBeGone) {
  m_bench.key("C");
  const Id ball = w().selection.active();
  m_bench.key("Del");
  load({.use = AssetUse::Collider, .ids = {ball}}, "elsewhere/tuft.glb");
  EXPECT_EQ(m_bench.steps(), 2u);
  EXPECT_NE(w().message().text.find("gone"), std::string::npos) << w().message().text;
}

TEST_F(AssetsInEditor, AProjectWithoutAFileIsSavedFirst) {
  w().document.startNew();
  EXPECT_FALSE(w().loadAsset({.use = AssetUse::Species}, m_folder / "elsewhere/tuft.glb"));
  EXPECT_NE(w().message().text.find("Save the project first"), std::string::npos);
}

TEST_F(AssetsInEditor, PastedPlantsAreReadFromTheProjectsFolder) {
  load({.use = AssetUse::Species}, "elsewhere/tuft.glb");
  m_bench.key("Ctrl+C");
  m_bench.key("Ctrl+V");
  ASSERT_EQ(project().species->size(), 2u);
  EXPECT_NE(project().species->back().mesh, nullptr);
}

TEST_F(AssetsInEditor, FilesOfWhatIsPastedIntoAnotherProjectComeAlong) {
  load({.use = AssetUse::Species}, "elsewhere/tuft.glb");
  const std::string file = project().species->back().file;
  m_bench.key("Ctrl+C");
  // The other project has a different file of that name.
  const fs::path other = m_folder / "other";
  fs::create_directories((other / file).parent_path());
  std::ofstream(other / file) << "something else";
  w().document.startNew();
  ASSERT_TRUE(w().document.saveAs(other / "other.wind.json").ok());
  m_bench.key("Ctrl+V");
  ASSERT_FALSE(project().species->empty());
  const Species& pasted = project().species->back();
  EXPECT_NE(pasted.mesh, nullptr) << w().message().text;
  EXPECT_NE(pasted.file, file);
  EXPECT_TRUE(fs::exists(other / pasted.file));
}

TEST_F(AssetsInEditor, PastingWithoutItsFileSaysSo) {
  load({.use = AssetUse::Species}, "elsewhere/tuft.glb");
  const std::string file = project().species->back().file;
  m_bench.key("Ctrl+C");
  fs::remove(m_folder / "project" / file);
  m_bench.key("Ctrl+V");
  ASSERT_EQ(project().species->size(), 2u);
  EXPECT_EQ(project().species->back().mesh, nullptr);
  EXPECT_NE(w().message().text.find("Pasted without a file"), std::string::npos) << w().message().text;
}

}  // namespace windloom::editor
