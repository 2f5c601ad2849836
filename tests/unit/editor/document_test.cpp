#include "editor/core/document.hpp"

#include <fstream>

#include "editor/core/object_edits.hpp"
#include "editor_bench.hpp"
#include "engine/core/file.hpp"
#include "engine/io/project_json.hpp"

namespace windloom::editor {
namespace {

Edit renamed(const std::string& name) {
  Edit edit;
  edit.label = "Rename project";
  edit.steps.emplace_back(SetName{name});
  return edit;
}

void writeText(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

}  // namespace

TEST(Document, ApplyMakesOneStepAndUndoTakesItBack) {
  Document document;
  const Project before = document.project();
  ASSERT_TRUE(document.apply(treeEdit(before, {0, 0}, {5, 0}, Arrow{}).edit));
  EXPECT_EQ(document.undoLabel(), "Undo Draw tree");
  EXPECT_TRUE(document.undo());
  EXPECT_TRUE(document.project().sameAs(before));
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.redoLabel(), "Redo Draw tree");
}

TEST(Document, RefusedEditChangesNothing) {
  Document document;
  const Project before = document.project();
  const Status status = document.apply(treeEdit(before, {1, 1}, {1, 1}, Arrow{}).edit);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::BadInput);
  EXPECT_TRUE(document.project().sameAs(before));
  EXPECT_FALSE(document.history().canUndo());
}

TEST(Document, EmptyEditLeavesNoStep) {
  Document document;
  EXPECT_TRUE(document.apply(Edit{}));
  EXPECT_TRUE(document.apply(renamed(document.project().name)));
  EXPECT_FALSE(document.history().canUndo());
}

TEST(Document, PreviewsAreRelativeToTheCommittedProject) {
  Document document;
  ASSERT_TRUE(document.apply(treeEdit(document.project(), {0, 0}, {5, 0}, Arrow{}).edit));
  const Project before = document.committed();
  const std::vector<Id> tip{before.graph->arrows[0].to};
  for (const float x : {1.0f, 2.0f, 3.0f}) ASSERT_TRUE(document.preview(moveEdit(before, tip, {x, 0})));
  expectNear(document.project().graph->points[1].position, {8, 0});
  EXPECT_TRUE(document.committed().sameAs(before));
  // A preview that is not legal keeps the last good one on show.
  EXPECT_FALSE(document.preview(moveEdit(before, tip, {-5, 0})));
  expectNear(document.project().graph->points[1].position, {8, 0});
  EXPECT_TRUE(document.endPreview());
  EXPECT_TRUE(document.project().sameAs(before));
}

TEST(Document, SaveAndOpenGiveTheSameProject) {
  TempFolder folder;
  Document document;
  ASSERT_TRUE(document.apply(treeEdit(document.project(), {0, 0}, {5, 0}, Arrow{}).edit));
  EXPECT_EQ(document.title(), "Untitled* - Windloom");
  ASSERT_TRUE(document.saveAs(folder / "a.wind.json"));
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.title(), "a.wind.json - Windloom");
  Document other;
  ASSERT_TRUE(other.open(folder / "a.wind.json"));
  EXPECT_EQ(writeProject(other.project()), writeProject(document.project()));
  EXPECT_FALSE(other.dirty());
  EXPECT_FALSE(other.history().canUndo());
}

TEST(Document, SaveWithoutAPathIsRefused) {
  Document document;
  const Status status = document.save();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::Usage);
}

TEST(Document, FailedSaveKeepsOldFileDirtyFlagAndPath) {
  TempFolder folder;
  Document document;
  ASSERT_TRUE(document.apply(renamed("First")));
  ASSERT_TRUE(document.saveAs(folder / "a.wind.json"));
  ASSERT_TRUE(document.apply(renamed("Second")));
  // A folder in the way of the file: no permission bits, so that it fails for root as well.
  EXPECT_FALSE(document.saveAs(folder / "missing" / "b.wind.json"));
  std::filesystem::create_directories(folder / "c.wind.json");
  EXPECT_FALSE(document.saveAs(folder / "c.wind.json"));
  EXPECT_TRUE(document.dirty());
  EXPECT_EQ(document.path(), folder / "a.wind.json");
  EXPECT_EQ(document.project().name, "Second");
  const auto onDisk = loadProject(folder / "a.wind.json");
  ASSERT_TRUE(onDisk);
  EXPECT_EQ(onDisk->project.name, "First");
}

