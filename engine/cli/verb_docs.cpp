#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "engine/cli/command_line.hpp"
#include "engine/cli/common.hpp"
#include "engine/cli/completion.hpp"
#include "engine/cli/limits_page.hpp"
#include "engine/cli/man_page.hpp"
#include "engine/core/file.hpp"
#include "engine/core/text.hpp"
#include "engine/io/project_schema.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions {
  std::string folder;
  bool man = false, completion = false;
};

struct Document {
  std::string fileName, text;
};

std::vector<Document> documentsOf(const Options& options) {
  if (!options.man && !options.completion)
    return {{"project.schema.json", projectSchemaJson()},
            {"parameters.md", parametersMarkdown()},
            {"limits.md", limitsMarkdown()}};
  VerbAction ignored;
  const ProgramHelp program = describe(*makeApp(ignored));
  std::vector<Document> documents;
  if (options.man)
    for (ManPage& page : manPages(program, programVersion()))
      documents.push_back({page.fileName, std::move(page.text)});
  if (options.completion) {
    documents.push_back({"windloom.bash", bashCompletion(program)});
    documents.push_back({"_windloom", zshCompletion(program)});
  }
  return documents;
}

int writeDocs(const Options& options) {
  const std::filesystem::path folder = options.folder;
  Json written = Json::array();
  for (const auto& [name, text] : documentsOf(options)) {
    const std::filesystem::path path = folder / name;
    if (const Status status = writeFileAtomically(path, text); !status) return reportError(status.error(), options);
    written.push_back(path.string());
    if (!options.json) std::printf("%s\n", printable(path.string()).c_str());
  }
  if (options.json) printJson({{"ok", true}, {"files", written}});
  return kExitDone;
}

}  // namespace

VerbAction makeDocsVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("folder", options->folder,
                 "Where to write project.schema.json, parameters.md and limits.md, or what follows")
      ->required();
  app.add_flag("--man", options->man, "Instead: manual pages");
  app.add_flag("--completion", options->completion, "Instead: completion for bash and zsh");
  addCommonOptions(app, *options);
  return [options] { return writeDocs(*options); };
}

}  // namespace windloom::cli
