// The system's clipboard, pasted into an open project: the project stays valid, undo takes it back to the byte, redo
// brings it again.

#include <vector>

#include "editor/core/clipboard.hpp"
#include "engine/core/log.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/edit.hpp"
#include "engine/model/validate.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"

using namespace windloom;
using namespace windloom::editor;
using fuzz::require;

namespace {

/// Small, since it is made and compared for each input: a tree, and one thing of some other kinds.
Project startProject() {
  Project project;
  const TreeResult tree = treeEdit(project, {-10, 0}, {10, 5}, {});
  project = *applyEdit(project, tree.edit);
  Obstacle obstacle;
  obstacle.id = 20;
  Collider collider;
  collider.id = 21;
  Species species;
  species.id = 22;
  return *applyEdit(project, {"Add", {Put<Obstacle>{obstacle}, Put<Collider>{collider}, Put<Species>{species}}, {}});
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  setLogLevel(LogLevel::Error);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Project kStart = startProject();
  static const std::string kBefore = writeProject(kStart);
  Workspace workspace;
  workspace.document.startNew(kStart);
  workspace.readClipboard = [&] { return std::string(fuzz::asText(data, size)); };
  std::string copied;
  workspace.writeClipboard = [&](const std::string& text) { copied = text; };

  pasteAtPointer(workspace);
  const bool pasted = workspace.document.history().canUndo();
  require(pasted || !workspace.message().text.empty(), "a refusal says why");
  if (!pasted) return 0;
  require(validate(workspace.document.project()).empty(), "what was pasted leaves a valid project");
  const std::string after = writeProject(workspace.document.project());
  require(parseProject(after, "after").ok(), "the project can be read again");
  copySelection(workspace);
  require(copied.empty() || parseProject(copied, "copied").ok(), "what was copied can be pasted");
  pasteAtPointer(workspace);
  workspace.undo();
  workspace.jumpTo(0);
  require(writeProject(workspace.document.project()) == kBefore, "undo takes it back");
  workspace.redo();
  require(writeProject(workspace.document.project()) == after, "redo brings it again");
  return 0;
}
