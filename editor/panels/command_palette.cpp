#include "editor/panels/command_palette.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/widgets/look.hpp"

namespace windloom::editor {

namespace {

bool pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

}  // namespace

void CommandPalette::draw(ActionTable& actions) {
  if (!m_open) return;
  if (m_justOpened) {
    ImGui::OpenPopup("palette");
    m_text.clear();
    m_row = 0;
  }
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y * 0.14f}, ImGuiCond_Always, {0.5f, 0.0f});
  ImGui::SetNextWindowSize({std::min(scaled(520), size.x * 0.9f), std::min(scaled(420), size.y * 0.7f)});
  if (!ImGui::BeginPopup("palette", ImGuiWindowFlags_NoMove)) {
    m_open = false;
    return;
  }
  look().map.fact("dialog", "palette");
  if (m_justOpened) ImGui::SetKeyboardFocusHere();
  m_justOpened = false;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##search", "Type what you want to do", &m_text)) m_row = 0;
  markItem("palette/text");

  const std::vector<std::string> found = actions.search(m_text);
  if (pressed(ImGuiKey_DownArrow)) ++m_row;
  if (pressed(ImGuiKey_UpArrow)) --m_row;
  m_row = std::clamp(m_row, 0, std::max(0, int(found.size()) - 1));
  std::string chosen;
  if ((pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter)) && !found.empty()) chosen = found[std::size_t(m_row)];

  ImGui::BeginChild("results");
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Action* action = actions.find(found[i]);
    const bool current = int(i) == m_row;
    ImGui::PushID(int(i));
    if (ImGui::Selectable("##row", current)) chosen = found[i];
    ImGui::SameLine(scaled(4));
    ImGui::Text("%s", actions.label(found[i]).c_str());
    ImGui::SameLine(0, scaled(10));
    ImGui::TextDisabled("%s", action ? action->category.c_str() : "");
    const std::string shortcut = actions.shortcutText(found[i]);
    ImGui::SameLine(
        std::max(0.0f, ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(shortcut.c_str()).x - scaled(6)));
    ImGui::TextDisabled("%s", shortcut.c_str());
    if (current && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    ImGui::PopID();
  }
  ImGui::EndChild();

  if (!chosen.empty() || pressed(ImGuiKey_Escape)) {
    m_open = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (!chosen.empty()) actions.run(chosen);
}

}  // namespace windloom::editor
