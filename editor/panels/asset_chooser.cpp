#include "editor/panels/asset_chooser.hpp"

#include <imgui.h>

#include "editor/widgets/look.hpp"

namespace windloom::editor {
namespace {

std::filesystem::path pathOf(const Workspace& workspace, const std::string& file) {
  return workspace.document.path().parent_path() / file;
}

const char* titleOf(const AssetTarget& target) {
  switch (target.use) {
    case AssetUse::Species:
      return "Choose a plant";
    case AssetUse::Collider:
      return "Choose an object";
    case AssetUse::Surface:
      return "Choose a surface for grass";
    case AssetUse::DensityMap:
      return "Choose a density map";
    case AssetUse::HeightMap:
      return "Choose a height map of the grass";
    case AssetUse::ShellPicture:
      return "Choose a picture of blades from above";
    case AssetUse::ColourMap:
      break;
  }
  return "Choose a colour map";
}

bool sameTarget(const AssetTarget& a, const AssetTarget& b) {
  return a.use == b.use && a.ids == b.ids;
}

/// True where it was pressed.
bool smallButton(const char* label, const std::string& name) {
  const bool pressed = ImGui::Button(label);
  markItem(name);
  return pressed;
}

/// What there is to say below the file's name.
void drawState(Workspace& workspace, const std::string& file, const AssetTarget& target, const std::string& name) {
  if (isAssetRead(workspace.document.project(), target)) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(look().palette.warning, "can't be read: it is left out. The project keeps its name.");
  ImGui::PopTextWrapPos();
  if (!smallButton("Try again", name + "/again")) return;
  if (const auto own = workspace.ownFile(file)) workspace.loadAsset(target, *own);
}

}  // namespace

void AssetChooser::browse(Workspace& workspace, AssetTarget target) {
  if (!workspace.mayLoadAsset()) return;
  m_target = std::move(target);
  const std::string file = assetFileOf(workspace.document.committed(), m_target);
  m_browser.open(FileBrowser::Purpose::Open, titleOf(m_target), pathOf(workspace, file), assetEndings(m_target.use));
}

void AssetChooser::drawRow(PanelContext& context, const InspectorRow& row, std::string_view prefix,
                           const AssetTarget& target) {
  Workspace& workspace = context.workspace;
  const std::string name = std::string(prefix) + "/" + std::string(row.info.key);
  ImGui::PushID(name.c_str());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(row.info.label.data(), row.info.label.data() + row.info.label.size());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(row.info.help).c_str());
  ImGui::TableNextColumn();
  const bool reading = workspace.assetLoad.running() && sameTarget(m_target, target);
  const std::string file = row.mixed ? "mixed" : assetFileOf(context.project(), target);
  if (reading) {
    if (smallButton("Cancel", name + "/cancel")) {
      workspace.assetLoad.cancel();
      workspace.say(MessageKind::Info, "All stays as it was");
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(workspace.assetLoad.doing().c_str());
  } else {
    if (smallButton("Browse...", name + "/browse")) browse(workspace, target);
    if (isPicture(target.use) && !file.empty()) {
      ImGui::SameLine(0, scaled(4));
      if (smallButton("Clear", name + "/clear")) {
        workspace.apply(clearPictureEdit(workspace.document.committed(), target.use));
        workspace.document.seal();
      }
    }
    // Below the buttons, where long names have room.
    const std::string shown = file.empty() ? "none" : std::filesystem::path(file).filename().string();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetItemRectSize().x;
    if (ImGui::CalcTextSize(shown.c_str()).x < room - scaled(60)) ImGui::SameLine();
    ImGui::TextDisabled("%s", shown.c_str());
    if (!file.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", file.c_str());
    if (!row.mixed) drawState(workspace, file, target, name);
  }
  ImGui::PopID();
}

void AssetChooser::draw(Workspace& workspace) {
  if (m_browser.isOpen()) look().map.fact("dialog", "asset");
  if (const auto chosen = m_browser.draw()) workspace.loadAsset(m_target, *chosen);
}

}  // namespace windloom::editor