TEST(Document, FailedOpenKeepsWhatWasOpen) {
  TempFolder folder;
  writeText(folder / "text.wind.json", "hello");
  writeText(folder / "other.wind.json", R"({"format": "something-else", "version": 1})");
  writeText(folder / "newer.wind.json", R"({"format": "windloom-project", "version": 999})");
  writeText(folder / "dangling.wind.json",
            R"({"format": "windloom-project", "version": 1, "name": "x",
                "graph": {"points": [{"id": 1, "position": [0, 0]}], "arrows": [{"id": 2, "from": 1, "to": 9}]}})");
  Document document;
  ASSERT_TRUE(document.apply(renamed("Work")));
  const Project before = document.project();
  for (const char* name :
       {"missing.wind.json", "text.wind.json", "other.wind.json", "newer.wind.json", "dangling.wind.json"}) {
    const Status status = document.open(folder / name);
    ASSERT_FALSE(status) << name;
    EXPECT_NE(status.error().text().find(name), std::string::npos) << status.error().text();
    EXPECT_TRUE(document.project().sameAs(before));
    EXPECT_TRUE(document.dirty());
    EXPECT_TRUE(document.path().empty());
    EXPECT_TRUE(document.history().canUndo());
  }
}

struct Flow {
  Document document;
  DocumentFlow flow{document};
  std::vector<std::string> failures, done;
  int replaced = 0;
  Flow() {
    flow.onFailure = [this](const Error& error) { failures.push_back(error.text()); };
    flow.onDone = [this](const std::string& text) { done.push_back(text); };
    flow.onReplaced = [this] { ++replaced; };
  }
  void edit() { EXPECT_TRUE(document.apply(renamed("Changed " + std::to_string(document.revision())))); }
};

TEST(DocumentFlow, CleanProjectsNeedNoQuestion) {
  Flow f;
  f.flow.requestQuit();
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  EXPECT_TRUE(f.flow.quitConfirmed());
}

TEST(DocumentFlow, QuitAsksAndCancelStays) {
  Flow f;
  f.edit();
  f.flow.requestQuit();
  EXPECT_EQ(f.flow.prompt(), Prompt::SaveChanges);
  f.flow.answerSaveChanges(SaveAnswer::Cancel);
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  EXPECT_FALSE(f.flow.quitConfirmed());
  EXPECT_TRUE(f.document.dirty());
  f.flow.requestQuit();
  f.flow.answerSaveChanges(SaveAnswer::DontSave);
  EXPECT_TRUE(f.flow.quitConfirmed());
}

TEST(DocumentFlow, QuittingDuringWorkAsksBeforeItStopsTheWork) {
  Flow f;
  std::string work = "An export";
  f.flow.workUnderWay = [&] { return work; };
  f.edit();
  f.flow.requestQuit();
  EXPECT_EQ(f.flow.prompt(), Prompt::StopWork);
  f.flow.answerStopWork(false);
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  EXPECT_FALSE(f.flow.quitConfirmed());
  f.flow.requestQuit();
  f.flow.answerStopWork(true);
  EXPECT_EQ(f.flow.prompt(), Prompt::SaveChanges);
  f.flow.answerSaveChanges(SaveAnswer::DontSave);
  EXPECT_TRUE(f.flow.quitConfirmed());
}

TEST(DocumentFlow, OpeningAnotherProjectLeavesWorkRunning) {
  Flow f;
  f.flow.workUnderWay = [] { return std::string("An export"); };
  f.flow.requestNew();
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
}

TEST(DocumentFlow, SaveOnQuitAsksForAPathAndThenQuits) {
  TempFolder folder;
  Flow f;
  f.edit();
  f.flow.requestQuit();
  f.flow.answerSaveChanges(SaveAnswer::Save);
  EXPECT_EQ(f.flow.prompt(), Prompt::ChooseSavePath);
  f.flow.answerPath(folder / "meadow");
  EXPECT_TRUE(f.flow.quitConfirmed());
  EXPECT_TRUE(std::filesystem::exists(folder / "meadow.wind.json"));
}

TEST(DocumentFlow, SavePathGetsItsExtensionOnce) {
  TempFolder folder;
  for (const auto& [typed, written] : {std::pair("a v1.2", "a v1.2.wind.json"), std::pair("b.wind", "b.wind.json"),
                                       std::pair("c.wind.json", "c.wind.json"), std::pair("d.json", "d.json")}) {
    Flow f;
    f.flow.requestSaveAs();
    f.flow.answerPath(folder / typed);
    EXPECT_EQ(f.document.path(), folder / written);
  }
}

TEST(DocumentFlow, CancelledPathCancelsTheQuit) {
  Flow f;
  f.edit();
  f.flow.requestQuit();
  f.flow.answerSaveChanges(SaveAnswer::Save);
  f.flow.answerPath({});
  EXPECT_FALSE(f.flow.quitConfirmed());
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  EXPECT_TRUE(f.document.dirty());
}

TEST(DocumentFlow, FailedSaveKeepsTheWorkAndDoesNotQuit) {
  TempFolder folder;
  Flow f;
  f.edit();
  f.flow.requestQuit();
  f.flow.answerSaveChanges(SaveAnswer::Save);
  f.flow.answerPath(folder / "missing" / "a.wind.json");
  EXPECT_FALSE(f.flow.quitConfirmed());
  EXPECT_EQ(f.failures.size(), 1u);
  EXPECT_TRUE(f.document.dirty());
}

