#include "editor/panels/history_panel.hpp"

#include "editor/widgets/look.hpp"

namespace windloom::editor {

void drawHistoryPanel(PanelContext& context) {
  const History& history = context.workspace.document.history();
  ImGui::BeginChild("history");
  std::size_t target = history.position();
  ImGuiListClipper clipper;
  clipper.Begin(int(history.entries().size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto index = std::size_t(i);
      ImGui::PushID(i);
      // What can only be redone is dimmed.
      ImGui::PushStyleColor(ImGuiCol_Text, index > history.position() ? look().palette.muted : look().palette.text);
      if (ImGui::Selectable(history.entries()[index].label.c_str(), index == history.position())) target = index;
      ImGui::PopStyleColor();
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
  if (target != history.position()) context.workspace.jumpTo(target);
}

}  // namespace windloom::editor
