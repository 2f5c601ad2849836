#include "editor/panels/terrain_panel.hpp"

#include <imgui.h>

#include "editor/widgets/look.hpp"
#include "engine/core/text.hpp"
#include "engine/io/terrain_file.hpp"

namespace windloom::editor {
namespace {

constexpr const char* kPrefix = "inspector/terrain";

std::filesystem::path fileOf(const Workspace& workspace) {
  return workspace.document.path().parent_path() / workspace.document.committed().terrain->file;
}

}  // namespace

void TerrainPanel::browse(PanelContext& context) {
  Workspace& workspace = context.workspace;
  if (!workspace.mayLoadTerrain()) return;
  m_browser.open(FileBrowser::Purpose::Open, "Choose a height map or a mesh", fileOf(workspace), ".png;.glb;.gltf");
}

void TerrainPanel::chooseKind(PanelContext& context, TerrainKind kind) {
  Workspace& workspace = context.workspace;
  TerrainSettings terrain = *workspace.document.committed().terrain;
  if (kind == terrain.kind) return;
  if (kind == TerrainKind::Flat) {
    workspace.terrainLoad.cancel();
    terrain.kind = kind;
    workspace.apply(Edit{.label = "Set terrain", .steps = {Set<TerrainSettings>{std::move(terrain)}}, .mergeKey = {}});
  } else if (!terrain.file.empty() && terrainKindOf(terrain.file) == kind) {
    if (const auto file = workspace.ownFile(terrain.file)) workspace.loadTerrain(*file);
  } else {
    browse(context);
  }
}

void TerrainPanel::drawFile(PanelContext& context, const InspectorRow& row) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("File");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(row.info.help).c_str());
  ImGui::TableNextColumn();
  if (ImGui::Button("Browse...")) browse(context);
  markItem("inspector/terrain/browse");
  const std::string& file = context.project().terrain->file;
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", file.empty() ? "none" : std::filesystem::path(file).filename().string().c_str());
  if (!file.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", file.c_str());
}

/// What is going on below the rows.
void TerrainPanel::drawState(PanelContext& context) {
  Workspace& workspace = context.workspace;
  const TerrainSettings& terrain = *context.project().terrain;
  ImGui::Spacing();
  if (workspace.terrainLoad.running()) {
    ImGui::TextUnformatted((workspace.terrainLoad.doing() + " ...").c_str());
    if (ImGui::Button("Cancel")) {
      workspace.terrainLoad.cancel();
      workspace.say(MessageKind::Info, "The ground stays as it was");
    }
    markItem("inspector/terrain/cancel");
    return;
  }
  ImGui::PushTextWrapPos(0);
  if (terrain.heights) {
    const HeightField& field = *terrain.heights;
    const HeightSource& source = *field.source;
    const std::string from =
        source.triangles > 0 ? std::to_string(source.triangles) + " triangles"
                             : std::to_string(source.pixels.x) + " x " + std::to_string(source.pixels.y) + " pixels";
    ImGui::TextDisabled("%s, %s x %s m, %s to %s m high", from.c_str(), fixed(double(field.size.x), 1).c_str(),
                        fixed(double(field.size.y), 1).c_str(), fixed(double(field.lowest()), 1).c_str(),
                        fixed(double(field.highest()), 1).c_str());
  } else if (terrain.kind != TerrainKind::Flat) {
    ImGui::TextColored(look().palette.warning,
                       "%s can't be read: the ground is shown flat. The project keeps its name.", terrain.file.c_str());
    if (ImGui::Button("Try again")) {
      if (const auto file = workspace.ownFile(terrain.file)) workspace.loadTerrain(*file);
    }
    markItem("inspector/terrain/again");
  } else {
    ImGui::TextDisabled(
        "Browse for a grey PNG (16 bit is best) or a glTF mesh, or drop one on the window. The wind is "
        "two-dimensional and doesn't depend on the ground.");
  }
  ImGui::PopTextWrapPos();
}

void TerrainPanel::draw(PanelContext& context, const Apply& apply) {
  const InspectorSection section = inspect(context.project(), {InspectorKind::Terrain, {}});
  if (beginRows(kPrefix)) {
    for (const InspectorRow& row : section.rows) {
      if (row.info.key == "file") {
        drawFile(context, row);
        continue;
      }
      const auto change = parameterRow(row, kPrefix);
      if (!change) continue;
      if (row.info.key != "kind") {
        apply(section, row, *change);
      } else if (change->kind == RowChange::Kind::Value) {
        chooseKind(context, static_cast<TerrainKind>(std::get<int>(change->value)));
      } else if (change->kind == RowChange::Kind::Reset) {
        chooseKind(context, TerrainKind::Flat);
      }
    }
    endRows();
  }
  drawState(context);
  if (m_browser.isOpen()) look().map.fact("dialog", "terrain");
  if (const auto chosen = m_browser.draw()) context.workspace.loadTerrain(*chosen);
}

}  // namespace windloom::editor
