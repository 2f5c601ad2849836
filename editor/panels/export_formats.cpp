#include "editor/panels/export_formats.hpp"

#include <string>

#include "editor/core/size_text.hpp"
#include "editor/widgets/icons.hpp"
#include "editor/widgets/parameter_row.hpp"

namespace windloom::editor {
namespace {

/// Below this width the groups' names don't stand beside the formats but above them.
constexpr float kBesideWidth = 270;

void rightAligned(const std::string& text) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  if (room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
  ImGui::TextDisabled("%s", text.c_str());
}

/// At the right; with a sign for "about" where the words don't fit.
void drawSize(const ExportSize& size) {
  const std::string full = sizeText(size);
  const bool fits = ImGui::CalcTextSize(full.c_str()).x <= ImGui::GetContentRegionAvail().x;
  rightAligned(fits || size.exact ? full : std::string("~").append(bytesText(size.bytes)));
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
  const ExportSize size = there ? sizeOf(kind, header, request) : ExportSize{};
  if (there)
    drawSize(size);
  else
    rightAligned("missing");
  look().map.fact("export.size." + name, there ? sizeText(size) : "missing");
  look().map.fact("export.format." + name, on ? "yes" : "no");
}

/// The formats of a group, whose name stands before the first.
void drawGroup(std::string_view group, bool beside, ExportChoices& choices, const BakeHeader& header,
               const BakeRequest& request) {
  bool first = true;
  for (const WriterKind& kind : writerKinds()) {
    if (kind.group != group) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (beside || first) {
      ImGui::AlignTextToFramePadding();
      if (first) ImGui::TextDisabled("%s", std::string(group).c_str());
      if (!beside) ImGui::TableNextRow();
      ImGui::TableNextColumn();
    }
    first = false;
    drawFormat(kind, choices, header, request);
  }
}

void drawTable(ExportChoices& choices, const BakeHeader& header, const BakeRequest& request) {
  const bool beside = ImGui::GetContentRegionAvail().x > scaled(kBesideWidth);
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_NoSavedSettings;
  if (!ImGui::BeginTable(beside ? "formats" : "narrow formats", beside ? 3 : 2, kFlags)) return;
  if (beside) ImGui::TableSetupColumn("group");
  ImGui::TableSetupColumn("format");
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthStretch);
  for (const std::string_view group : formatGroups()) drawGroup(group, beside, choices, header, request);
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

void drawFormatWarnings(std::span<const std::string> warnings) {
  std::string all;
  ImGui::PushStyleColor(ImGuiCol_Text, look().palette.warning);
  for (const std::string& warning : warnings) {
    ImGui::TextUnformatted(icons::icon(icons::kWarning, "!"));
    ImGui::SameLine(0, scaled(6));
    ImGui::TextWrapped("%s", warning.c_str());
    all.append(all.empty() ? "" : "; ").append(warning);
  }
  ImGui::PopStyleColor();
  look().map.fact("export.warnings", all);
}

void drawWarningSign(std::span<const std::string> warnings) {
  if (warnings.empty()) return;
  std::string sign = icons::icon(icons::kWarning, "!"), all;
  sign.append(" ").append(std::to_string(warnings.size())).append(warnings.size() == 1 ? " warning" : " warnings");
  for (const std::string& warning : warnings) all.append(all.empty() ? "" : "\n").append(warning);
  ImGui::TextColored(look().palette.warning, "%s", sign.c_str());
  if (ImGui::IsItemHovered()) wrappedTooltip(all);
  markItem("export/warnings");
}

}  // namespace windloom::editor
