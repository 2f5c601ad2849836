#pragma once
// The open project: its history, its file, and the one way it changes. Knows no window.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "editor/core/file_stamp.hpp"
#include "editor/core/history.hpp"
#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

class Document {
 public:
  Document();

  /// What to show: the project with the live preview of a drag, if there is one.
  [[nodiscard]] const Project& project() const { return m_previewing ? m_preview : m_history.current(); }
  /// Without the preview; what edits apply to and what is saved.
  [[nodiscard]] const Project& committed() const { return m_history.current(); }
  /// Grows with every change of project(), so that a panel can tell cheaply.
  [[nodiscard]] std::uint64_t revision() const { return m_revision; }
  /// Grows with every change of committed(): edits, those that merge into a step as well, undo and redo.
  [[nodiscard]] std::uint64_t editCount() const { return m_edits; }

  /// Applies an edit of the committed project as one undo step (merge keys as in History) and ends a
  /// preview. An edit without steps, or one that changes nothing, is done and leaves no step. A refused
  /// edit leaves everything as it was, the preview ended.
  Status apply(const Edit& edit);
  /// Shows `edit` applied to the committed project without a step: a drag calls it with its whole edit at
  /// each move. A refused preview keeps showing the last good one.
  Status preview(const Edit& edit);
  /// Back to the committed project. True where a preview was shown.
  bool endPreview();
  [[nodiscard]] bool previewing() const { return m_previewing; }

  bool undo();  ///< also ends a preview
  bool redo();
  bool jump(std::size_t entry);
  void seal() { m_history.seal(); }  ///< the next edit is a new step: a slider was let go
  [[nodiscard]] const History& history() const { return m_history; }
  /// "Undo Move point" / "Undo"
  [[nodiscard]] std::string undoLabel() const;
  [[nodiscard]] std::string redoLabel() const;

  [[nodiscard]] bool dirty() const { return m_history.dirty(); }
  /// Empty where the project was never saved.
  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
  /// "meadow.wind.json* - Windloom"; the project's name where there is no file.
  [[nodiscard]] std::string title() const;

  /// An empty project, or `start` (a template), clean and without a file.
  void startNew(Project start = {});
  /// On failure the document stays as it was. Warnings of the reader (unknown keys) go to the log.
  /// Files of the project outside its folder are read only where `outside` allows it.
  Status open(const std::filesystem::path& path, OutsideFiles outside = OutsideFiles::Refuse);
  /// What it was opened with.
  [[nodiscard]] OutsideFiles outside() const { return m_outside; }
  /// Some of missing() lie outside the project's folder, and that was not allowed.
  [[nodiscard]] bool outsideRefused() const { return m_outsideRefused; }
  /// Files that the project as it was opened names and that couldn't be read; it is open all the same.
  [[nodiscard]] const std::vector<Problem>& missing() const { return m_missing; }
  /// Another program wrote the file, or put another in its place, since it was read or saved here: saving would replace
  /// what this document never saw. A file that is gone has not changed.
  [[nodiscard]] bool changedOnDisk() const;
  /// Fails with Usage where there is no path. On failure the old file is intact, the project still dirty.
  Status save();
  /// Takes the path over only on success. Into another folder the project's files go along.
  Status saveAs(const std::filesystem::path& path);
  /// Takes over a project rescued from a side file: dirty, belonging to `path` (may be empty).
  void recover(Project project, std::filesystem::path path, std::filesystem::path sideFile,
               OutsideFiles outside = OutsideFiles::Refuse);
  /// The side file that the open project was rescued from; empty for others. Autosave takes it over.
  [[nodiscard]] const std::filesystem::path& rescuedFrom() const { return m_rescuedFrom; }

 private:
  void touched() { ++m_revision; }
  void committedChanged() {
    ++m_edits;
    touched();
  }
  History m_history;
  Project m_preview;
  bool m_previewing = false;
  std::filesystem::path m_path, m_rescuedFrom;
  FileStamp m_stamp;  // of the file as it was read or saved
  std::vector<Problem> m_missing;
  OutsideFiles m_outside = OutsideFiles::Refuse;
  bool m_outsideRefused = false;
  std::uint64_t m_revision = 1, m_edits = 0;
};

}  // namespace windloom::editor
