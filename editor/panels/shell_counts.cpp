#include "editor/panels/shell_counts.hpp"

#include <imgui.h>

#include <string>

#include "editor/widgets/look.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

/// `name` is the fact's, "shell count.NAME".
void row(const char* label, const char* name, const std::string& value, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(label);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", value.c_str());
  look().map.fact(std::string("shell count.") + name, value);
}

}  // namespace

void drawShellCounts(PanelContext& context) {
  const ShellCounts counts = context.session ? context.session->status().frame.shell : ShellCounts{};
  if (!ImGui::BeginTable("shell counts", 2, ImGuiTableFlags_SizingStretchProp)) return;
  row("Shells near the camera", "shells", std::to_string(counts.nearShells),
      "Layers over the ground nearest to the camera.");
  row("Tiles in sight", "tiles", std::to_string(counts.tiles), "Pieces of the ground in sight that grass stands on.");
  row("Layers drawn", "layers", std::to_string(counts.layers), "Pieces of shells, all drawn at once.");
  row("Layers left out", "skipped", std::to_string(counts.skippedLayers), "Pieces of shells that no blade reaches.");
  const double percent = 100.0 * static_cast<double>(counts.error);
  row("Largest error", "error", fixed(percent, 2) + "% of the height",
      "How far shells are off from the bent blades between them at most. More shells make it smaller.");
  ImGui::EndTable();
}

}  // namespace windloom::editor
