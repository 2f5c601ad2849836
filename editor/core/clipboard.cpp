#include "editor/core/clipboard.hpp"

#include <algorithm>

#include "editor/core/object_edits.hpp"
#include "engine/core/log.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/project_json.hpp"

namespace windloom::editor {

void copySelection(Workspace& workspace) {
  if (workspace.selection.empty()) return;
  const std::string text = writeProject(extract(workspace.document.committed(), workspace.selection.ids()));
  workspace.writeClipboardText(text);
  workspace.say(MessageKind::Info, "Copied " + describeIds(workspace.document.committed(), workspace.selection.ids()));
}

void pasteAtPointer(Workspace& workspace) {
  Result<LoadedProject> pieces = parseProject(workspace.clipboardText(), "clipboard");
  if (!pieces) {
    workspace.say(MessageKind::Warning, "Can't paste: " + pieces.error().problems.front().text());
    return;
  }
  // Meshes that this project's folder has come along; others are shown as missing.
  if (!workspace.document.path().empty()) {
    if (const Status read = loadAssets(pieces->project, workspace.document.path(), workspace.document.outside()); !read)
      logWarning(read.error().text());
  }
  const std::vector<Id> ids = selectableIds(pieces->project);
  const auto pivot = pivotOf(pieces->project, ids);
  const auto pointer = workspace.context().groundAt(workspace.pointer());
  const glm::vec2 offset = pivot && pointer ? *pointer - *pivot : glm::vec2(0.0f);
  DuplicateResult copies = insertProjectEdit(workspace.document.committed(), pieces->project, offset);
  if (copies.edit.steps.empty()) {
    workspace.say(MessageKind::Warning, "Can't paste: the clipboard holds an empty project");
  } else if (workspace.apply(copies.edit)) {
    workspace.selection.replace(std::move(copies.ids));
  }
}

}  // namespace windloom::editor
