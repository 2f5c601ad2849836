#include "editor/core/preferences.hpp"

#include <sys/stat.h>

#include <fstream>

#include "editor/core/autosave.hpp"
#include "editor_bench.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

TEST(Preferences, ReadBackWhatWasWritten) {
  TempFolder folder;
  Preferences written;
  written.theme = Theme::Light;
  written.interfaceScale = 1.5f;
  written.keymap = R"({"tool.draw":"K"})";
  written.numbers["layout.leftWidth"] = 240.5;
  written.usedFile("/a/b.wind.json");
  written.firstRunHintSeen = true;
  ASSERT_TRUE(writePreferences(folder / "sub" / "preferences.json", written));
  std::vector<std::string> warnings;
  const Preferences read = readPreferences(folder / "sub" / "preferences.json", &warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(read.theme, Theme::Light);
  EXPECT_FLOAT_EQ(read.interfaceScale, 1.5f);
  EXPECT_EQ(read.keymap, written.keymap);
  EXPECT_DOUBLE_EQ(read.number("layout.leftWidth", 0), 240.5);
  EXPECT_DOUBLE_EQ(read.number("other", 7), 7);
  EXPECT_EQ(read.recentFiles, written.recentFiles);
  EXPECT_TRUE(read.firstRunHintSeen);
}

TEST(Preferences, BrokenFilesGiveDefaultsAndAWarning) {
  TempFolder folder;
  for (const char* text : {"", "nonsense", "[]", "{\"theme\": "}) {
    std::ofstream(folder / "p.json") << text;
    std::vector<std::string> warnings;
    EXPECT_EQ(readPreferences(folder / "p.json", &warnings).theme, Theme::Dark);
    EXPECT_EQ(warnings.size(), 1u) << text;
  }
  std::vector<std::string> warnings;
  readPreferences(folder / "none.json", &warnings);
  EXPECT_TRUE(warnings.empty());
}

TEST(Preferences, WrongValuesAreSkippedTheRestIsTaken) {
  TempFolder folder;
  std::ofstream(folder / "p.json") << R"({"theme": "pink", "interfaceScale": 900, "recentFiles": "x", "keymap": 3,
    "numbers": {"a": 1, "b": "two"}, "firstRunHintSeen": true, "unknown": {}})";
  std::vector<std::string> warnings;
  const Preferences read = readPreferences(folder / "p.json", &warnings);
  EXPECT_EQ(warnings.size(), 5u);
  EXPECT_EQ(read.theme, Theme::Dark);
  EXPECT_FLOAT_EQ(read.interfaceScale, 0.0f);
  EXPECT_DOUBLE_EQ(read.number("a", 0), 1);
  EXPECT_TRUE(read.firstRunHintSeen);
}

TEST(Preferences, RecentFilesAreNewestFirstAndOnce) {
  Preferences preferences;
  for (int i = 0; i < 20; ++i) preferences.usedFile("/f" + std::to_string(i));
  preferences.usedFile("/f15");
  preferences.usedFile("/x/../f15");
  EXPECT_EQ(preferences.recentFiles.size(), kMaxRecent);
  EXPECT_EQ(preferences.recentFiles[0], "/f15");
  EXPECT_EQ(preferences.recentFiles[1], "/f19");
  preferences.forgetFile("/f15");
  EXPECT_EQ(preferences.recentFiles[0], "/f19");
}

namespace {

void addProbes(Document& document, int count) {
  for (int i = 0; i < count; ++i) {
    Probe probe;
    probe.id = nextFreeId(document.committed());
    Edit edit;
    edit.label = "Add probe";
    edit.steps.emplace_back(Put<Probe>{probe});
    ASSERT_TRUE(document.apply(edit));
  }
}

/// Edits one by one, with a frame after each.
void editFrames(Autosave& autosave, Document& document, int count, double now) {
  for (int i = 0; i < count; ++i) {
    addProbes(document, 1);
    ASSERT_TRUE(autosave.tick(document, now));
  }
}

std::size_t probesInSideFile(const std::filesystem::path& file) {
  Document restored;
  const Status status = restoreRescue(restored, {file, {}, {}});
  EXPECT_TRUE(status.ok());
  return restored.project().probes->size();
}

}  // namespace

