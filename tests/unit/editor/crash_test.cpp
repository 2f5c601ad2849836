// Editors killed at random moments: whatever they were doing, the file on disk is a whole project, the old or the new
// one, and the side file gives back all but the last 25 edits.

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <random>
#include <thread>

#include "editor/core/autosave.hpp"
#include "editor_bench.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {
namespace {

constexpr int kKills = 100;
constexpr int kMostLost = 25;

/// What the killed editor had done, in memory that outlives it. Every edit adds a probe, so that a count of probes
/// names a state of the project.
struct Deeds {
  volatile int edits = 0;
  volatile int saveBegun = 0, saveDone = 0;  // probes of the last save
};

struct SharedDeeds {
  SharedDeeds()
      : deeds(new (mmap(nullptr, sizeof(Deeds), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) Deeds) {}
  ~SharedDeeds() { munmap(deeds, sizeof(Deeds)); }
  Deeds* deeds;
};

/// An editor at work: edits, autosaves, now and then saves; until it is killed.
[[noreturn]] void work(const std::filesystem::path& folder, Deeds& deeds, unsigned seed) {
  std::mt19937 random(seed);
  Document document;
  Autosave autosave(folder / "side", "killed");
  if (!document.saveAs(folder / "mine.wind.json")) _exit(1);
  if (!autosave.tick(document, 0)) _exit(1);
  std::uint64_t safe = document.editCount();  // edits that a finished write holds
  for (int frame = 1;; ++frame) {
    Probe probe;
    probe.id = static_cast<Id>(frame);
    probe.name = std::string(200, 'n');
    const Edit edit{"Add a probe", {Put<Probe>{probe}}, {}};
    // A disk that stands still while a person goes on can't be tested here: it gets the time that it needs.
    if (document.editCount() - safe >= kMostLost) {
      if (!autosave.wait() || !autosave.tick(document, frame) || !autosave.wait()) _exit(1);
      safe += kAutosaveEdits;  // what was written is at least so new
    }
    if (!document.apply(edit)) _exit(1);
    deeds.edits = frame;
    if (!autosave.tick(document, frame)) _exit(1);
    if (random() % 40 != 0) continue;
    deeds.saveBegun = frame;
    if (!document.save()) _exit(1);
    deeds.saveDone = frame;
    if (!autosave.tick(document, frame)) _exit(1);
    safe = document.editCount();
  }
}

int probesIn(const Project& project) {
  return static_cast<int>(project.probes->size());
}

void killOnce(unsigned seed) {
  TempFolder folder;
  SharedDeeds shared;
  Deeds& deeds = *shared.deeds;
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) work(folder.path(), deeds, seed);
  while (deeds.edits == 0 && waitpid(child, nullptr, WNOHANG) == 0) std::this_thread::yield();
  std::mt19937 random(seed);
  std::this_thread::sleep_for(std::chrono::microseconds(random() % 60000));
  ASSERT_EQ(kill(child, SIGKILL), 0);
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself: something failed in it";

  const Result<LoadedProject> file = loadProject(folder / "mine.wind.json");
  ASSERT_TRUE(file) << file.error().text();
  const int saved = probesIn(file->project);
  EXPECT_TRUE(saved == deeds.saveDone || saved == deeds.saveBegun)
      << saved << " probes in the file; saves of " << deeds.saveDone << " done and " << deeds.saveBegun << " begun";
  int rescued = 0;
  for (const Rescue& rescue : findRescues(folder / "side")) {
    Document restored;
    ASSERT_TRUE(restoreRescue(restored, rescue));
    rescued = probesIn(restored.project());
  }
  EXPECT_LE(deeds.edits - std::max(saved, rescued), kMostLost) << saved << " saved, " << rescued << " rescued";
}

}  // namespace

TEST(Crash, AHundredKillsLeaveWholeFilesAndLoseAtMostTwentyFiveEdits) {
  for (unsigned seed = 1; seed <= kKills && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    killOnce(seed);
  }
}

}  // namespace windloom::editor
