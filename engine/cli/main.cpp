#include <cstdio>
#include <cstring>
#include <exception>

#include "engine/cli/app.hpp"
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

int run(int argc, char** argv) {
  VerbAction action;
  const std::unique_ptr<CLI::App> app = makeApp(action);
  CommonOptions options;
  for (int i = 1; i < argc; ++i) options.json = options.json || std::strcmp(argv[i], "--json") == 0;
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return usageError(*app, error, options);
  }
  return action();
}

}  // namespace
}  // namespace windloom::cli

int main(int argc, char** argv) {
  try {
    return windloom::cli::run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "windloom: %s\n", error.what());
    return windloom::cli::kExitMachine;
  }
}
