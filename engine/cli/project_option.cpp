#include <CLI/CLI.hpp>

#include "engine/cli/project_option.hpp"

#include "engine/core/log.hpp"

namespace windloom::cli {

void addProjectOptions(CLI::App& app, ProjectOptions& options) {
  app.add_flag_callback(
      "--allow-outside", [&options] { options.outside = OutsideFiles::Allow; },
      "Also read files that the project names outside its own folder: for projects that you trust");
}

Result<LoadedProject> loadWhole(const std::string& file, OutsideFiles outside) {
  Result<LoadedProject> loaded = loadProject(file, outside);
  if (!loaded || loaded->missing.empty()) return loaded;
  Error error{ErrorKind::BadInput, std::move(loaded->missing)};
  if (loaded->outsideRefused) error.problems.back().message += " (--allow-outside)";
  return error;
}

Result<Project> loadWithWarnings(const std::string& file, OutsideFiles outside) {
  Result<LoadedProject> loaded = loadWhole(file, outside);
  if (!loaded) return loaded.error();
  for (const Problem& warning : loaded->warnings) logWarning(warning.text());
  return std::move(loaded->project);
}

}  // namespace windloom::cli