TEST(DocumentFlow, OpenAsksForChangesThenForThePath) {
  TempFolder folder;
  Flow f;
  f.edit();
  ASSERT_TRUE(f.document.saveAs(folder / "a.wind.json"));
  const std::string name = f.document.project().name;
  f.edit();
  f.flow.requestOpen();
  EXPECT_EQ(f.flow.prompt(), Prompt::SaveChanges);
  f.flow.answerSaveChanges(SaveAnswer::DontSave);
  EXPECT_EQ(f.flow.prompt(), Prompt::ChooseOpenPath);
  f.flow.answerPath(folder / "a.wind.json");
  EXPECT_EQ(f.document.project().name, name);
  EXPECT_FALSE(f.document.dirty());
  EXPECT_EQ(f.replaced, 1);
}

TEST(DocumentFlow, FailedOpenTellsAndKeeps) {
  TempFolder folder;
  Flow f;
  f.edit();
  const Project before = f.document.project();
  f.flow.requestOpen(folder / "missing.wind.json");
  f.flow.answerSaveChanges(SaveAnswer::DontSave);
  EXPECT_EQ(f.failures.size(), 1u);
  EXPECT_TRUE(f.document.project().sameAs(before));
  EXPECT_TRUE(f.document.dirty());
  EXPECT_EQ(f.replaced, 0);
}

TEST(DocumentFlow, NewTakesATemplate) {
  Flow f;
  Project start;
  start.name = "Breeze";
  f.flow.requestNew(start);
  EXPECT_EQ(f.document.project().name, "Breeze");
  EXPECT_FALSE(f.document.dirty());
  f.flow.requestNew();
  EXPECT_EQ(f.document.project().name, "Untitled");
}

TEST(DocumentFlow, AsksBeforeItReplacesAFileThatAnotherProgramChanged) {
  TempFolder folder;
  Flow f;
  const auto path = folder / "a.wind.json";
  f.edit();
  ASSERT_TRUE(f.document.saveAs(path));
  EXPECT_FALSE(f.document.changedOnDisk());
  const Result<std::string> saved = readFile(path);
  ASSERT_TRUE(saved);
  const std::string theirs = *saved + "\n";
  writeText(path, theirs);
  EXPECT_TRUE(f.document.changedOnDisk());
  f.edit();
  f.flow.requestSave();
  EXPECT_EQ(f.flow.prompt(), Prompt::ConfirmChanged);
  f.flow.answerChanged(ChangedAnswer::Cancel);
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  EXPECT_EQ(readFile(path).value(), theirs);
  EXPECT_TRUE(f.document.dirty());
  f.flow.requestQuit();  // on the way out as well
  f.flow.answerSaveChanges(SaveAnswer::Save);
  EXPECT_EQ(f.flow.prompt(), Prompt::ConfirmChanged);
  f.flow.answerChanged(ChangedAnswer::AnotherName);
  EXPECT_EQ(f.flow.prompt(), Prompt::ChooseSavePath);
  f.flow.answerPath(path);  // the same name after all
  EXPECT_EQ(f.flow.prompt(), Prompt::ConfirmChanged);
  f.flow.answerChanged(ChangedAnswer::Replace);
  EXPECT_FALSE(f.document.dirty());
  EXPECT_TRUE(f.flow.quitConfirmed());
  EXPECT_EQ(readFile(folder / "a.wind.json.bak").value(), theirs);
  EXPECT_FALSE(f.document.changedOnDisk());
}

TEST(DocumentFlow, AFileThatIsGoneIsWrittenAgainWithoutAQuestion) {
  TempFolder folder;
  Flow f;
  f.edit();
  ASSERT_TRUE(f.document.saveAs(folder / "a.wind.json"));
  std::filesystem::remove(folder / "a.wind.json");
  EXPECT_FALSE(f.document.changedOnDisk());
  f.edit();
  f.flow.requestSave();
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  EXPECT_TRUE(std::filesystem::exists(folder / "a.wind.json"));
}

TEST(DocumentFlow, SaveAsAsksBeforeItOverwrites) {
  TempFolder folder;
  Flow f;
  f.edit();
  f.flow.requestSave();
  EXPECT_EQ(f.flow.prompt(), Prompt::ChooseSavePath);
  f.flow.answerPath(folder / "a.wind.json");
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  writeText(folder / "b.wind.json", "mine");
  f.edit();
  f.flow.requestSaveAs();
  f.flow.answerPath(folder / "b.wind.json");
  EXPECT_EQ(f.flow.prompt(), Prompt::ConfirmOverwrite);
  f.flow.answerOverwrite(false);
  EXPECT_EQ(f.flow.prompt(), Prompt::ChooseSavePath);
  EXPECT_EQ(readFile(folder / "b.wind.json").value(), "mine");
  f.flow.answerPath(folder / "b.wind.json");
  f.flow.answerOverwrite(true);
  EXPECT_EQ(f.document.path(), folder / "b.wind.json");
  EXPECT_FALSE(f.document.dirty());
  f.edit();
  f.flow.requestSave();  // its own file: no question
  EXPECT_EQ(f.flow.prompt(), Prompt::None);
  EXPECT_FALSE(f.document.dirty());
}

}  // namespace windloom::editor
