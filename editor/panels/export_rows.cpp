#include "editor/panels/export_rows.hpp"

#include <algorithm>

#include "editor/widgets/number_field.hpp"
#include "editor/widgets/parameter_row.hpp"

namespace windloom::editor {
namespace {

const ExportChoices kDefaults;

/// Draws the field in the width of the next item.
template <class Number>
void number(const char* name, Number& value, Number fallback, std::string_view unit, double step,
            const ChoiceRange& range) {
  constexpr bool kWhole = std::is_integral_v<Number>;
  const NumberEdit edit = numberField(name, double(value), false, {unit, range.min, range.max, step, kWhole});
  if (edit.changed) value = Number(std::clamp(edit.value, range.min, range.max));
  if (edit.reset) value = fallback;
}

void check(const char* name, bool& on) {
  ImGui::PushID(name);
  ImGui::Checkbox("##on", &on);
  ImGui::PopID();
  markItem(name);
  look().map.fact(name, on ? "yes" : "no");
}

/// Two or so words of which one holds.
void either(const char* name, const char* off, const char* set, bool& on) {
  ImGui::PushID(name);
  if (ImGui::BeginCombo("##which", on ? set : off)) {
    for (const bool choice : {false, true}) {
      if (ImGui::Selectable(choice ? set : off, on == choice)) on = choice;
      markItem(std::string(name) + (choice ? "/on" : "/off"));
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  markItem(name);
  look().map.fact(name, on ? "yes" : "no");
}

void warmUpRows(ExportChoices& choices) {
  rowLabel("Warm-up", "How long the wind blows before the first frame: from the project's start on, or only so long.");
  either("export/own_warm_up", "from the start", "fixed", choices.ownWarmUp);
  if (!choices.ownWarmUp) return;
  rowLabel("", "");
  number("export/warm_up", choices.warmUp, kDefaults.warmUp, "s", 0.5, kWarmUpRange);
}

void resolutionRows(ExportChoices& choices, const Project& project) {
  const glm::ivec2 own = project.field->resolution;
  const std::string projects = "project's, " + std::to_string(own.x) + " x " + std::to_string(own.y);
  rowLabel("Resolution", "Cells of the written frames. The wind itself always runs on the project's grid.");
  either("export/own_resolution", projects.c_str(), "resampled", choices.ownResolution);
  if (!choices.ownResolution) return;
  rowLabel("", "");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  ImGui::SetNextItemWidth(width);
  number("export/width", choices.resolution.x, kDefaults.resolution.x, "", 8, kSideRange);
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(width);
  number("export/height", choices.resolution.y, kDefaults.resolution.y, "", 8, kSideRange);
}

void heightRows(ExportChoices& choices) {
  rowLabel("Height layers", "Of volumes, evenly spaced from the ground up.");
  number("export/layers", choices.layers, kDefaults.layers, "", 1, kLayersRange);
  rowLabel("Top", "Height of a volume.");
  number("export/top", choices.top, kDefaults.top, "m", 0.5, kTopRange);
  rowLabel("Drawn at", "The height in which the wind is as drawn; it is slower below and faster above (log law).");
  number("export/reference", choices.reference, kDefaults.reference, "m", 0.1, kReferenceRange);
  rowLabel("Roughness", "Roughness length of the ground: 0.03 m grass, 0.1 m crops, 1 m forest.");
  number("export/roughness", choices.roughness, kDefaults.roughness, "m", 0.01, kRoughnessRange);
}

void fullScaleRows(ExportChoices& choices) {
  rowLabel("Full scale", "The speed that the greatest code of formats of 8 or 16 bits stands for.");
  either("export/own_full_scale", "fastest wind", "fixed", choices.ownFullScale);
  if (!choices.ownFullScale) return;
  rowLabel("", "");
  number("export/full_scale", choices.fullScale, kDefaults.fullScale, "m/s", 0.5, kFullScaleRange);
}

}  // namespace

void drawPresetRow(ExportChoices& choices) {
  rowLabel("For", "Axes, units and row order of the game engine. Choosing one proposes formats.");
  const Preset current = presetNamed(choices.preset).value_or(Preset::Generic);
  const bool open = ImGui::BeginCombo("##preset", std::string(rulesOf(current).name).c_str());
  markItem("export/preset");
  look().map.fact("export.preset", rulesOf(current).name);
  if (!open) return;
  for (const PresetRules& rules : presets()) {
    const std::string name(rules.name);
    if (ImGui::Selectable(name.c_str(), rules.preset == current)) {
      choices.preset = name;
      choices.formats.clear();
      for (const std::string_view format : proposedFormats(rules.preset)) choices.formats.emplace(format);
    }
    markItem("export/preset/" + name);
    if (ImGui::IsItemHovered()) wrappedTooltip(rules.help);
  }
  ImGui::EndCombo();
}

void drawRecordingRows(ExportChoices& choices, const Project& project) {
  rowLabel("From", "Time of the first frame.");
  number("export/from", choices.from, kDefaults.from, "s", 0.5, kFromRange);
  warmUpRows(choices);
  rowLabel("Length", "Length of the recording.");
  number("export/seconds", choices.seconds, kDefaults.seconds, "s", 0.5, kSecondsRange);
  rowLabel("Frame rate", "Frames a second. The game blends between them: 10 to 15 are enough for wind.");
  number("export/fps", choices.fps, kDefaults.fps, "1/s", 1, kFpsRange);
  rowLabel("Loop", "Blends the end into the beginning, so that it can play for ever.");
  check("export/loop", choices.loop);
  resolutionRows(choices, project);
}

void drawContentRows(ExportChoices& choices, const BakeRequest& request) {
  rowLabel(
      "Vectors",
      "Of images: speeds along the ground's axes, or texture coordinates a second for shaders that pan a texture.");
  either("export/uv_flow", "world speed", "UV flow", choices.uvFlow);
  if (hasFullScale(request)) fullScaleRows(choices);
  if (hasVolume(request)) heightRows(choices);
  rowLabel("Plants' lean",
           "Also how four kinds of plants lean in this wind, from soft grass to stiff trees: five times the files.");
  check("export/response", choices.response);
  rowLabel("Arrow graph", "Also the drawn trees as a glTF scene.");
  check("export/graph", choices.graph);
  rowLabel("Import help", "Also import settings, shader code and a how-to for the engine.");
  check("export/sidecars", choices.sidecars);
}

}  // namespace windloom::editor
