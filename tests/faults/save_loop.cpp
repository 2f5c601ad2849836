// An editor without its window, for the tests in this folder: does one deed that writes files, tells how it went, and
// where it failed tries again without faults (faults.c). Every line on standard output is one fact.
//
// usage: save_loop DEED ARGUMENT...

#include <dlfcn.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "editor/core/autosave.hpp"
#include "editor/core/document.hpp"
#include "editor/core/document_flow.hpp"
#include "editor/core/log_file.hpp"
#include "editor/core/preferences.hpp"
#include "engine/bake/live_link.hpp"
#include "engine/core/log.hpp"
#include "engine/core/process.hpp"
#include "engine/io/image.hpp"

namespace windloom::editor {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kMostProbes = 900;  // a project holds 1000; what comes after the loop adds some more

bool onlyOnce = false;  // last word "once": no second try

void tell(const std::string& fact) {
  const std::string line = fact + "\n";
  if (::write(STDOUT_FILENO, line.data(), line.size()) < 0) std::exit(9);
}

void disarm() {
  if (void* found = ::dlsym(RTLD_DEFAULT, "faults_disarm")) reinterpret_cast<void (*)()>(found)();
}

std::string textOf(const Status& status) {
  return status ? "ok" : "failed " + status.error().text();
}

/// Once, and where that fails once more without faults.
int attempt(const std::function<Status()>& deed) {
  const Status first = deed();
  tell("first " + textOf(first));
  if (first || onlyOnce) return 0;
  disarm();
  tell("again " + textOf(deed()));
  return 0;
}

std::size_t probesOf(const Document& document) {
  return document.committed().probes->size();
}

/// Every edit adds a probe, so that their number tells which state a file has.
void addProbe(Document& document) {
  Probe probe;
  probe.id = static_cast<Id>(1000 + probesOf(document));
  probe.name = std::string(40, 'n');
  if (!document.apply({"Add a probe", {Put<Probe>{probe}}, {}})) std::exit(9);
}

Document opened(const std::string& file) {
  Document document;
  if (const Status status = document.open(file); !status) {
    tell("can't open " + status.error().text());
    std::exit(9);
  }
  return document;
}

/// As Ctrl+S does; `to`: Save as.
int save(const std::string& file, const std::optional<std::string>& to) {
  Document document = opened(file);
  DocumentFlow flow(document);
  addProbe(document);
  std::optional<Error> failed;
  flow.onFailure = [&](const Error& error) { failed = error; };
  return attempt([&]() -> Status {
    failed.reset();
    if (to) {
      flow.requestSaveAs();
      flow.answerPath(*to);
      if (flow.prompt() == Prompt::ConfirmOverwrite) flow.answerOverwrite(true);
    } else {
      flow.requestSave();
      // A folder that may not be written to: the editor asks for another place, and says why when it is the same.
      if (flow.prompt() == Prompt::ChooseSavePath) {
        flow.answerPath(file);
        flow.cancel();
      }
    }
    if (flow.prompt() != Prompt::None) return makeError(ErrorKind::Machine, "an unexpected question");
    tell("probes " + std::to_string(probesOf(document)) + (document.dirty() ? " dirty" : " clean"));
    if (failed) return *failed;
    return Done{};
  });
}

/// Twice what an autosave takes; the first write's result and the next one's.
int autosave(const std::string& file, const std::string& folder) {
  Document document = opened(file);
  Autosave autosave(folder, "driver");
  Status told = autosave.tick(document, 0);
  double now = 0;
  const auto write = [&]() -> Status {
    for (std::uint64_t i = 0; i < kAutosaveEdits; ++i) addProbe(document);
    Status begun = autosave.tick(document, ++now);
    if (!begun) return begun;
    return autosave.wait();
  };
  told = attempt(write) == 0 ? told : Status(Done{});
  // A failure is told once, not with each frame.
  int more = 0;
  for (int frame = 0; frame < 50; ++frame) more += autosave.tick(document, ++now * 0.01) ? 0 : 1;
  tell("told again " + std::to_string(more));
  return told ? 0 : 1;
}

int rescue(const std::string& folder, const std::string& to) {
  for (const Rescue& found : findRescues(folder)) {
    Document document;
    const Status restored = restoreRescue(document, found);
    tell("rescue " + (restored ? std::to_string(probesOf(document)) : textOf(restored)));
    if (restored && document.saveAs(to)) discardRescue(found);
  }
  return 0;
}

/// Edits, saves and autosaves until it is killed. "saved N" is a promise: so many probes are in the project.
int loop(const std::string& file, const std::string& folder, unsigned seed) {
  Document document = opened(file);
  Autosave autosave(folder, "driver");
  std::mt19937 dice(seed);
  for (double now = 0;; ++now) {
    if (probesOf(document) < kMostProbes) addProbe(document);  // on a fast disk they get so many
    tell("edited " + std::to_string(probesOf(document)));
    for (const Status& status : {autosave.tick(document, now), autosave.wait()}) {
      if (status) continue;
      tell("failed " + status.error().text());
      return 1;
    }
    if (dice() % 12 != 0) continue;
    if (const Status status = document.save(); !status) {
      tell("failed " + status.error().text());
      return 1;
    }
    tell("saved " + std::to_string(probesOf(document)));
  }
}

int preferences(const std::string& file) {
  Preferences preferences;
  preferences.numbers["layout.left"] = 321;
  return attempt([&] { return writePreferences(file, preferences); });
}

/// 200 lines of warnings; that the disk is full is no reason to stop.
int log(const std::string& folder) {
  LogFile file(folder);
  setLogSink([&](LogLevel level, std::string_view text) { file.add(level, text); });
  for (int line = 0; line < 200; ++line) logWarning("line " + std::to_string(line) + std::string(60, '.'));
  setLogSink({});
  tell("first ok");
  return 0;
}

int crash(const std::string& folder) {
  LogFile file(folder);
  file.add(LogLevel::Info, "about to crash");
  file.catchCrashes();
  std::abort();
}

int live(const std::string& name) {
  return attempt([&]() -> Status {
    const auto link = LiveLink::create(name);
    if (!link) return link.error();
    return Done{};
  });
}

int picture(const std::string& file) {
  const Image image(16, 16, 3);
  return attempt([&] { return writePng(file, image); });
}

int run(const Words& words) {
  const std::map<std::string, std::function<int()>> deeds = {
      {"save", [&] { return save(words.at(1), {}); }},
      {"saveas", [&] { return save(words.at(1), words.at(2)); }},
      {"autosave", [&] { return autosave(words.at(1), words.at(2)); }},
      {"rescue", [&] { return rescue(words.at(1), words.at(2)); }},
      {"loop", [&] { return loop(words.at(1), words.at(2), static_cast<unsigned>(std::stoul(words.at(3)))); }},
      {"preferences", [&] { return preferences(words.at(1)); }},
      {"log", [&] { return log(words.at(1)); }},
      {"crash", [&] { return crash(words.at(1)); }},
      {"live", [&] { return live(words.at(1)); }},
      {"picture", [&] { return picture(words.at(1)); }},
  };
  onlyOnce = !words.empty() && words.back() == "once";
  const auto found = words.empty() ? deeds.end() : deeds.find(words.front());
  return found == deeds.end() ? 2 : found->second();
}

}  // namespace
}  // namespace windloom::editor

int main(int argc, char** argv) {
  windloom::prepareProcess();
  return windloom::editor::run(std::vector<std::string>(argv + 1, argv + argc));
}
