#include "engine/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>

#include "engine/cli/common.hpp"

namespace windloom::cli {
namespace {

int usageError(const CLI::App& app, const CLI::ParseError& error, const CommonOptions& options) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);  // --help, --version
  const int status = reportError(makeError(ErrorKind::Usage, error.what()), options);
  const auto chosen = app.get_subcommands();
  std::fprintf(stderr, "Run 'windloom %s--help' for how to use it.\n",
               chosen.empty() ? "" : (chosen.front()->get_name() + " ").c_str());
  return status;
}

}  // namespace

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

std::optional<VerbAction> parseCommandLine(int argc, const char* const* argv, int& exitStatus) {
  VerbAction action;
  const std::unique_ptr<CLI::App> app = makeApp(action);
  CommonOptions options;
  for (int i = 1; i < argc; ++i) options.json = options.json || std::strcmp(argv[i], "--json") == 0;
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    exitStatus = usageError(*app, error, options);
    return std::nullopt;
  }
  return action;
}

}  // namespace windloom::cli
