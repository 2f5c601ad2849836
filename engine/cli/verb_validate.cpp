#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "engine/cli/common.hpp"
#include "engine/cli/project_option.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/core/text.hpp"
#include "engine/io/project_json.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions, ProjectOptions {
  std::vector<std::string> files;
};

int validateFiles(const Options& options) {
  int status = kExitDone;
  Json errors = Json::array(), warnings = Json::array();
  for (const std::string& file : options.files) {
    const Result<LoadedProject> loaded = loadWhole(file, options.outside);
    const std::vector<Problem> none;
    const std::vector<Problem>& problems = loaded ? none : loaded.error().problems;
    const std::vector<Problem>& remarks = loaded ? loaded->warnings : none;
    if (!loaded) status = std::max(status, exitStatus(loaded.error().kind));
    for (const Problem& problem : problems) std::fprintf(stderr, "error: %s\n", problem.text().c_str());
    for (const Problem& remark : remarks) std::fprintf(stderr, "warning: %s\n", remark.text().c_str());
    for (const Json& entry : problemsJson(problems)) errors.push_back(entry);
    for (const Json& entry : problemsJson(remarks)) warnings.push_back(entry);
    if (!options.json && loaded) std::printf("%s: valid\n", printable(file).c_str());
  }
  if (options.json) {
    Json output{{"ok", status == kExitDone}, {"warnings", warnings}};
    if (status != kExitDone) output["errors"] = errors;
    printJson(output);
  }
  return status;
}

}  // namespace

VerbAction makeValidateVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("file", options->files, "Project files (NAME.wind.json)")->required();
  addProjectOptions(app, *options);
  addCommonOptions(app, *options);
  app.footer(
      "Lists every problem with its file and its place as a JSON pointer, and warns of unknown keys.\n"
      "Exit status 1 where a file has problems.");
  return [options] { return validateFiles(*options); };
}

}  // namespace windloom::cli
