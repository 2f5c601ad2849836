#include "editor/app/menus.hpp"

#include <filesystem>
#include <iterator>
#include <set>
#include <string>

#include "editor/panels/grass_view.hpp"
#include "editor/widgets/icons.hpp"
#include "engine/core/file.hpp"
#include "engine/model/templates.hpp"

namespace windloom::editor {

namespace {

constexpr const char* kMenus[] = {"File", "Edit", "Select", "Add", "Graph", "Tools", "View", "Play", "Help"};

void actionItem(ActionTable& actions, const Action& action) {
  const std::string label = actions.label(action.id), shortcut = actions.shortcutText(action.id);
  if (ImGui::MenuItem(label.c_str(), shortcut.c_str(), actions.checked(action.id), actions.enabled(action.id)))
    actions.run(action.id);
  markItem("menu/" + action.id);
  if (!action.help.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", action.help.c_str());
}

void templatesMenu(Workspace& workspace) {
  if (!ImGui::BeginMenu("New from template")) return;
  for (const ProjectTemplate& entry : projectTemplates()) {
    if (ImGui::MenuItem(std::string(entry.title).c_str())) workspace.flow.requestNew(entry.make());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(entry.summary).c_str());
  }
  ImGui::EndMenu();
}

void recentMenu(Workspace& workspace) {
  const auto recent = workspace.preferences.recentFiles;
  if (!ImGui::BeginMenu("Open recent", !recent.empty())) return;
  for (const std::string& file : recent)
    if (ImGui::MenuItem(file.c_str())) workspace.flow.requestOpen(std::filesystem::path(file));
  ImGui::EndMenu();
}

void camerasMenu(Workspace& workspace) {
  const auto cameras = workspace.document.project().cameras;
  const bool open = ImGui::BeginMenu("Project cameras", !cameras->empty());
  markItem("menu/Project cameras");
  if (!open) return;
  for (const Camera& camera : *cameras) {
    const std::string name = camera.name.empty() ? "Camera " + std::to_string(camera.id) : camera.name;
    ImGui::PushID(int(camera.id));
    if (ImGui::MenuItem(name.c_str(), nullptr, workspace.lookedThrough() == camera.id)) workspace.lookAs(camera.id);
    ImGui::PopID();
    markItem("menu/camera:" + std::to_string(camera.id));
  }
  ImGui::EndMenu();
}

void samplesMenu(Workspace& workspace) {
  const bool open = ImGui::BeginMenu("Samples");
  markItem("menu/Samples");
  if (!open) return;
  const auto folder = findDataFolder("projects");
  std::error_code failed;
  std::set<std::string> names;
  if (folder)
    for (const auto& entry : std::filesystem::directory_iterator(*folder, failed))
      names.insert(entry.path().filename().string());
  for (const std::string& name : names) {
    const auto file = *folder / name / (name + ".wind.json");
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) continue;
    if (ImGui::MenuItem(name.c_str())) workspace.flow.requestOpen(file);
    markItem("menu/sample:" + name);
  }
  if (!folder) ImGui::TextDisabled("The samples folder was not found.");
  ImGui::EndMenu();
}

struct ToolButton {
  const char *action, *symbol, *text;
};

constexpr ToolButton kTools[] = {
    {"tool.select", icons::kSelect, "Select"},  {"tool.move", icons::kMove, "Move"},
    {"tool.rotate", icons::kRotate, "Rotate"},  {"tool.scale", icons::kScale, "Scale"},
    {"tool.draw", icons::kDraw, "Draw"},        {"tool.obstacle", icons::kObstacle, "Obstacle"},
    {"tool.vortex", icons::kVortex, "Vortex"},  {"tool.brush", icons::kBrush, "Brush"},
    {"tool.probe", icons::kProbe, "Probe"},     {"tool.delete", icons::kEraser, "Delete"},
    {"add.collider", icons::kBall, "Collider"},
};
constexpr ToolButton kEdits[] = {{"edit.undo", icons::kUndo, "Undo"}, {"edit.redo", icons::kRedo, "Redo"}};
constexpr ToolButton kOverlays[] = {{"overlay.arrows", icons::kArrow, "Arrows"},
                                    {"overlay.streamlines", icons::kStreamlines, "Streamlines"},
                                    {"overlay.vectors", icons::kVectors, "Vectors"},
                                    {"overlay.speed", icons::kSpeed, "Speed"},
                                    {"overlay.divergence", icons::kDivergence, "Divergence"},
                                    {"overlay.vorticity", icons::kVorticity, "Vorticity"},
                                    {"overlay.lic", icons::kLic, "Streaks"}};

std::string labelOf(const ToolButton& button, bool withText) {
  std::string label = icons::icon(button.symbol, button.text);
  if (withText && look().hasIcons) label += std::string("  ") + button.text;
  return label;
}

void toolButton(ActionTable& actions, const ToolButton& button, bool withText) {
  const bool on = actions.checked(button.action);
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, look().palette.accentDim);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, look().palette.accentDim);
  }
  const std::string label = labelOf(button, withText);
  ImGui::BeginDisabled(!actions.enabled(button.action));
  const bool pressed = ImGui::Button(label.c_str(), {withText || !look().hasIcons ? 0 : scaled(32), 0});
  ImGui::EndDisabled();
  if (on) ImGui::PopStyleColor(2);
  markItem(std::string("toolbar/") + button.action);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
    ImGui::SetTooltip("%s", actions.tooltip(button.action).c_str());
  ImGui::SameLine(0, scaled(3));
  if (pressed) actions.run(button.action);
}

