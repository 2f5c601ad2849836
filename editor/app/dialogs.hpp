#pragma once
// Questions and messages in front of everything: save changes, which file, overwrite, errors, rescue after a crash.

#include <deque>
#include <string>
#include <vector>

#include "editor/core/autosave.hpp"
#include "editor/core/workspace.hpp"
#include "editor/widgets/file_browser.hpp"

namespace windloom::editor {

class Dialogs {
 public:
  explicit Dialogs(Workspace& workspace) : m_workspace(workspace) {}

  /// Shows `text` until it is read.
  void showError(std::string text) { m_errors.push_back(std::move(text)); }
  void offerRescues(std::vector<Rescue> rescues) { m_rescues = std::move(rescues); }

  void draw();
  /// Something waits for an answer: keys are its.
  [[nodiscard]] bool open() const;

 private:
  void drawError();
  void drawSaveChanges();
  void drawOverwrite();
  void drawRescue();
  void askAboutRescue();
  void confirmDiscard();
  void nextRescue();
  void drawChanged();
  void drawStopWork();
  void drawOutside();
  void followFileChoice();
  [[nodiscard]] std::filesystem::path startFolder() const;

  Workspace& m_workspace;
  FileBrowser m_browser;
  std::string m_why;  // the project can't be saved where it is
  std::deque<std::string> m_errors;
  std::vector<Rescue> m_rescues;
  std::vector<std::string> m_rescueChanges;
  bool m_showChanges = false;
  bool m_discarding = false;  // asked whether really
};

}  // namespace windloom::editor
