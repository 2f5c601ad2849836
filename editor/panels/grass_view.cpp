#include "editor/panels/grass_view.hpp"

#include <string>

#include "editor/widgets/look.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

std::string grouped(long long number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

void drawViews(ActionTable& actions) {
  const char* current = "";
  for (const GrassViewEntry& entry : kGrassViews)
    if (actions.checked(std::string("grass_view.") + entry.name)) current = entry.label;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Show");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(scaled(170));
  const bool open = ImGui::BeginCombo("##grass view", current);
  markItem("grass_view");
  if (!open) return;
  for (const GrassViewEntry& entry : kGrassViews) {
    const std::string action = std::string("grass_view.") + entry.name;
    if (ImGui::Selectable(entry.label, actions.checked(action))) actions.run(action);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.help);
    markItem(action);
  }
  ImGui::EndCombo();
}

/// What the colour in the view of what is left out means, at the end of a cell.
void swatch(const char* name, glm::vec3 colour) {
  ImGui::SameLine(0, scaled(8));
  ImGui::ColorButton(name, {colour.r, colour.g, colour.b, 1.0f},
                     ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop, {scaled(14), scaled(14)});
}

void drawTests(ActionTable& actions, const BezierCounts& counts) {
  const bool coloured = actions.checked("grass_view.culled");
  if (!ImGui::BeginTable("culling", 2, ImGuiTableFlags_SizingStretchProp)) return;
  const auto number = [](long long value) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", grouped(value).c_str());
  };
  for (const CullingEntry& entry : kCullingTests) {
    const std::string action = std::string("cull.") + entry.name;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    bool on = actions.checked(action);
    if (ImGui::Checkbox(entry.label, &on)) actions.run(action);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.help);
    markItem(action);
    if (coloured) swatch(entry.name, entry.colour);
    number(counts.*entry.count);
    look().map.fact(action, std::to_string(counts.*entry.count));
  }
  const auto sum = [&](const char* label, long long value, bool drawn = false) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    if (coloured && drawn) swatch(label, kDrawnColour);
    number(value);
    look().map.fact(std::string("grass count.") + label, std::to_string(value));
  };
  sum("Drawn", counts.drawn, true);
  sum("In the patches seen", counts.inPatches);
  sum("Patches seen", counts.patchesSeen);
  ImGui::EndTable();
}

}  // namespace

void drawGrassView(PanelContext& context) {
  ActionTable& actions = context.workspace.actions;
  drawViews(actions);
  ImGui::TextDisabled("Leave out blades that are");
  drawTests(actions, context.session ? context.session->status().frame.bezier : BezierCounts{});
}

}  // namespace windloom::editor
