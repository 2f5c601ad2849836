#include "editor/panels/tool_options.hpp"

#include <algorithm>
#include <string>

#include "editor/widgets/icons.hpp"
#include "editor/widgets/number_field.hpp"
#include "engine/model/parameters.hpp"

namespace windloom::editor {

namespace {

void label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", text);
  ImGui::SameLine(scaled(96));
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
}

void number(const char* text, const char* name, float& value, const NumberFormat& format) {
  label(text);
  const NumberEdit edit = numberField((std::string("tool/") + name).c_str(), double(value), false, format);
  if (edit.changed) value = std::clamp(float(edit.value), float(format.min), float(format.max));
}

/// With the unit and range that the parameter has everywhere.
template <class Owner>
void parameter(const char* key, const char* name, float& value, std::string_view unit = {}) {
  for (const Parameter<Owner>& one : parametersOf<Owner>()) {
    if (one.info.key != key) continue;
    const NumberFormat format{unit.empty() ? one.info.unit : unit, one.info.min, one.info.max, one.info.step};
    number(std::string(one.info.label).c_str(), name, value, format);
  }
}

void arrowOptions(ToolSettings& settings) {
  Arrow& arrow = settings.newArrow;
  parameter<Arrow>("strength", "strength", arrow.strength, arrow.drive == Drive::Speed ? "m/s" : "m/s^2");
  parameter<Arrow>("radius", "radius", arrow.radius);
}

void shapeButton(ToolSettings& settings, ObstacleShape shape, const char* symbol, const char* text) {
  const bool on = (settings.newObstacle.shape == ObstacleShape::Box) == (shape == ObstacleShape::Box);
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, look().palette.accentDim);
  const std::string caption = look().hasIcons ? std::string(symbol) + "  " + text : text;
  if (ImGui::Button(caption.c_str())) settings.newObstacle.shape = shape;
  if (on) ImGui::PopStyleColor();
  markItem(std::string("tool/shape/") + text);
  ImGui::SameLine(0, scaled(4));
}

void obstacleOptions(ToolSettings& settings) {
  label("Drag makes");
  shapeButton(settings, ObstacleShape::Circle, icons::kObstacle, "Circle");
  shapeButton(settings, ObstacleShape::Box, icons::kBox, "Box");
  ImGui::NewLine();
  label("Clicks make");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("a polygon, corner by corner");
  parameter<Obstacle>("height", "height", settings.newObstacle.height);
}

void brushOptions(ToolSettings& settings) {
  number("Radius", "brush_radius", settings.brush.radiusM, {"m", double(kMinBrushM), double(kMaxBrushM), 0.1});
  number("Strength", "brush_strength", settings.brush.strength,
         {"x", double(kMinBrushStrength), double(kMaxBrushStrength), 0.05});
}

}  // namespace

void drawToolOptions(PanelContext& context) {
  Workspace& workspace = context.workspace;
  const Tool& tool = workspace.tools.active();
  const std::string id = tool.id();
  if (id != "draw" && id != "obstacle" && id != "vortex" && id != "brush") return;
  ImGui::PushFont(look().strong);
  const bool open = ImGui::CollapsingHeader((tool.label() + " tool").c_str(), ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopFont();
  if (!open) return;
  ToolSettings& settings = workspace.toolSettings;
  if (id == "draw") arrowOptions(settings);
  if (id == "obstacle") obstacleOptions(settings);
  if (id == "vortex") number("Swirl", "swirl", settings.newSwirlMps, {"m/s", -100, 100, 0.1});
  if (id == "brush") brushOptions(settings);
  ImGui::Spacing();
}

}  // namespace windloom::editor
