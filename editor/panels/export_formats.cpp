#include "editor/panels/export_formats.hpp"

#include <string>
#include <utility>

#include "editor/widgets/icons.hpp"
#include "editor/widgets/parameter_row.hpp"

namespace windloom::editor {
namespace {

void rightAligned(const std::string& text) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
  ImGui::TextDisabled("%s", text.c_str());
}

void drawFormat(const WriterKind& kind, ExportChoices& choices, const BakeHeader& header, const BakeRequest& request) {
  const std::string name(kind.name);
  const bool there = kind.missing.empty();
  bool on = there && choices.formats.contains(name);
  ImGui::BeginDisabled(!there);
  const bool toggled = ImGui::Checkbox(name.c_str(), &on);
  ImGui::EndDisabled();
  markItem("export/format/" + name);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) wrappedTooltip(there ? kind.help : kind.missing);
  if (toggled && on) choices.formats.insert(name);
  if (toggled && !on) choices.formats.erase(name);
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const std::string size = there ? sizeText(sizeOf(kind, header, request)) : "not in this build";
  rightAligned(size);
  look().map.fact("export.size." + name, size);
  look().map.fact("export.format." + name, on ? "yes" : "no");
}

/// The formats of a group, whose name stands before the first.
void drawGroup(std::string_view group, ExportChoices& choices, const BakeHeader& header, const BakeRequest& request) {
  bool first = true;
  for (const WriterKind& kind : writerKinds()) {
    if (kind.group != group) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (std::exchange(first, false)) ImGui::TextDisabled("%s", std::string(group).c_str());
    ImGui::TableNextColumn();
    drawFormat(kind, choices, header, request);
  }
}

void drawTable(ExportChoices& choices, const BakeHeader& header, const BakeRequest& request) {
  if (!ImGui::BeginTable("formats", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings)) return;
  ImGui::TableSetupColumn("group");
  ImGui::TableSetupColumn("format");
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthStretch);
  for (const std::string_view group : formatGroups()) drawGroup(group, choices, header, request);
  ImGui::EndTable();
}

}  // namespace

void drawFormats(ExportChoices& choices, const BakeHeader& header, const BakeRequest& request) {
  // Many formats, little room.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ImGui::GetStyle().FramePadding.x, scaled(1)));
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(ImGui::GetStyle().CellPadding.x, scaled(1)));
  drawTable(choices, header, request);
  ImGui::PopStyleVar(2);
}

void drawFormatWarnings(const BakeHeader& header, const BakeRequest& request) {
  std::string all;
  for (const WriterKind* kind : request.formats) {
    const std::string warning = kind->warning != nullptr ? kind->warning(header) : std::string();
    if (warning.empty()) continue;
    const std::string text = std::string(kind->name) + ": " + warning;
    ImGui::PushStyleColor(ImGuiCol_Text, look().palette.warning);
    ImGui::TextUnformatted(icons::icon(icons::kWarning, "!"));
    ImGui::SameLine(0, scaled(6));
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    markItem("export/warning/" + std::string(kind->name));
    all.append(all.empty() ? "" : "; ").append(text);
  }
  look().map.fact("export.warnings", all);
}

}  // namespace windloom::editor
