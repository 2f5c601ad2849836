#include <cstdio>
#include <new>

#include "editor/app/app.hpp"
#include "editor/app/user_folders.hpp"
#include "editor/app/window.hpp"
#include "editor/core/log_file.hpp"
#include "engine/core/heap.hpp"
#include "engine/core/log.hpp"
#include "engine/core/memory_reserve.hpp"
#include "engine/core/process.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace windloom;
  prepareProcess();
  keepHeapTight();
  keepMemoryReserve();
  int exitStatus = 0;
  const auto line = editor::parseCommandLine(argc, argv, exitStatus);
  if (!line) return exitStatus;
  editor::LogFile file(line->unattended() ? std::filesystem::path() : editor::stateFolder());
  file.add(LogLevel::Info, "windloom-editor " WINDLOOM_VERSION " starts");
  file.catchCrashes();
  std::string lastWords;
  {
    auto app = editor::App::create(*line, file);
    if (!app) {
      file.add(LogLevel::Error, app.error().text());
      logError(app.error().text());
      if (!line->unattended()) editor::showTrouble(app.error().text());
      return app.error().kind == ErrorKind::Machine ? 3 : 1;
    }
    exitStatus = (*app)->run();
    lastWords = (*app)->lastWords();
  }
  file.add(LogLevel::Info, "ends with status " + std::to_string(exitStatus));
  // In a window of its own, with another context: the editor's is lost.
  if (!lastWords.empty()) editor::showTrouble(lastWords);
  return exitStatus;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    // At the start, or at the end when the work is kept aside already: see App::memoryEnded.
    std::fputs("windloom-editor: there is not enough memory\n", stderr);
    return 3;
  }
}