void gap() {
  ImGui::Dummy({scaled(10), 1});
  ImGui::SameLine(0, 0);
}

/// A button that opens a popup with its name; true while that is open.
bool popupButton(const char* name, const char* symbol, const char* text, const char* help) {
  const bool pressed = ImGui::Button(icons::icon(symbol, text), {look().hasIcons ? scaled(32) : 0, 0});
  markItem(std::string("toolbar/") + name);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::SameLine(0, scaled(3));
  if (pressed) ImGui::OpenPopup(name);
  return ImGui::BeginPopup(name);
}

/// All things of one kind to add.
void addMenu(ActionTable& actions, const char* name, const char* symbol, const char* text, const char* start) {
  if (!popupButton(name, symbol, text, start)) return;
  for (const Action& action : actions.all())
    if (action.category == "Add" && action.label.starts_with(start)) actionItem(actions, action);
  ImGui::EndPopup();
}

/// Only with Bezier grass.
void grassViewButton(PanelContext& context) {
  if (context.project().grass->kind != GrassKind::Bezier) return;
  if (!popupButton("grass_view", icons::kEye, "Grass", "How the grass is looked at, and what is left out of it"))
    return;
  drawGrassView(context);
  ImGui::EndPopup();
}

void grassViewMenu(ActionTable& actions, const Project& project) {
  const bool open = ImGui::BeginMenu("Grass view", project.grass->kind == GrassKind::Bezier);
  markItem("menu/Grass view");
  if (!open) return;
  for (const Action& action : actions.all()) {
    if (action.id == "cull.orientation") ImGui::Separator();
    if (action.category == "Grass") actionItem(actions, action);
  }
  ImGui::EndMenu();
}

/// In place of buttons that would not fit.
void overlayMenu(ActionTable& actions) {
  const bool pressed = ImGui::Button("Overlays");
  markItem("toolbar/overlays");
  if (pressed) ImGui::OpenPopup("overlays");
  if (!ImGui::BeginPopup("overlays")) return;
  for (const ToolButton& button : kOverlays) actionItem(actions, *actions.find(button.action));
  ImGui::EndPopup();
}

/// With their names where there is room for all of them.
void drawOverlayButtons(ActionTable& actions) {
  const float room = ImGui::GetContentRegionAvail().x;
  if (room < scaled(35) * float(std::size(kOverlays))) return overlayMenu(actions);
  float named = 0;
  for (const ToolButton& button : kOverlays)
    named += ImGui::CalcTextSize(labelOf(button, true).c_str()).x + 2 * ImGui::GetStyle().FramePadding.x + scaled(3);
  for (const ToolButton& button : kOverlays) toolButton(actions, button, room > named);
}

}  // namespace

void drawMenuBar(Workspace& workspace) {
  if (!ImGui::BeginMenuBar()) return;
  ActionTable& actions = workspace.actions;
  for (const char* menu : kMenus) {
    const bool open = ImGui::BeginMenu(menu);
    markItem(std::string("menu/") + menu);
    if (!open) continue;
    for (const Action& action : actions.all()) {
      if (action.category != menu || action.id == "file.quit") continue;
      actionItem(actions, action);
      if (action.id == "file.new") templatesMenu(workspace);
      if (action.id == "view.camera_store") camerasMenu(workspace);
      if (action.id == "grass.none") grassViewMenu(actions, workspace.document.project());
      if (action.id == "file.open") {
        recentMenu(workspace);
        samplesMenu(workspace);
        ImGui::Separator();
      }
    }
    if (const Action* quit = actions.find("file.quit"); quit && menu == kMenus[0]) {
      ImGui::Separator();
      actionItem(actions, *quit);
    }
    ImGui::EndMenu();
  }
  ImGui::EndMenuBar();
}

void drawToolbar(PanelContext& context) {
  ActionTable& actions = context.workspace.actions;
  for (const ToolButton& button : kTools) toolButton(actions, button, false);
  addMenu(actions, "species", icons::kPlant, "Species", "Add species");
  addMenu(actions, "surfaces", icons::kSurface, "Surface", "Add surface");
  toolButton(actions, {"add.rotor", icons::kRotor, "Rotor"}, false);
  gap();
  for (const ToolButton& button : kEdits) toolButton(actions, button, false);
  gap();
  const bool playing = actions.checked("play.toggle");
  toolButton(actions, {"play.toggle", playing ? icons::kPause : icons::kPlay, playing ? "Pause" : "Play"}, false);
  gap();
  grassViewButton(context);
  drawOverlayButtons(actions);
}

}  // namespace windloom::editor
