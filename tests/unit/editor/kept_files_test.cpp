#include "editor/core/kept_files.hpp"

#include <unistd.h>

#include <cstdlib>

#include "editor/core/workspace.hpp"
#include "editor_bench.hpp"
#include "engine/core/file.hpp"
#include "engine/io/project_json.hpp"

namespace windloom::editor {
namespace {

/// A data folder of its own with one sample, as an installed program has.
class KeptFiles : public ::testing::Test {
 protected:
  KeptFiles() : sample(folder / "projects" / "calm" / "calm.wind.json") {
    std::filesystem::create_directories(sample.parent_path());
    EXPECT_TRUE(saveProject(Project{}, sample));
    ::setenv("WINDLOOM_DATA", folder.path().c_str(), 1);
  }
  ~KeptFiles() override { ::unsetenv("WINDLOOM_DATA"); }

  TempFolder folder;
  std::filesystem::path sample;
};

TEST_F(KeptFiles, AreSamplesByTheirPlace) {
  EXPECT_EQ(whyKept(sample), "calm.wind.json is a sample and stays as it is.");
  EXPECT_EQ(whyKept(sample.parent_path() / ".." / "calm" / "new.wind.json"),
            sample.parent_path().string() + " holds samples and is not written to.");
  EXPECT_EQ(whyKept(folder / "calm.wind.json"), "");
  EXPECT_EQ(whyKept(folder / "projects-of-mine" / "calm.wind.json"), "");
}

TEST_F(KeptFiles, SavingASampleAsksForAPlaceAndTakesNoneAmongTheSamples) {
  Workspace w;
  std::vector<std::string> failures, done;
  w.flow.onFailure = [&](const Error& error) { failures.push_back(error.text()); };
  w.flow.onDone = [&](const std::string& text) { done.push_back(text); };
  w.flow.onFileUsed = {};
  w.flow.requestOpen(sample);
  ASSERT_EQ(done.size(), 1u);
  EXPECT_NE(done[0].find("Saving will ask for a place"), std::string::npos) << done[0];
  const std::string before = readFile(sample).value();

  w.flow.requestSave();
  EXPECT_EQ(w.flow.prompt(), Prompt::ChooseSavePath);
  w.flow.answerPath(sample);
  EXPECT_EQ(w.flow.prompt(), Prompt::ChooseSavePath);
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_NE(failures[0].find("stays as it is"), std::string::npos) << failures[0];
  w.flow.answerPath(folder / "mine");
  EXPECT_EQ(w.document.path(), folder / "mine.wind.json");
  EXPECT_EQ(readFile(sample).value(), before);

  w.flow.requestSave();  // its own file now: no question
  EXPECT_EQ(w.flow.prompt(), Prompt::None);
}

TEST_F(KeptFiles, AreThoseInFoldersThatMayNotBeWrittenTo) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is read-only for root";
  const auto locked = folder / "locked";
  std::filesystem::create_directories(locked);
  std::filesystem::permissions(locked, std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_EQ(whyKept(locked / "a.wind.json"), locked.string() + " may not be written to.");
  std::filesystem::permissions(locked, std::filesystem::perms::owner_all);
}

}  // namespace
}  // namespace windloom::editor
