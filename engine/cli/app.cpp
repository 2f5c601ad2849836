#include "engine/cli/app.hpp"

#include <CLI/CLI.hpp>

namespace windloom::cli {

const char* programVersion() {
  return WINDLOOM_VERSION;
}

std::unique_ptr<CLI::App> makeApp(VerbAction& chosen) {
  auto app = std::make_unique<CLI::App>("Windloom: wind drawn as trees of arrows, seen in grass, exported for games.",
                                        "windloom");
  app->set_version_flag("--version", std::string("windloom ") + programVersion());
  app->footer(
      "'windloom VERB --help' explains a verb. Exit status: 0 done; 1 the input is wrong; 2 wrong usage; "
      "3 this machine can't.");
  app->require_subcommand(1);
  for (const Verb& verb : verbs()) {
    CLI::App* command = app->add_subcommand(verb.name, verb.summary);
    if (verb.kind == VerbKind::Developer) command->group("");
    command->final_callback([&chosen, todo = verb.make(*command)] { chosen = todo; });
  }
  return app;
}

}  // namespace windloom::cli
