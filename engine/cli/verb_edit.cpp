#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

#include "engine/cli/common.hpp"
#include "engine/cli/verbs.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions {
  std::string file;
};

/// The editor is installed and built beside this program.
Result<std::filesystem::path> findEditor() {
  std::error_code failed;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failed);
  const std::filesystem::path editor = self.parent_path() / "windloom-editor";
  if (!failed && std::filesystem::is_regular_file(editor, failed)) return editor;
  return makeError(ErrorKind::Machine, editor.string(), "",
                   "the editor is not there; this may be a build without it (the headless preset leaves it out)");
}

int startEditor(const Options& options) {
  const Result<std::filesystem::path> editor = findEditor();
  if (!editor) return reportError(editor.error(), options);
  const std::string program = editor->string();
  // Where execv succeeds the editor takes this process over, so its exit status is this verb's.
  const char* const arguments[] = {program.c_str(), options.file.empty() ? nullptr : options.file.c_str(), nullptr};
  ::execv(program.c_str(), const_cast<char* const*>(arguments));
  return reportError(
      makeError(ErrorKind::Machine, program, "", std::string("can't be started: ") + std::strerror(errno)), options);
}

}  // namespace

VerbAction makeEditVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "Project file to open (NAME.wind.json); none: an empty project");
  addCommonOptions(app, *options);
  return [options] { return startEditor(*options); };
}

}  // namespace windloom::cli
