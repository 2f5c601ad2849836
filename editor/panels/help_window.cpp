#include "editor/panels/help_window.hpp"

#include <algorithm>

#include "editor/core/help_page.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {

namespace {

void row(const HelpRow& entry) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", entry.what.c_str());
  if (!entry.help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.help.c_str());
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, look().palette.muted);
  ImGui::TextWrapped("%s", entry.keys.c_str());
  ImGui::PopStyleColor();
}

void drawSection(const HelpSection& section) {
  ImGui::Spacing();
  ImGui::PushFont(look().strong);
  ImGui::TextUnformatted(section.title.c_str());
  ImGui::PopFont();
  if (!ImGui::BeginTable(section.title.c_str(), 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchSame)) return;
  for (const HelpRow& entry : section.rows) row(entry);
  ImGui::EndTable();
}

}  // namespace

void drawHelpWindow(const ActionTable& actions, bool& open) {
  if (!open) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(scaled(620), size.x * 0.9f), std::min(scaled(640), size.y * 0.85f)},
                           ImGuiCond_Appearing);
  if (ImGui::Begin("Keys and mouse", &open, ImGuiWindowFlags_NoCollapse)) {
    for (const HelpSection& section : helpPage(actions)) drawSection(section);
    if (ImGui::IsWindowFocused() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) open = false;
  }
  ImGui::End();
}

}  // namespace windloom::editor
