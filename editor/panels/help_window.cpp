#include "editor/panels/help_window.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "editor/widgets/look.hpp"

namespace windloom::editor {

namespace {

struct Gesture {
  const char *keys, *what;
};

// What the mouse does isn't an action; see Navigator and the tools.
constexpr Gesture kMouse[] = {
    {"Middle button, or Alt + left", "Orbit"},
    {"Shift + middle, or Alt + middle", "Pan"},
    {"Wheel, or Alt + right", "Zoom to the cursor"},
    {"Right button + W A S D Q E", "Fly; wheel changes the speed, Shift is fast"},
    {"Left on empty ground, drag", "Box select; Shift adds, Ctrl toggles"},
    {"Click again at the same place", "Selects the next thing that overlaps there"},
    {"Ctrl + click on an arrow", "Insert a point"},
    {"X, Z while dragging", "Lock the axis; type a number and Enter for an exact distance"},
    {"Esc or right button while dragging", "Cancel"},
    {"Drag a number", "Changes it; Ctrl fine, Shift coarse, click to type, right click resets"},
};

void row(const char* keys, const char* what, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", what);
  if (help[0] != 0 && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, look().palette.muted);
  ImGui::TextWrapped("%s", keys);
  ImGui::PopStyleColor();
}

bool beginSection(const std::string& title) {
  ImGui::Spacing();
  ImGui::PushFont(look().strong);
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  return ImGui::BeginTable(title.c_str(), 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchSame);
}

void drawActions(const ActionTable& actions) {
  std::vector<std::string> categories;
  for (const Action& action : actions.all())
    if (std::find(categories.begin(), categories.end(), action.category) == categories.end())
      categories.push_back(action.category);
  for (const std::string& category : categories) {
    if (!beginSection(category)) continue;
    for (const Action& action : actions.all()) {
      if (action.category != category || action.shortcuts.empty()) continue;
      std::string keys;
      for (const Shortcut& shortcut : action.shortcuts) keys += (keys.empty() ? "" : ",  ") + toText(shortcut);
      row(keys.c_str(), action.label.c_str(), action.help.c_str());
    }
    ImGui::EndTable();
  }
}

}  // namespace

void drawHelpWindow(const ActionTable& actions, bool& open) {
  if (!open) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(scaled(620), size.x * 0.9f), std::min(scaled(640), size.y * 0.85f)},
                           ImGuiCond_Appearing);
  if (ImGui::Begin("Keys and mouse", &open, ImGuiWindowFlags_NoCollapse)) {
    if (beginSection("Mouse")) {
      for (const Gesture& gesture : kMouse) row(gesture.keys, gesture.what, "");
      ImGui::EndTable();
    }
    drawActions(actions);
    if (ImGui::IsWindowFocused() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) open = false;
  }
  ImGui::End();
}

}  // namespace windloom::editor
