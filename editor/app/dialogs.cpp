#include "editor/app/dialogs.hpp"

#include <cstdlib>
#include <initializer_list>
#include <vector>

#include "editor/core/kept_files.hpp"
#include "editor/widgets/icons.hpp"
#include "engine/core/log.hpp"

namespace windloom::editor {

namespace {

bool pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false);
}

/// Begins a message box in the middle of the window. Its content follows where it gave true.
bool beginBox(const char* title, const char* fact) {
  look().map.fact("dialog", fact);
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({scaled(360), 0}, {size.x * 0.8f, size.y * 0.8f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(scaled(16), scaled(14)));
  const bool shown = ImGui::BeginPopupModal(
      title, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  return shown;
}

/// A row of buttons; the index of the chosen one, -1: none yet. Enter takes the first, Esc the last unless told
/// otherwise.
int buttonRow(std::initializer_list<const char*> labels, int onEscape = -1) {
  int chosen = -1, index = 0;
  ImGui::Spacing();
  for (const char* label : labels) {
    if (index > 0) ImGui::SameLine();
    const bool first = index == 0;
    if (first) ImGui::PushStyleColor(ImGuiCol_Button, look().palette.accentDim);
    if (ImGui::Button(label, {std::max(scaled(96), ImGui::CalcTextSize(label).x + scaled(24)), 0})) chosen = index;
    if (first) ImGui::PopStyleColor();
    markItem(std::string("dialog/") + label);
    ++index;
  }
  if (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) chosen = 0;
  if (pressed(ImGuiKey_Escape)) chosen = onEscape >= 0 ? onEscape : index - 1;
  if (chosen >= 0) ImGui::CloseCurrentPopup();
  return chosen;
}

void wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(scaled(560));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace

bool Dialogs::open() const {
  return !m_errors.empty() || !m_rescues.empty() || m_browser.isOpen() || m_workspace.flow.prompt() != Prompt::None;
}

void Dialogs::drawError() {
  if (!beginBox("Windloom##error", "error")) return;
  look().map.fact("dialog.text", m_errors.front());
  ImGui::TextColored(look().palette.error, "%s", icons::icon(icons::kError, "!"));
  ImGui::SameLine();
  ImGui::BeginGroup();
  wrapped(m_errors.front());
  ImGui::EndGroup();
  ImGui::Spacing();
  const int chosen = buttonRow({"OK"});
  ImGui::SameLine();
  if (ImGui::Button("Copy text")) ImGui::SetClipboardText(m_errors.front().c_str());
  if (chosen >= 0) m_errors.pop_front();
  ImGui::EndPopup();
}

void Dialogs::drawSaveChanges() {
  if (!beginBox("Save changes?", "save changes")) return;
  const std::string path = m_workspace.document.path().filename().string();
  wrapped("Save the changes to " + (path.empty() ? m_workspace.document.committed().name : path) + "?");
  switch (buttonRow({"Save", "Don't save", "Cancel"})) {
    case 0:
      m_workspace.flow.answerSaveChanges(SaveAnswer::Save);
      break;
    case 1:
      m_workspace.flow.answerSaveChanges(SaveAnswer::DontSave);
      break;
    case 2:
      m_workspace.flow.answerSaveChanges(SaveAnswer::Cancel);
      break;
    default:
      break;
  }
  ImGui::EndPopup();
}

void Dialogs::drawOverwrite() {
  if (!beginBox("Replace the file?", "overwrite")) return;
  wrapped(m_workspace.flow.pendingPath().string() + " exists already.");
  const int chosen = buttonRow({"Another name", "Replace", "Cancel"});
  if (chosen == 2)
    m_workspace.flow.cancel();
  else if (chosen >= 0)
    m_workspace.flow.answerOverwrite(chosen == 1);
  ImGui::EndPopup();
}

void Dialogs::drawChanged() {
  if (!beginBox("Replace the newer file?", "changed on disk")) return;
  const std::string name = m_workspace.document.path().filename().string();
  wrapped("Another program has changed " + name +
          " since it was opened here. Saving replaces those changes; the file as it "
          "is now stays as " +
          name + ".bak.");
  const int chosen = buttonRow({"Save under another name", "Replace", "Cancel"});
  if (chosen == 0) m_workspace.flow.answerChanged(ChangedAnswer::AnotherName);
  if (chosen == 1) m_workspace.flow.answerChanged(ChangedAnswer::Replace);
  if (chosen == 2) m_workspace.flow.answerChanged(ChangedAnswer::Cancel);
  ImGui::EndPopup();
}

void Dialogs::drawStopWork() {
  if (!beginBox("Quit?", "stop work")) return;
  wrapped(m_workspace.flow.workUnderWay() + " is still running. Quitting stops it; nothing of it is kept.");
  const int chosen = buttonRow({"Keep running", "Stop and quit"}, 0);
  if (chosen >= 0) m_workspace.flow.answerStopWork(chosen == 1);
  ImGui::EndPopup();
}

void Dialogs::drawOutside() {
  if (!beginBox("Files outside the project's folder", "outside")) return;
  std::string files;
  for (const Problem& problem : m_workspace.document.missing())
    files += problem.pointer + ": " + problem.message + "\n";
  look().map.fact("dialog.text", files);
  wrapped(files);
  std::error_code ignored;
  wrapped(
      "The project is shown without them, and keeps their names. A project can come from anyone: allow this only for "
      "one that you trust. It is remembered for the folder " +
      std::filesystem::absolute(m_workspace.document.path(), ignored).parent_path().string() +
      " and can be taken back in the File menu.");
  const int chosen = buttonRow({"Leave them out", "Read them"}, 0);
  if (chosen >= 0) m_workspace.flow.answerOutside(chosen == 1);
  ImGui::EndPopup();
}

void Dialogs::drawRescue() {
  const Rescue& rescue = m_rescues.front();
  if (!beginBox("Unsaved work was found", "rescue")) return;
  wrapped("The editor ended without closing " +
          (rescue.original.empty() ? std::string("a project that was never saved") : rescue.original.string()) +
          ". Its work as of " + rescue.savedAt + " is still there.");
  if (m_showChanges) {
    std::string all;
    for (const std::string& line : m_rescueChanges) {
      ImGui::BulletText("%s", line.c_str());
      all += line + "\n";
    }
    look().map.fact("dialog.text", all);
  }
  if (m_discarding)
    confirmDiscard();
  else
    askAboutRescue();
  ImGui::EndPopup();
}

void Dialogs::askAboutRescue() {
  const Rescue& rescue = m_rescues.front();
  switch (buttonRow({"Restore", "Show what changed", "Discard", "Later"})) {
    case 0:
      if (const Status status =
              restoreRescue(m_workspace.document, rescue, m_workspace.preferences.outsideFor(rescue.original));
          !status)
        showError(status.error().text());
      nextRescue();
      break;
    case 1:
      m_rescueChanges = describeRescue(rescue);
      m_showChanges = true;
      break;
    case 2:
      m_discarding = true;
      break;
    case 3:
      m_rescues.clear();
      break;
    default:
      break;
  }
}

void Dialogs::confirmDiscard() {
  wrapped("Discard it? Nothing brings it back.");
  const int chosen = buttonRow({"Keep it", "Discard for good"}, 0);
  if (chosen == 1) {
    discardRescue(m_rescues.front());
    nextRescue();
  }
  if (chosen >= 0) m_discarding = false;
}

void Dialogs::nextRescue() {
  m_rescues.erase(m_rescues.begin());
  m_showChanges = false;
}

std::filesystem::path Dialogs::startFolder() const {
  const bool saving = m_workspace.flow.prompt() == Prompt::ChooseSavePath;
  std::vector<std::filesystem::path> used = {m_workspace.document.path()};
  for (const std::string& file : m_workspace.preferences.recentFiles) used.emplace_back(file);
  for (const std::filesystem::path& file : used) {
    // Samples are opened from where nothing is saved to.
    if (!file.empty() && (!saving || whyKept(file).empty())) return file.parent_path() / "";
  }
  const char* home = std::getenv("HOME");
  if (saving && home) return std::filesystem::path(home) / "";
  std::error_code ignored;
  return std::filesystem::current_path(ignored) / "";
}

void Dialogs::followFileChoice() {
  const Prompt prompt = m_workspace.flow.prompt();
  const bool wanted = prompt == Prompt::ChooseOpenPath || prompt == Prompt::ChooseSavePath;
  if (!wanted) return m_browser.close();
  look().map.fact("dialog", prompt == Prompt::ChooseOpenPath ? "open" : "save as");
  if (!m_browser.isOpen()) {
    const bool opening = prompt == Prompt::ChooseOpenPath;
    std::string name;
    if (!opening)
      name = m_workspace.document.path().empty() ? m_workspace.document.committed().name + ".wind.json"
                                                 : m_workspace.document.path().filename().string();
    m_browser.open(opening ? FileBrowser::Purpose::Open : FileBrowser::Purpose::Save,
                   opening ? "Open a project" : "Save the project as", startFolder() / name, ".wind.json");
    m_why = opening ? std::string() : whyKept(m_workspace.document.path());
    m_browser.explain(m_why);
  }
  look().map.fact("dialog.text", m_why);
  const auto path = m_browser.draw();
  if (path)
    m_workspace.flow.answerPath(*path);
  else if (!m_browser.isOpen())
    m_workspace.flow.cancel();
}

void Dialogs::draw() {
  // One at a time: an error is read first, since it may be why a question came back.
  if (!m_errors.empty()) return drawError();
  if (!m_rescues.empty()) return drawRescue();
  switch (m_workspace.flow.prompt()) {
    case Prompt::SaveChanges:
      return drawSaveChanges();
    case Prompt::ConfirmOverwrite:
      return drawOverwrite();
    case Prompt::ConfirmChanged:
      return drawChanged();
    case Prompt::StopWork:
      return drawStopWork();
    case Prompt::OutsideFiles:
      return drawOutside();
    case Prompt::ChooseOpenPath:
    case Prompt::ChooseSavePath:
    case Prompt::None:
      break;
  }
  followFileChoice();
}

}  // namespace windloom::editor