TEST(Autosave, WritesBeforeTwentyFiveEditsCouldBeLost) {
  TempFolder folder;
  Document document;
  Autosave autosave(folder.path(), "1");
  ASSERT_TRUE(autosave.tick(document, 0));
  editFrames(autosave, document, int(kAutosaveEdits) - 1, 1);
  ASSERT_TRUE(autosave.wait());
  EXPECT_FALSE(std::filesystem::exists(autosave.sideFile()));
  editFrames(autosave, document, 1, 1);
  ASSERT_TRUE(autosave.wait());
  EXPECT_TRUE(std::filesystem::exists(autosave.sideFile()));
}

TEST(Autosave, WritesBeforeTwoMinutesAfterTheFirstEdit) {
  TempFolder folder;
  Document document;
  Autosave autosave(folder.path(), "1");
  ASSERT_TRUE(autosave.tick(document, 0));
  editFrames(autosave, document, 1, 100);
  ASSERT_TRUE(autosave.tick(document, 99 + kAutosaveSeconds));
  ASSERT_TRUE(autosave.wait());
  EXPECT_FALSE(std::filesystem::exists(autosave.sideFile()));
  ASSERT_TRUE(autosave.tick(document, 101 + kAutosaveSeconds));
  ASSERT_TRUE(autosave.wait());
  EXPECT_TRUE(std::filesystem::exists(autosave.sideFile()));
}

TEST(Autosave, SideFileGoesWhenTheProjectIsSavedAndNeverTouchesTheUsersFile) {
  TempFolder folder;
  Document document;
  ASSERT_TRUE(document.saveAs(folder / "mine.wind.json"));
  const auto size = std::filesystem::file_size(folder / "mine.wind.json");
  Autosave autosave(folder / "side", "1");
  ASSERT_TRUE(autosave.tick(document, 0));
  editFrames(autosave, document, 25, 1);
  ASSERT_TRUE(autosave.wait());
  EXPECT_TRUE(std::filesystem::exists(autosave.sideFile()));
  EXPECT_EQ(std::filesystem::file_size(folder / "mine.wind.json"), size);
  ASSERT_TRUE(document.save());
  ASSERT_TRUE(autosave.tick(document, 2));
  EXPECT_FALSE(std::filesystem::exists(autosave.sideFile()));
}

TEST(Autosave, WritesAtOnceWhenToldThatTheEndIsNear) {
  TempFolder folder;
  Document document;
  Autosave autosave(folder.path(), "1");
  ASSERT_TRUE(autosave.tick(document, 0));
  ASSERT_TRUE(autosave.writeNow(document));
  EXPECT_FALSE(std::filesystem::exists(autosave.sideFile())) << "nothing was changed";
  editFrames(autosave, document, int(kAutosaveEdits), 1);  // begins a write
  addProbes(document, 1);
  ASSERT_TRUE(autosave.writeNow(document));
  EXPECT_EQ(probesInSideFile(autosave.sideFile()), kAutosaveEdits + 1);
  addProbes(document, 1);
  std::filesystem::remove(autosave.sideFile());
  ASSERT_TRUE(autosave.tick(document, 2));
  EXPECT_FALSE(std::filesystem::exists(autosave.sideFile())) << "edits are counted from what was written";
}

TEST(Autosave, SaysWhereItCannotWriteAtOnce) {
  Document document;
  Autosave autosave("/proc/no-folder-here", "1");
  addProbes(document, 1);
  const Status status = autosave.writeNow(document);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.error().text().find("/proc/no-folder-here"), std::string::npos) << status.error().text();
}

