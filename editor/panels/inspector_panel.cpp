#include "editor/panels/inspector_panel.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "editor/core/inspector.hpp"
#include "editor/core/object_kind.hpp"
#include "editor/panels/grass_panel.hpp"
#include "editor/panels/tool_options.hpp"
#include "editor/widgets/look.hpp"
#include "editor/widgets/parameter_row.hpp"
#include "engine/core/text.hpp"
#include "engine/wind/solver_presets.hpp"

namespace windloom::editor {

namespace {

const char* kindName(InspectorKind kind) {
  switch (kind) {
    case InspectorKind::Field:
      return "field";
    case InspectorKind::Solver:
      return "solver";
    case InspectorKind::Ambient:
      return "ambient";
    case InspectorKind::Terrain:
      return "terrain";
    case InspectorKind::Grass:
      return "grass";
    case InspectorKind::Bezier:
      return "bezier";
    case InspectorKind::Shell:
      return "shell";
    case InspectorKind::Point:
      return "point";
    case InspectorKind::Arrow:
      return "arrow";
    case InspectorKind::Signal:
      return "signal";
    case InspectorKind::Obstacle:
      return "obstacle";
    case InspectorKind::Species:
      return "species";
    case InspectorKind::Collider:
      return "collider";
    case InspectorKind::Surface:
      return "surface";
    case InspectorKind::Rotor:
      return "rotor";
    case InspectorKind::Probe:
      return "probe";
    case InspectorKind::Camera:
      return "camera";
  }
  return "";
}

void apply(PanelContext& context, const InspectorSection& section, const InspectorRow& row, const RowChange& change) {
  Workspace& workspace = context.workspace;
  const Project& project = workspace.document.committed();
  switch (change.kind) {
    case RowChange::Kind::Value:
      workspace.apply(setParameter(project, section.target, row.info.key, change.value));
      break;
    case RowChange::Kind::Component:
      workspace.apply(setComponent(project, section.target, row.info.key, change.component, change.number));
      break;
    case RowChange::Kind::Reset:
      workspace.apply(resetParameter(project, section.target, row.info.key));
      break;
    case RowChange::Kind::Problem:
      workspace.say(MessageKind::Error, change.problem);
      break;
  }
  if (change.finished) workspace.document.seal();
}

/// What an arrow's strength is measured in depends on its drive.
std::string_view strengthUnit(const InspectorSection& section) {
  for (const InspectorRow& row : section.rows)
    if (row.info.key == "drive" && !row.mixed) return std::get<int>(row.value) == int(Drive::Speed) ? "m/s" : "m/s^2";
  return "";
}

/// Where the section's things may have a file.
std::optional<AssetTarget> assetTargetOf(const InspectorSection& section) {
  if (section.target.kind == InspectorKind::Species) return AssetTarget{AssetUse::Species, section.target.ids};
  if (section.target.kind == InspectorKind::Collider) return AssetTarget{AssetUse::Collider, section.target.ids};
  if (section.target.kind == InspectorKind::Surface) return AssetTarget{AssetUse::Surface, section.target.ids};
  return std::nullopt;
}

bool asksForMesh(const InspectorRow& row, const RowChange& change) {
  if (row.info.key != "shape" || change.kind != RowChange::Kind::Value) return false;
  return row.info.choices[static_cast<std::size_t>(std::get<int>(change.value))] == "mesh";
}

/// Whether the shape mesh has to wait for a file, which is then read or chosen. Each thing may have one from before.
bool waitsForFile(PanelContext& context, const AssetTarget& target, AssetChooser& assets) {
  Workspace& workspace = context.workspace;
  const Project& project = workspace.document.committed();
  const auto ready = [&](Id id) {
    const AssetTarget one{target.use, {id}};
    return !assetFileOf(project, one).empty() && isAssetRead(project, one);
  };
  if (std::ranges::all_of(target.ids, ready)) return false;
  const std::string file = assetFileOf(project, target);
  if (target.ids.size() == 1 && !file.empty()) {
    if (const auto own = workspace.ownFile(file)) workspace.loadAsset(target, *own);
  } else {
    assets.browse(workspace, target);
  }
  return true;
}

/// How far and how long it moves; the keys themselves come with the project file.
void drawWay(const Project& project, const InspectorSection& section) {
  const Collider* collider = section.target.ids.size() == 1 ? findCollider(project, section.target.ids[0]) : nullptr;
  if (!collider || collider->keys.empty()) return;
  const double seconds = static_cast<double>(collider->keys.back().time - collider->keys.front().time);
  ImGui::TextDisabled("Moves along %zu keys in %s s", collider->keys.size(), fixed(seconds, 2).c_str());
}

void drawSection(PanelContext& context, const InspectorSection& section, AssetChooser& assets) {
  const std::string prefix = std::string("inspector/") + kindName(section.target.kind);
  const std::optional<AssetTarget> asset = assetTargetOf(section);
  if (!beginRows(prefix.c_str())) return;
  for (InspectorRow row : section.rows) {
    if (row.info.key == "id") continue;  // the title says it
    if (section.target.kind == InspectorKind::Arrow && row.info.key == "strength")
      row.info.unit = strengthUnit(section);
    // Shapes of plants, colliders and surfaces differ in most of what they have.
    if (asset && !row.relevant) continue;
    if (asset && row.info.key == "file") {
      assets.drawRow(context, row, prefix, *asset);
      continue;
    }
    const auto change = parameterRow(row, prefix);
    if (!change) continue;
    if (asset && asksForMesh(row, *change) && waitsForFile(context, *asset, assets)) continue;
    apply(context, section, row, *change);
  }
  endRows();
  if (section.target.kind == InspectorKind::Collider) drawWay(context.project(), section);
}

void drawSelection(PanelContext& context, AssetChooser& assets) {
  const auto ids = context.workspace.selection.ids();
  if (ids.empty()) {
    ImGui::Spacing();
    ImGui::TextDisabled("Nothing is selected.");
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled(
        "Click an arrow, a point, an obstacle, a collider, a surface or a rotor; Shift adds, Ctrl toggles, dragging on "
        "empty ground "
        "selects a box.");
    ImGui::PopTextWrapPos();
    return;
  }
  for (const InspectorSection& section : inspectSelection(context.project(), ids)) {
    ImGui::PushFont(look().strong);
    const bool open = ImGui::CollapsingHeader(section.title.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopFont();
    if (open) drawSection(context, section, assets);
  }
}

/// Named sets of solver settings; the action table has one action each.
void drawSolverPresets(PanelContext& context) {
  ActionTable& actions = context.workspace.actions;
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("Preset");
  for (const SolverPreset& preset : solverPresets()) {
    const std::string action = "solver." + std::string(preset.name);
    const bool on = actions.checked(action);
    ImGui::SameLine(0, scaled(6));
    if (on) ImGui::PushStyleColor(ImGuiCol_Button, look().palette.accentDim);
    const bool pressed = ImGui::Button(std::string(preset.name).c_str());
    if (on) ImGui::PopStyleColor();
    markItem("inspector/solver/preset/" + std::string(preset.name));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(preset.help).c_str());
    if (pressed) actions.run(action);
  }
  ImGui::Separator();
}

void drawSettings(PanelContext& context, InspectorKind kind, TerrainPanel& terrain, AssetChooser& assets) {
  const auto take = [&](const InspectorSection& section, const InspectorRow& row, const RowChange& change) {
    apply(context, section, row, change);
  };
  if (kind == InspectorKind::Terrain) return terrain.draw(context, take);
  if (kind == InspectorKind::Grass) return drawGrass(context, assets, take);
  if (kind == InspectorKind::Solver) drawSolverPresets(context);
  drawSection(context, inspect(context.project(), {kind, {}}), assets);
}

struct Tab {
  const char* label;
  std::optional<InspectorKind> settings;  // none: Selection, Export
};

constexpr Tab kTabs[] = {{"Selection", {}},
                         {"Field", InspectorKind::Field},
                         {"Solver", InspectorKind::Solver},
                         {"Ambient", InspectorKind::Ambient},
                         {"Grass", InspectorKind::Grass},
                         {"Terrain", InspectorKind::Terrain},
                         {"Export", {}}};
constexpr std::size_t kSelectionTab = 0, kExportTab = std::size(kTabs) - 1;

/// Tabs that flow into a second row where the panel is narrow, so that none is ever out of sight.
void drawTabs(std::size_t& current) {
  const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(6), scaled(3)));
  for (std::size_t i = 0; i < std::size(kTabs); ++i) {
    const float width = ImGui::CalcTextSize(kTabs[i].label).x + scaled(12);
    if (i > 0) {
      ImGui::SameLine(0, scaled(3));
      if (ImGui::GetCursorPosX() + width > right) ImGui::NewLine();
    }
    const bool on = i == current;
    ImGui::PushStyleColor(ImGuiCol_Button, on ? look().palette.accentDim : ImVec4(0, 0, 0, 0));
    if (ImGui::Button(kTabs[i].label)) current = i;
    ImGui::PopStyleColor();
    markItem(std::string("inspector/tab/") + kTabs[i].label);
  }
  ImGui::PopStyleVar();
  ImGui::Separator();
}

}  // namespace

void InspectorPanel::draw(PanelContext& context, ExportPanel& exporter) {
  exporter.poll(context);
  if (exporter.takeShow()) m_tab = kExportTab;
  drawTabs(m_tab);
  ImGui::BeginChild(kTabs[m_tab].label);
  if (m_tab == kSelectionTab) {
    drawToolOptions(context);
    drawSelection(context, m_assets);
  } else if (m_tab == kExportTab)
    exporter.draw(context);
  else
    drawSettings(context, *kTabs[m_tab].settings, m_terrain, m_assets);
  ImGui::EndChild();
  m_assets.draw(context.workspace);
}

}  // namespace windloom::editor
