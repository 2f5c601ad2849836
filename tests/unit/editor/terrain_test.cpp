#include <chrono>
#include <thread>

#include "editor_bench.hpp"
#include "engine/core/file.hpp"
#include "engine/io/image.hpp"
#include "engine/io/project_json.hpp"
#include "tests/height_fixture.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

float hills(glm::vec2 p) {
  return 4.0f + 3.0f * std::sin(0.1f * p.x) * std::cos(0.13f * p.y);
}

Project hilly() {
  Project project;
  project.terrain = testing::terrainOf(testing::heightsFrom({101, 101}, {100, 100}, hills));
  return project;
}

void waitForTerrain(Workspace& w) {
  for (int i = 0; i < 2000 && w.terrainLoad.running(); ++i) {
    w.tick(0.001, {});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_FALSE(w.terrainLoad.running());
}

class TerrainInEditor : public ::testing::Test {
 protected:
  void SetUp() override {
    Image16 image(5, 5, 1);
    *image.at(4, 4) = 65535;
    ASSERT_TRUE(makeFolder(m_folder / "elsewhere"));
    ASSERT_TRUE(makeFolder(m_folder / "project"));
    ASSERT_TRUE(writePng(m_folder / "elsewhere/corner.png", image));
    m_bench.w.flow.onFailure = [this](const Error& error) { m_failure = error.text(); };
    ASSERT_TRUE(m_bench.w.document.saveAs(m_folder / "project/a.wind.json"));
  }
  Workspace& w() { return m_bench.w; }
  const TerrainSettings& terrain() { return *w().document.project().terrain; }

  TempFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
  std::string m_failure;
  Bench m_bench;
};

}  // namespace

TEST(GroundOfTheProject, ToolsDrawOnIt) {
  Bench b;
  b.w.document.startNew(hilly());
  b.w.tick(0.01, {});
  b.w.camera = EditorCamera{};
  b.w.camera.pitch = 25.0f;
  b.w.camera.target.y = 4.0f;
  const Id arrow = b.draw({-10, 0}, {12, 9});
  expectNear(b.place(b.arrow(arrow).from), {-10, 0}, 0.02f);
  expectNear(b.place(b.arrow(arrow).to), {12, 9}, 0.02f);
  b.key("Q");
  b.click({1.0f, 4.5f});
  EXPECT_EQ(b.w.selection.active(), arrow) << "the middle of the arrow lies on the hill";
}

TEST(GroundOfTheProject, LockedDragGoesAlongItsAxisWhateverLiesUnderThePointer) {
  Bench b;
  b.w.document.startNew(hilly());
  b.w.tick(0.01, {});
  b.w.camera = EditorCamera{};
  b.w.camera.pitch = 25.0f;
  b.w.camera.target.y = 4.0f;
  const Id arrow = b.draw({-10, 0}, {4, 2});
  const Id tip = b.arrow(arrow).to;
  b.key("Q");
  b.press({4, 2});
  b.move({5, 3});
  b.key("X");
  const glm::vec3 level = b.w.ground.lift({4, 2});
  for (const float way : {-6.0f, 3.0f, 9.0f, 15.0f}) {
    PointerEvent pointer;
    pointer.pixel = *b.w.view().toScreen(level + glm::vec3(way, 0.0f, 0.0f));
    const auto under = b.w.view().toGround(pointer.pixel, b.w.ground);
    ASSERT_TRUE(under && std::abs(under->x - 4.0f - way) > 0.2f) << "hills must lie over or under the axis at " << way;
    b.w.pointerMoved(pointer);
    expectNear(b.place(tip), {4 + way, 2}, 0.02f);
  }
  b.key("Escape");
}

TEST(GroundOfTheProject, FramingShowsTheHilltops) {
  Bench b;
  b.w.document.startNew(hilly());
  b.w.tick(0.01, {});
  b.w.camera = EditorCamera{};
  b.w.frame({});
  const ViewMapping view = b.w.view();
  for (const glm::vec2 corner :
       {glm::vec2(-50, -50), glm::vec2(50, -50), glm::vec2(-50, 50), glm::vec2(50, 50), glm::vec2(16, 0)}) {
    const auto pixel = view.groundToScreen(corner, b.w.ground);
    ASSERT_TRUE(pixel.has_value());
    EXPECT_TRUE(pixel->x >= 0 && pixel->y >= 0 && pixel->x <= 1000 && pixel->y <= 1000) << corner.x << ' ' << corner.y;
  }
}

TEST(GroundOfTheProject, EyeStaysAboveIt) {
  Bench b;
  b.w.document.startNew(hilly());
  b.w.camera = EditorCamera{};
  b.w.camera.target = {16, -20, 0};
  b.w.camera.pitch = 5;
  b.w.tick(0.01, {});
  const glm::vec3 eye = b.w.camera.position();
  EXPECT_GT(eye.y, b.w.ground.at({eye.x, eye.z}));
}