TEST(Autosave, ARunningEditorsFileIsNoRescueACrashedOnesIs) {
  TempFolder folder;
  Document document;
  ASSERT_TRUE(document.saveAs(folder / "mine.wind.json"));
  {
    Autosave autosave(folder / "side", "1");
    ASSERT_TRUE(autosave.tick(document, 0));
    editFrames(autosave, document, int(kAutosaveEdits), 1);
    ASSERT_TRUE(autosave.wait());
    EXPECT_TRUE(findRescues(folder / "side").empty());
  }  // gone without finish(): a crash
  const auto rescues = findRescues(folder / "side");
  ASSERT_EQ(rescues.size(), 1u);
  EXPECT_EQ(rescues[0].original, folder / "mine.wind.json");
  EXPECT_EQ(describeRescue(rescues[0]), std::vector<std::string>{std::to_string(kAutosaveEdits) + " probes added"});
  Document other;
  ASSERT_TRUE(restoreRescue(other, rescues[0]));
  EXPECT_TRUE(other.dirty());
  EXPECT_EQ(other.path(), folder / "mine.wind.json");
  EXPECT_EQ(writeProject(other.project()), writeProject(document.project()));
  // A later editor with the same name leaves the rescue alone.
  Autosave later(folder / "side", "1");
  EXPECT_NE(later.sideFile(), rescues[0].sideFile);
  discardRescue(rescues[0]);
  EXPECT_TRUE(findRescues(folder / "side").empty());
}

TEST(Autosave, FindsAFileLaterWhereItsFolderCouldNotBeMadeAtFirst) {
  TempFolder folder;
  std::ofstream(folder / "side") << "a file is in the way";
  Autosave autosave(folder / "side", "1");
  Document document;
  ASSERT_TRUE(autosave.tick(document, 0));
  editFrames(autosave, document, int(kAutosaveEdits) - 1, 1);
  EXPECT_TRUE(autosave.sideFile().empty());
  std::filesystem::remove(folder / "side");
  editFrames(autosave, document, int(kAutosaveEdits), 2);
  static_cast<void>(autosave.wait());
  ASSERT_FALSE(autosave.sideFile().empty());
  EXPECT_TRUE(std::filesystem::exists(autosave.sideFile()));
}

