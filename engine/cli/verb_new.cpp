#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "engine/cli/common.hpp"
#include "engine/cli/output_path.hpp"
#include "engine/cli/program_help.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/cli/wind_context.hpp"
#include "engine/core/text.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/templates.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions {
  std::string file, solver;
  std::string templateName{projectTemplates().front().name};
  bool force = false;
  bool list = false;
};

int listTemplates(const Options& options) {
  Json all = Json::array();
  for (const ProjectTemplate& entry : projectTemplates()) {
    all.push_back({{"name", entry.name}, {"title", entry.title}, {"summary", entry.summary}});
    if (!options.json) std::printf("%-20s  %s\n", std::string(entry.name).c_str(), std::string(entry.summary).c_str());
  }
  if (options.json) printJson({{"ok", true}, {"templates", all}});
  return kExitDone;
}

std::string templateNames() {
  std::string names;
  for (const ProjectTemplate& entry : projectTemplates()) names.append(names.empty() ? "" : ", ").append(entry.name);
  return names;
}

/// As the editor names what it saves: "gusts v1.2" has no ending, whatever follows its point. What is neither file nor
/// folder (/dev/null) keeps its name, by which it is refused.
Result<std::string> projectNamed(const std::string& name) {
  const std::filesystem::path path(name);
  const std::string last = path.filename().string();
  if (last.empty() || last == "." || last == "..")
    return makeError(ErrorKind::Usage, "found '" + name + "', expected the name of a file: NAME.wind.json");
  std::error_code ignored;
  if (path.extension() == ".json" || std::filesystem::is_other(path, ignored)) return name;
  return name + (path.extension() == ".wind" ? ".json" : ".wind.json");
}

int writeNew(Options options) {
  if (options.list) return listTemplates(options);
  const ProjectTemplate* chosen = findTemplate(options.templateName);
  if (options.file.empty()) {
    return reportError(makeError(ErrorKind::Usage, "expected the FILE to write, or --list"), options);
  }
  if (chosen == nullptr) {
    return reportError(makeError(ErrorKind::Usage, "--template: found '" + options.templateName +
                                                       "', expected one of " + templateNames()),
                       options);
  }
  const Result<std::string> named = projectNamed(options.file);
  if (!named) return reportError(named.error(), options);
  options.file = *named;
  if (const Status there = requireFolderOf(options.file); !there) return reportError(there.error(), options);
  std::error_code ignored;
  if (!options.force && std::filesystem::exists(options.file, ignored)) {
    return reportError(
        makeError(ErrorKind::BadInput, options.file, {}, "exists already; --force writes over it and keeps a .bak"),
        options);
  }
  Project project = chosen->make();
  if (const Status used = useSolver(project, options.solver); !used) return reportError(used.error(), options);
  if (const Status saved = saveProject(project, options.file); !saved) return reportError(saved.error(), options);
  if (options.json) {
    printJson({{"ok", true}, {"file", options.file}, {"template", chosen->name}});
  } else {
    std::printf("%s: written from template %s\n", printable(options.file).c_str(), std::string(chosen->name).c_str());
  }
  return kExitDone;
}

}  // namespace

VerbAction makeNewVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("file", options->file,
                 "Project file to write: NAME.wind.json; the ending is added where it is missing");
  std::vector<std::string> names;
  for (const ProjectTemplate& entry : projectTemplates()) names.emplace_back(entry.name);
  offer(app.add_option("-t,--template", options->templateName, "What to start from: " + templateNames())
            ->type_name("NAME")
            ->capture_default_str(),
        names);
  addSolverOption(app, options->solver);
  app.add_flag("--force", options->force, "Write over an existing file, which is kept as FILE.bak");
  app.add_flag("--list", options->list, "List the templates and write nothing");
  addCommonOptions(app, *options);
  return [options] { return writeNew(*options); };
}

}  // namespace windloom::cli
