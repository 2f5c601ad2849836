#pragma once
// New, open, save, save as and quit with their questions, as a small state machine. The app looks at
// prompt() each frame, shows the matching dialog and calls the matching answer.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "editor/core/document.hpp"

namespace windloom::editor {

enum class Prompt {
  None,
  SaveChanges,       ///< "Save changes to NAME?": answerSaveChanges
  ChooseOpenPath,    ///< a file to open: answerPath
  ChooseSavePath,    ///< where to save: answerPath
  ConfirmOverwrite,  ///< pendingPath() exists: answerOverwrite
  ConfirmChanged,    ///< another program changed the document's file: answerChanged
  StopWork,          ///< quitting would stop workUnderWay(): answerStopWork
  OutsideFiles,      ///< what was opened names files outside its folder, see Document::missing: answerOutside
};
enum class SaveAnswer { Save, DontSave, Cancel };
enum class ChangedAnswer { Replace, AnotherName, Cancel };

class DocumentFlow {
 public:
  explicit DocumentFlow(Document& document) : m_document(document) {}

  // Requests. A request while another is pending replaces it.
  void requestNew(Project start = {});           ///< `start`: a template
  void requestOpen();                            ///< asks for the path
  void requestOpen(std::filesystem::path path);  ///< recent file, drop, command line
  void requestSave();                            ///< asks for a path where there is none or a kept one (kept_files.hpp)
  void requestSaveAs();
  void requestQuit();

  [[nodiscard]] Prompt prompt() const { return m_prompt; }
  [[nodiscard]] const std::filesystem::path& pendingPath() const { return m_path; }
  void answerSaveChanges(SaveAnswer answer);
  /// Adds ".wind.json" to a save path that doesn't end in ".json".
  void answerPath(std::filesystem::path path);
  void answerOverwrite(bool overwrite);  ///< false: asks for another path
  void answerChanged(ChangedAnswer answer);
  void answerStopWork(bool stop);  ///< false: nothing happens
  void answerOutside(bool allow);  ///< true: remembered by onAllowOutside, and the project is opened again
  void cancel();                   ///< from any prompt; nothing happens

  /// A confirmed quit: the app may close its window.
  [[nodiscard]] bool quitConfirmed() const { return m_quit; }

  /// What runs beside the window and would be lost by quitting, such as "An export"; empty: nothing does.
  std::function<std::string()> workUnderWay;
  /// Whether the user allowed files outside the folder of this project file; unset: no.
  std::function<OutsideFiles(const std::filesystem::path&)> outsideFor;
  /// Called when the user allows them.
  std::function<void(const std::filesystem::path&)> onAllowOutside;
  /// Called after each finished operation: an Error to show, or a line such as "Saved meadow.wind.json".
  std::function<void(const Error&)> onFailure;
  std::function<void(const std::string&)> onDone;
  /// Called after another project was opened or started (selection, camera, recent files follow).
  std::function<void()> onReplaced;
  /// Called after a file was opened or written.
  std::function<void(const std::filesystem::path&)> onFileUsed;

 private:
  enum class Then { Nothing, New, Open, Quit };
  void begin(Then then);
  void askToSave();
  void proceed();
  void fail(const Error& error);
  void saveToOwnFile();
  void saveTo(const std::filesystem::path& path);

  Document& m_document;
  Prompt m_prompt = Prompt::None;
  Then m_then = Then::Nothing;
  std::optional<std::filesystem::path> m_openPath;
  std::filesystem::path m_path;
  Project m_start;
  bool m_quit = false;
};

}  // namespace windloom::editor