TEST(Autosave, ClearsLocksThatKilledEditorsLeftAndNoRescue) {
  TempFolder folder;
  std::filesystem::create_directories(folder / "side");
  for (const char* name : {"7.rescue.json.lock", "8.rescue.json.lock", "8.rescue.json"}) {
    std::ofstream(folder / "side" / name) << "";
  }
  const Autosave autosave(folder / "side", "1");
  EXPECT_FALSE(std::filesystem::exists(folder / "side" / "7.rescue.json.lock"));
  EXPECT_TRUE(std::filesystem::exists(folder / "side" / "8.rescue.json.lock"));
  EXPECT_TRUE(std::filesystem::exists(folder / "side" / "8.rescue.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "side" / "1.rescue.json.lock"));
}

TEST(Autosave, RescuedWorkIsNeverWithoutAFile) {
  TempFolder folder;
  Document document;
  {
    Autosave crashed(folder / "side", "1");
    ASSERT_TRUE(crashed.tick(document, 0));
    editFrames(crashed, document, 25, 1);
  }
  Document restored;
  Autosave autosave(folder / "side", "2");
  ASSERT_TRUE(autosave.tick(restored, 0));
  const auto rescues = findRescues(folder / "side");
  ASSERT_EQ(rescues.size(), 1u);
  ASSERT_TRUE(restoreRescue(restored, rescues[0]));
  EXPECT_TRUE(std::filesystem::exists(rescues[0].sideFile));
  ASSERT_TRUE(autosave.tick(restored, 1));
  ASSERT_TRUE(autosave.wait());
  EXPECT_TRUE(std::filesystem::exists(autosave.sideFile()));
  EXPECT_FALSE(std::filesystem::exists(rescues[0].sideFile));
  EXPECT_TRUE(findRescues(folder / "side").empty());
  ASSERT_TRUE(restored.saveAs(folder / "saved.wind.json"));
  ASSERT_TRUE(autosave.tick(restored, 2));
  EXPECT_FALSE(std::filesystem::exists(autosave.sideFile()));
}

TEST(Autosave, FinishLeavesNothingBehind) {
  TempFolder folder;
  Document document;
  Autosave autosave(folder / "side", "1");
  ASSERT_TRUE(autosave.tick(document, 0));
  editFrames(autosave, document, 25, 1);
  autosave.finish();
  EXPECT_TRUE(std::filesystem::is_empty(folder / "side"));
}

TEST(Autosave, FailureIsToldAndTriedAgain) {
  TempFolder folder;
  std::ofstream(folder / "side") << "a file where the folder should be";
  Document document;
  Autosave autosave(folder / "side", "1");
  ASSERT_TRUE(autosave.tick(document, 0));
  addProbes(document, 1);
  ASSERT_TRUE(autosave.tick(document, 1));
  EXPECT_TRUE(autosave.tick(document, 200));
  EXPECT_FALSE(autosave.tick(document, 201));
  EXPECT_TRUE(autosave.tick(document, 202));
}

TEST(Autosave, BrokenRescueFilesAreNotOffered) {
  TempFolder folder;
  std::ofstream(folder / "a.rescue.json") << "{\"format\": \"windloom-rescue\"";
  std::ofstream(folder / "b.rescue.json") << "{\"format\": \"other\"}";
  EXPECT_TRUE(findRescues(folder.path()).empty());
  EXPECT_TRUE(findRescues(folder / "none").empty());
  Document document;
  const Project before = document.project();
  EXPECT_FALSE(restoreRescue(document, {folder / "a.rescue.json", "", ""}));
  EXPECT_TRUE(document.project().sameAs(before));
}

TEST(ProjectChanges, NameWhatDiffers) {
  Bench b;
  EXPECT_TRUE(describeChanges(b.project(), b.project()).empty());
  const Project empty = b.project();
  const Id arrow = b.draw({-20, 0}, {0, 0});
  EXPECT_EQ(describeChanges(empty, b.project()), (std::vector<std::string>{"2 points added", "1 arrow added"}));
  const Project before = b.project();
  b.key("]");
  EXPECT_EQ(describeChanges(before, b.project()),
            std::vector<std::string>{"Arrow " + std::to_string(arrow) + " changed: radius"});
}

TEST(ProjectChanges, NameCornersCurvesAndOrder) {
  Project before;
  Obstacle stone, wall;
  stone.id = 1;
  wall.id = 2;
  wall.shape = ObstacleShape::Polygon;
  wall.points = {{0, 0}, {4, 0}, {0, 4}};
  before.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{stone, wall});
  Project after = before;
  wall.points[1].x = 5;
  after.obstacles = std::make_shared<std::vector<Obstacle>>(std::vector{wall, stone});
  EXPECT_EQ(describeChanges(before, after),
            (std::vector<std::string>{"Obstacle 2 changed: corners", "Obstacles in another order"}));

  WindGraph graph;
  graph.points.resize(1);
  graph.points[0].id = 3;
  Signal signal;
  signal.root = 3;
  signal.keys = {{0, 1}, {2, 0}};
  graph.signals = {signal};
  before = {};
  before.graph = std::make_shared<WindGraph>(graph);
  graph.signals[0].keys[0].easing = Easing::Smooth;
  after = before;
  after.graph = std::make_shared<WindGraph>(graph);
  EXPECT_EQ(describeChanges(before, after), std::vector<std::string>{"Signal 3 changed: curve"});
}

TEST(Autosave, SideFilesAreForTheirOwnerAlone) {
  namespace fs = std::filesystem;
  TempFolder folder;
  Document document;
  addProbes(document, 1);
  const mode_t before = ::umask(0);
  Autosave autosave(folder / "state" / "autosave", "1");
  const Status written = autosave.writeNow(document);
  ::umask(before);
  ASSERT_TRUE(written);
  EXPECT_EQ(fs::status(folder / "state").permissions(), static_cast<fs::perms>(0700));
  EXPECT_EQ(fs::status(autosave.folder()).permissions(), static_cast<fs::perms>(0700));
  EXPECT_EQ(fs::status(autosave.sideFile()).permissions(), static_cast<fs::perms>(0600));
  EXPECT_EQ(fs::status(autosave.sideFile().string() + ".lock").permissions(), static_cast<fs::perms>(0600));
}

TEST(Autosave, WithoutAFolderTouchesNone) {
  namespace fs = std::filesystem;
  TempFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  {
    Autosave autosave({}, "1");
    Document document;
    ASSERT_TRUE(autosave.tick(document, 0));
    editFrames(autosave, document, int(kAutosaveEdits) + 1, 1);
    const Status now = autosave.writeNow(document);
    ASSERT_FALSE(now);
    EXPECT_NE(now.error().text().find("no home folder"), std::string::npos);
    EXPECT_TRUE(findRescues(autosave.folder()).empty());
  }
  fs::current_path(before);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

}  // namespace windloom::editor
