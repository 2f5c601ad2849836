#include <filesystem>
#include <memory>

#include "engine/cli/common.hpp"
#include "engine/cli/limits_page.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/core/file.hpp"
#include "engine/io/project_schema.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions {
  std::string folder;
};

int writeDocs(const Options& options) {
  const std::filesystem::path folder = options.folder;
  const std::pair<const char*, std::string> files[] = {{"project.schema.json", projectSchemaJson()},
                                                       {"parameters.md", parametersMarkdown()},
                                                       {"limits.md", limitsMarkdown()}};
  Json written = Json::array();
  for (const auto& [name, text] : files) {
    const std::filesystem::path path = folder / name;
    if (const Status status = writeFileAtomically(path, text); !status) return reportError(status.error(), options);
    written.push_back(path.string());
    if (!options.json) std::printf("%s\n", path.c_str());
  }
  if (options.json) printJson({{"ok", true}, {"files", written}});
  return kExitDone;
}

}  // namespace

VerbAction makeDocsVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("folder", options->folder, "Where to write project.schema.json, parameters.md and limits.md")
      ->required();
  addCommonOptions(app, *options);
  return [options] { return writeDocs(*options); };
}

}  // namespace windloom::cli
