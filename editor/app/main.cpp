#include "editor/app/app.hpp"
#include "editor/app/window.hpp"
#include "engine/core/log.hpp"

int main(int argc, char** argv) {
  using namespace windloom;
  int exitStatus = 0;
  const auto line = editor::parseCommandLine(argc, argv, exitStatus);
  if (!line) return exitStatus;
  std::string lastWords;
  {
    auto app = editor::App::create(*line);
    if (!app) {
      logError(app.error().text());
      if (!line->unattended()) editor::showTrouble(app.error().text());
      return app.error().kind == ErrorKind::Machine ? 3 : 1;
    }
    exitStatus = (*app)->run();
    lastWords = (*app)->lastWords();
  }
  // In a window of its own, with another context: the editor's is lost.
  if (!lastWords.empty()) editor::showTrouble(lastWords);
  return exitStatus;
}
