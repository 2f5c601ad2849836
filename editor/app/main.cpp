#include <cstdio>
#include <new>

#include "editor/app/app.hpp"
#include "editor/app/window.hpp"
#include "engine/core/log.hpp"

namespace {

int run(int argc, char** argv) {
  using namespace windloom;
  int exitStatus = 0;
  const auto line = editor::parseCommandLine(argc, argv, exitStatus);
  if (!line) return exitStatus;
  auto app = editor::App::create(*line);
  if (!app) {
    logError(app.error().text());
    if (!line->unattended()) editor::showTrouble(app.error().text());
    return app.error().kind == ErrorKind::Machine ? 3 : 1;
  }
  return (*app)->run();
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
