#include "editor/core/clipboard.hpp"

#include <algorithm>
#include <map>

#include "editor/core/object_edits.hpp"
#include "engine/core/log.hpp"
#include "engine/io/asset_copy.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/asset_names.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

fs::path folderOf(const Document& document) {
  std::error_code ignored;
  return document.path().empty() ? fs::path() : fs::absolute(document.path(), ignored).parent_path();
}

template <typename Record>
void rename(Shared<std::vector<Record>>& records, const std::map<std::string, std::string>& names) {
  std::vector<Record> renamed = *records;
  for (Record& record : renamed)
    if (const auto name = names.find(record.file); name != names.end()) record.file = name->second;
  records = std::make_shared<const std::vector<Record>>(std::move(renamed));
}

/// Copies the files of the pieces from one project's folder into another's, under names that may be others there.
void bringFiles(Project& pieces, const fs::path& from, const fs::path& to) {
  std::map<std::string, std::string> names;
  for (const std::string& file : assetFiles(pieces)) {
    // What lies outside of its project's folder is not this project's to take.
    std::error_code ignored;
    if (!outsideReason(file).empty() || !fs::is_regular_file(from / file, ignored)) continue;
    const Result<std::string> name = bringAsset(from / file, to);
    if (!name) {
      logWarning(name.error().text());
    } else if (*name != file) {
      names[file] = *name;
    }
  }
  if (names.empty()) return;
  rename(pieces.species, names);
  rename(pieces.colliders, names);
  rename(pieces.surfaces, names);
}

}  // namespace

void copySelection(Workspace& workspace) {
  if (workspace.selection.empty()) return;
  const std::string text = writeProject(extract(workspace.document.committed(), workspace.selection.ids()));
  workspace.writeClipboardText(text, folderOf(workspace.document));
  workspace.say(MessageKind::Info, "Copied " + describeIds(workspace.document.committed(), workspace.selection.ids()));
}

void pasteAtPointer(Workspace& workspace) {
  const std::string text = workspace.clipboardText();
  Result<LoadedProject> pieces = parseProject(text, "clipboard");
  if (!pieces) {
    workspace.say(MessageKind::Warning, "Can't paste: " + pieces.error().problems.front().text());
    return;
  }
  std::string missing;
  if (const fs::path to = folderOf(workspace.document); !to.empty()) {
    if (const fs::path from = workspace.copiedFrom(text); !from.empty() && from != to)
      bringFiles(pieces->project, from, to);
    // What isn't there is shown as missing.
    if (const Status read = loadAssets(pieces->project, workspace.document.path(), workspace.document.outside()); !read)
      missing = read.error().problems.front().text();
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
    if (!missing.empty()) workspace.say(MessageKind::Warning, "Pasted without a file: " + missing);
  }
}

}  // namespace windloom::editor
