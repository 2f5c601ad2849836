#include "editor/widgets/file_browser.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "editor/widgets/icons.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {

namespace fs = std::filesystem;

namespace {

bool endsWithAny(std::string name, const std::string& suffixes) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  for (std::size_t start = 0; start <= suffixes.size();) {
    const std::size_t end = std::min(suffixes.find(';', start), suffixes.size());
    if (name.ends_with(suffixes.substr(start, end - start))) return true;
    start = end + 1;
  }
  return false;
}

}  // namespace

void FileBrowser::open(Purpose purpose, std::string title, const fs::path& start, std::string suffix) {
  m_purpose = purpose;
  m_title = std::move(title);
  m_suffix = std::move(suffix);
  m_name = start.filename().string();
  m_open = m_justOpened = true;
  std::error_code failed;
  fs::path folder = fs::absolute(start.has_parent_path() ? start.parent_path() : fs::path("."), failed);
  while (!fs::is_directory(folder, failed) && folder.has_relative_path()) folder = folder.parent_path();
  enter(folder);
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code failed;
  std::vector<Entry> entries;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const std::string name = it->path().filename().string();
    std::error_code ignored;
    const bool isFolder = it->is_directory(ignored);
    if (!name.starts_with('.') && (isFolder || endsWithAny(name, m_suffix))) entries.push_back({name, isFolder});
  }
  if (failed) {
    m_problem = folder.string() + ": " + failed.message();
    return;
  }
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
  m_entries = std::move(entries);
  m_folder = folder.lexically_normal();
  m_pathText = m_folder.string();
  m_problem.clear();
}

std::optional<fs::path> FileBrowser::accept() {
  if (m_name.empty()) return std::nullopt;
  fs::path path = m_folder / m_name;  // an absolute name replaces the folder
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    enter(path);
    m_name.clear();
    return std::nullopt;
  }
  if (m_purpose == Purpose::Open && !fs::exists(path, ignored)) {
    m_problem = path.string() + ": no such file";
    return std::nullopt;
  }
  m_open = false;
  ImGui::CloseCurrentPopup();
  return path;
}

void FileBrowser::drawPlaces() {
  using namespace icons;
  if (ImGui::Button(icon(kUp, "Up"))) enter(m_folder.parent_path());
  ImGui::SameLine();
  if (ImGui::Button(icon(kHome, "Home"))) {
    const char* home = std::getenv("HOME");
    enter(home ? home : "/");
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##folder", &m_pathText, ImGuiInputTextFlags_EnterReturnsTrue)) enter(fs::path(m_pathText));
  markItem("files/folder");
}

std::optional<fs::path> FileBrowser::drawList(float height) {
  std::optional<fs::path> chosen;
  std::string entered;
  ImGui::BeginChild("list", {0, height}, true);
  for (const Entry& entry : m_entries) {
    const std::string label =
        std::string(entry.folder ? icons::icon(icons::kFolder, "[dir]") : icons::icon(icons::kFile, " ")) + "  " +
        entry.name;
    if (ImGui::Selectable(label.c_str(), !entry.folder && entry.name == m_name,
                          ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups)) {
      const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      if (!entry.folder) {
        m_name = entry.name;
        if (twice) chosen = accept();
      } else if (twice) {
        entered = entry.name;
      }
    }
  }
  if (m_entries.empty()) ImGui::TextDisabled("No folders and no *%s here.", m_suffix.c_str());
  ImGui::EndChild();
  if (!entered.empty()) enter(m_folder / entered);
  return chosen;
}

std::optional<fs::path> FileBrowser::draw() {
  if (!m_open) return std::nullopt;
  if (m_justOpened) ImGui::OpenPopup(m_title.c_str());
  ImGui::SetNextWindowSize({scaled(640), scaled(460)}, ImGuiCond_Appearing);
  bool keep = true;
  if (!ImGui::BeginPopupModal(m_title.c_str(), &keep)) {
    m_open = false;
    return std::nullopt;
  }
  drawPlaces();
  const float bottom = ImGui::GetFrameHeightWithSpacing() * 2 + ImGui::GetTextLineHeightWithSpacing();
  std::optional<fs::path> chosen = drawList(ImGui::GetContentRegionAvail().y - bottom);

  if (m_justOpened) ImGui::SetKeyboardFocusHere();
  m_justOpened = false;
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputText("##name", &m_name, ImGuiInputTextFlags_EnterReturnsTrue);
  markItem("files/name");
  ImGui::TextColored(look().palette.warning, "%s", m_problem.c_str());
  const char* label = m_purpose == Purpose::Open ? "Open" : "Save";
  if (ImGui::Button(label, {scaled(96), 0}) || entered) chosen = chosen ? chosen : accept();
  markItem("files/accept");
  ImGui::SameLine();
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) && !ImGui::IsAnyItemActive();
  if (ImGui::Button("Cancel", {scaled(96), 0}) || !keep || escaped) {
    m_open = false;
    ImGui::CloseCurrentPopup();
  }
  markItem("files/cancel");
  ImGui::EndPopup();
  return chosen;
}

}  // namespace windloom::editor
