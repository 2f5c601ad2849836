#include "editor/core/document.hpp"

#include "engine/core/log.hpp"
#include "engine/io/asset_copy.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/asset_names.hpp"

namespace windloom::editor {

Document::Document() : m_history(Project{}) {}

Status Document::apply(const Edit& edit) {
  endPreview();
  if (edit.steps.empty()) return Done{};
  Result<Project> result = applyEdit(committed(), edit);
  if (!result) return result.error();
  if (result->sameAs(committed())) return Done{};
  m_history.push(std::move(*result), edit.label, edit.mergeKey);
  committedChanged();
  return Done{};
}

Status Document::preview(const Edit& edit) {
  if (edit.steps.empty()) {
    endPreview();
    return Done{};
  }
  Result<Project> result = applyEdit(committed(), edit);
  if (!result) return result.error();
  m_preview = std::move(*result);
  m_previewing = true;
  touched();
  return Done{};
}

bool Document::endPreview() {
  if (!m_previewing) return false;
  m_previewing = false;
  m_preview = Project{};
  touched();
  return true;
}

bool Document::undo() {
  endPreview();
  if (!m_history.undo()) return false;
  committedChanged();
  return true;
}

bool Document::redo() {
  endPreview();
  if (!m_history.redo()) return false;
  committedChanged();
  return true;
}

bool Document::jump(std::size_t entry) {
  endPreview();
  if (entry == m_history.position() || !m_history.jump(entry)) return false;
  committedChanged();
  return true;
}

std::string Document::undoLabel() const {
  return m_history.canUndo() ? "Undo " + m_history.entries()[m_history.position()].label : "Undo";
}

std::string Document::redoLabel() const {
  return m_history.canRedo() ? "Redo " + m_history.entries()[m_history.position() + 1].label : "Redo";
}

std::string Document::title() const {
  const std::string name = m_path.empty() ? committed().name : m_path.filename().string();
  return name + (dirty() ? "*" : "") + " - Windloom";
}

void Document::startNew(Project start) {
  endPreview();
  m_history = History(std::move(start));
  m_missing.clear();
  m_outside = OutsideFiles::Refuse;
  m_outsideRefused = false;
  m_path.clear();
  m_stamp = {};
  m_rescuedFrom.clear();
  committedChanged();
}

Status Document::open(const std::filesystem::path& path, OutsideFiles outside) {
  // Taken before: a change while it is read counts as one after it.
  const FileStamp stamp = stampOf(path);
  Result<LoadedProject> loaded = loadProject(path, outside);
  if (!loaded) return loaded.error();
  for (const Problem& warning : loaded->warnings) logWarning(warning.text());
  m_missing = std::move(loaded->missing);
  m_outside = outside;
  m_outsideRefused = loaded->outsideRefused;
  endPreview();
  m_history = History(std::move(loaded->project));
  m_path = path;
  m_stamp = stamp;
  m_rescuedFrom.clear();
  committedChanged();
  return Done{};
}

bool Document::changedOnDisk() const {
  if (m_path.empty()) return false;
  const FileStamp now = stampOf(m_path);
  return now.exists && now != m_stamp;
}

Status Document::save() {
  if (m_path.empty()) return makeError(ErrorKind::Usage, "the project has no file yet");
  return saveAs(m_path);
}

Status Document::saveAs(const std::filesystem::path& path) {
  if (!m_path.empty()) {
    std::error_code ignored;
    const auto folderOf = [&](const std::filesystem::path& file) {
      return std::filesystem::absolute(file, ignored).parent_path();
    };
    const std::vector<std::string> files = assetFiles(committed());
    const Status copied = copyAssetsAlong(files, folderOf(m_path), folderOf(path), m_outside);
    if (!copied) return copied;
    for (const std::string& file : files) {
      if (folderOf(m_path) != folderOf(path) && !outsideReason(file).empty())
        logWarning("'" + file + "' lies outside the project's folder: it stays where it is, and so does its name");
    }
  }
  const Status status = saveProject(committed(), path);
  if (!status) return status;
  m_path = path;
  m_stamp = stampOf(path);
  m_history.markSaved();
  touched();
  return status;
}

void Document::recover(Project project, std::filesystem::path path, std::filesystem::path sideFile,
                       OutsideFiles outside) {
  endPreview();
  m_history = History(std::move(project));
  m_history.markUnsaved();
  m_path = std::move(path);
  m_stamp = stampOf(m_path);
  m_rescuedFrom = std::move(sideFile);
  m_outside = outside;
  m_outsideRefused = false;
  committedChanged();
}

}  // namespace windloom::editor