TEST_F(TerrainInEditor, BringsAFileInAsOneStepThatUndoTakesBack) {
  ASSERT_TRUE(w().loadTerrain(m_folder / "elsewhere/corner.png"));
  waitForTerrain(w());
  EXPECT_EQ(m_failure, "");
  EXPECT_EQ(m_bench.steps(), 1u);
  EXPECT_EQ(w().document.undoLabel(), "Undo Set terrain");
  EXPECT_EQ(terrain().file, "assets/corner.png");
  EXPECT_TRUE(fs::exists(m_folder / "project/assets/corner.png"));
  EXPECT_EQ(terrain().size, w().document.project().field->size) << "a first height map covers the field";
  EXPECT_FLOAT_EQ(w().ground.at({50, 50}) - w().ground.over, 10.0f);
  w().undo();
  EXPECT_EQ(terrain().kind, TerrainKind::Flat);
  EXPECT_EQ(w().ground.at({50, 50}), w().ground.over);
  w().redo();
  EXPECT_FLOAT_EQ(w().ground.at({50, 50}) - w().ground.over, 10.0f);
  ASSERT_TRUE(w().document.save());
  const auto again = loadProject(m_folder / "project/a.wind.json");
  ASSERT_TRUE(again.ok() && again->missing.empty());
  EXPECT_TRUE(again->project.terrain->heights != nullptr);
}

TEST_F(TerrainInEditor, LeavesAllAsItWasWhereAFileIsBad) {
  ASSERT_TRUE(writeFileAtomically(m_folder / "elsewhere/bad.glb", "glTF, but not really"));
  ASSERT_TRUE(w().loadTerrain(m_folder / "elsewhere/bad.glb"));
  waitForTerrain(w());
  EXPECT_NE(m_failure.find("bad.glb"), std::string::npos) << m_failure;
  EXPECT_EQ(m_bench.steps(), 0u);
  EXPECT_FALSE(fs::exists(m_folder / "project/assets"));
}

TEST_F(TerrainInEditor, CancellingLeavesNoStep) {
  ASSERT_TRUE(w().loadTerrain(m_folder / "elsewhere/corner.png"));
  w().terrainLoad.cancel();
  EXPECT_FALSE(w().terrainLoad.running());
  for (int i = 0; i < 20; ++i) {
    w().tick(0.001, {});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(m_bench.steps(), 0u);
}

TEST_F(TerrainInEditor, AProjectWithoutAFileHasToBeSavedFirst) {
  w().document.startNew();
  EXPECT_FALSE(w().loadTerrain(m_folder / "elsewhere/corner.png"));
  EXPECT_NE(w().message().text.find("Save the project first"), std::string::npos);
}

TEST_F(TerrainInEditor, GoesAlongIntoAnotherFolder) {
  ASSERT_TRUE(w().loadTerrain(m_folder / "elsewhere/corner.png"));
  waitForTerrain(w());
  ASSERT_TRUE(makeFolder(m_folder / "other"));
  ASSERT_TRUE(w().document.saveAs(m_folder / "other/b.wind.json"));
  const auto again = loadProject(m_folder / "other/b.wind.json");
  ASSERT_TRUE(again.ok());
  EXPECT_TRUE(again->missing.empty());
}

TEST_F(TerrainInEditor, IsNotTakenWhereTheProjectMovedMeanwhile) {
  ASSERT_TRUE(w().loadTerrain(m_folder / "elsewhere/corner.png"));
  ASSERT_TRUE(makeFolder(m_folder / "other"));
  ASSERT_TRUE(w().document.saveAs(m_folder / "other/b.wind.json"));
  waitForTerrain(w());
  EXPECT_EQ(terrain().kind, TerrainKind::Flat) << "its file lies in the folder of before";
  EXPECT_NE(w().message().text.find("choose corner.png again"), std::string::npos) << w().message().text;
}

TEST_F(TerrainInEditor, OpensAProjectWhoseTerrainIsLost) {
  ASSERT_TRUE(w().loadTerrain(m_folder / "elsewhere/corner.png"));
  waitForTerrain(w());
  ASSERT_TRUE(w().document.save());
  const std::string saved = *readFile(m_folder / "project/a.wind.json");
  fs::remove(m_folder / "project/assets/corner.png");
  w().flow.requestOpen(m_folder / "project/a.wind.json");
  EXPECT_NE(m_failure.find("/terrain/file"), std::string::npos) << m_failure;
  EXPECT_EQ(w().document.path(), m_folder / "project/a.wind.json");
  EXPECT_EQ(w().ground.at({50, 50}), w().ground.over);
  ASSERT_TRUE(w().document.save());
  EXPECT_EQ(*readFile(m_folder / "project/a.wind.json"), saved) << "saving loses nothing";
}

}  // namespace windloom::editor
