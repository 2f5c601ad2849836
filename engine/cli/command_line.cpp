#include "engine/cli/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "engine/cli/common.hpp"
#include "engine/cli/usage_text.hpp"

namespace windloom::cli {
namespace {

int usageError(CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);  // --help, --version
  CommonOptions options;
  options.json = std::ranges::find(words, "--json") != words.end();
  const int status = reportError(makeError(ErrorKind::Usage, usageProblem(app, error, words)), options);
  const auto chosen = app.get_subcommands();
  std::fprintf(stderr, "Run 'windloom %s--help' for how to use it.\n",
               chosen.empty() ? "" : (chosen.front()->get_name() + " ").c_str());
  return status;
}

/// `help VERB` is `VERB --help`.
std::vector<std::string> withHelpAsOption(std::vector<std::string> words) {
  if (words.empty() || words.front() != "help") return words;
  std::string about = words.size() > 1 && !words[1].starts_with('-') ? words[1] : "";
  const bool known = std::ranges::any_of(verbs(), [&](const Verb& verb) { return verb.name == about; });
  if (!known && !about.empty()) return {about};  // which is told to be none
  words = known ? std::vector<std::string>{about} : std::vector<std::string>{};
  words.emplace_back("--help");
  return words;
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
  app->formatter(helpFormatter());
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
  const std::vector<std::string> words = withHelpAsOption({argv + std::min(argc, 1), argv + argc});
  try {
    app->parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 wants them from the last to the first
  } catch (const CLI::ParseError& error) {
    exitStatus = usageError(*app, error, words);
    return std::nullopt;
  }
  return action;
}

}  // namespace windloom::cli
