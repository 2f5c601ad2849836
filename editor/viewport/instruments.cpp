#include "editor/viewport/instruments.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "editor/core/legend_layout.hpp"
#include "editor/widgets/number_field.hpp"
#include "engine/core/text.hpp"
#include "engine/render/frame_renderer.hpp"

namespace windloom::editor {

namespace {

void textBox(ImVec2 centre, const std::vector<std::string>& lines) {
  const Palette& palette = look().palette;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  float width = 0;
  for (const std::string& line : lines) width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
  const float lineHeight = ImGui::GetTextLineHeightWithSpacing(), pad = scaled(14);
  const float height = lineHeight * float(lines.size());
  const ImVec2 min{centre.x - width / 2 - pad, centre.y - height / 2 - pad};
  const ImVec2 max{centre.x + width / 2 + pad, centre.y + height / 2 + pad};
  list.AddRectFilled(min, max, packed(palette.overlayBack), scaled(6));
  float y = min.y + pad;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const float left = centre.x - ImGui::CalcTextSize(lines[i].c_str()).x / 2;
    list.AddText({left, y}, packed(palette.overlayText, i == 0 ? 1.0f : 0.8f), lines[i].c_str());
    y += lineHeight;
  }
}

}  // namespace

bool axisSign(const ViewArea& area, Workspace& workspace) {
  struct Axis {
    const char* name;
    const char* action;
    glm::vec3 direction;
    ImVec4 colour;
    float depth;
  };
  const Palette& palette = look().palette;
  const EditorCamera& camera = workspace.camera;
  const glm::vec3 right = camera.right(), up = camera.up(), forward = camera.forward();
  Axis axes[] = {{"X", "view.side", {1, 0, 0}, palette.axisX, 0},
                 {"Y", "view.top", {0, 1, 0}, palette.axisY, 0},
                 {"Z", "view.front", {0, 0, 1}, palette.axisZ, 0}};
  for (Axis& axis : axes) axis.depth = glm::dot(axis.direction, forward);
  std::sort(std::begin(axes), std::end(axes), [](const Axis& a, const Axis& b) { return a.depth > b.depth; });

  const float length = scaled(30), knob = scaled(9);
  const ImVec2 centre{area.max.x - length - scaled(22), area.min.y + length + scaled(22)};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float fromCentre = std::hypot(mouse.x - centre.x, mouse.y - centre.y);
  const bool near = fromCentre < length + knob;
  list.AddCircleFilled(centre, length + knob * 1.3f, packed(palette.overlayBack, near ? 0.9f : 0.45f), 40);
  bool onKnob = false;
  for (const Axis& axis : axes) {
    const ImVec2 end{centre.x + glm::dot(axis.direction, right) * length,
                     centre.y - glm::dot(axis.direction, up) * length};
    const bool hovered = near && std::hypot(mouse.x - end.x, mouse.y - end.y) < knob * 1.2f;
    list.AddLine(centre, end, packed(axis.colour), scaled(2));
    list.AddCircleFilled(end, knob, packed(axis.colour, hovered ? 1.0f : 0.9f), 20);
    const ImVec2 size = ImGui::CalcTextSize(axis.name);
    list.AddText({end.x - size.x / 2, end.y - size.y / 2}, IM_COL32(12, 14, 16, 255), axis.name);
    look().map.rectangle(std::string("axis/") + axis.name, {end.x - knob, end.y - knob}, {end.x + knob, end.y + knob});
    if (hovered && !onKnob) {
      onKnob = true;
      ImGui::SetTooltip("%s", workspace.actions.tooltip(axis.action).c_str());
      if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) workspace.actions.run(axis.action);
    }
  }
  return onKnob;
}

void scaleBar(const ViewArea& area, const Workspace& workspace) {
  const float perPixel = workspace.view().metresPerPixel(workspace.camera.target);
  if (!(perPixel > 0)) return;
  // The longest of 1, 2, 5 x 10^n metres within the room for it.
  const float room = scaled(140) * perPixel;
  const float power = std::pow(10.0f, std::floor(std::log10(room)));
  const float metres = room / power >= 5 ? 5 * power : room / power >= 2 ? 2 * power : power;
  const float length = metres / perPixel;
  const Palette& palette = look().palette;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float left = area.min.x + scaled(18), y = area.max.y - scaled(18), tick = scaled(5);
  const std::string label = metres < 1 ? fixed(double(metres) * 100, 0) + " cm" : fixed(double(metres), 0) + " m";
  const float width = std::max(length, ImGui::CalcTextSize(label.c_str()).x);
  const ImVec2 min{left - scaled(8), y - ImGui::GetTextLineHeight() - scaled(10)};
  const ImVec2 max{left + width + scaled(8), y + scaled(9)};
  list.AddRectFilled(min, max, packed(palette.overlayBack, 0.8f), scaled(4));
  look().map.rectangle("scale bar", min, max);
  const ImU32 colour = packed(palette.overlayText);
  list.AddLine({left, y}, {left + length, y}, colour, scaled(2));
  list.AddLine({left, y - tick}, {left, y + tick}, colour, scaled(2));
  list.AddLine({left + length, y - tick}, {left + length, y + tick}, colour, scaled(2));
  list.AddText({left + (length - ImGui::CalcTextSize(label.c_str()).x) / 2, y - ImGui::GetTextLineHeight() - scaled(5)},
               colour, label.c_str());
  look().map.fact("scale", shortest(metres) + " m in " + shortest(std::round(length * 100) / 100) + " px");
}

namespace {

struct Legend {
  const char *name, *title, *unit, *help;
  float* range;
  float home, step;
  bool bothWays;  // from -range to range
};

/// The legends that the colours on the screen need, the ground's first.
std::vector<Legend> legendsOf(Overlays& overlays) {
  const Overlays home;
  std::vector<Legend> legends;
  if (overlays.map == GroundMap::Divergence)
    legends.push_back(
        {"divergence", "Divergence", "1/s",
         "Divergence at both ends of the colours: air spreads where it is orange and gathers where it is blue.",
         &overlays.divergenceRange, home.divergenceRange, 0.1f, true});
  if (overlays.map == GroundMap::Vorticity)
    legends.push_back(
        {"vorticity", "Vorticity", "1/s",
         "Vorticity at both ends of the colours: twice the rate at which the air turns, orange from +X towards +Z.",
         &overlays.vorticityRange, home.vorticityRange, 0.1f, true});
  const bool speed = overlays.arrows || overlays.vectors || overlays.streamlines || overlays.map == GroundMap::Speed ||
                     overlays.map == GroundMap::Lic;
  if (speed)
    legends.push_back({"speed", "Speed", "m/s", "Wind speed, and an arrow's strength, at the top of the colours.",
                       &overlays.speedRange, home.speedRange, 0.5f, false});
  return legends;
}

void legendBar(const Legend& legend, ImVec2 at, float height) {
  const Palette& palette = look().palette;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = scaled(12);
  constexpr int kBands = 40;
  for (int i = 0; i < kBands; ++i) {
    const float part = 1.0f - (float(i) + 0.5f) / kBands;
    const glm::vec3 colour = legend.bothWays ? divergingColour(2 * part - 1) : speedColour(part);
    const float y = at.y + height * float(i) / kBands;
    list.AddRectFilled({at.x, y}, {at.x + width, y + height / kBands + 0.5f},
                       packed({colour.x, colour.y, colour.z, 1.0f}));
  }
  list.AddRect({at.x, at.y}, {at.x + width, at.y + height}, packed(palette.overlayText, 0.5f));
  for (int i = 0; i <= 4; ++i) {
    const float y = at.y + height * float(i) / 4, part = 1.0f - float(i) / 4;
    list.AddLine({at.x + width, y}, {at.x + width + scaled(4), y}, packed(palette.overlayText));
    const double value = double(*legend.range) * double(legend.bothWays ? 2 * part - 1 : part);
    // Small ranges want more digits than their step has.
    const std::string label = displayNumber(value, std::min(double(legend.step), double(*legend.range) / 4), false);
    list.AddText(look().small, look().small->FontSize, {at.x + width + scaled(8), y - look().small->FontSize / 2},
                 packed(palette.overlayText), label.c_str());
  }
}

bool drawLegend(const Legend& legend, ImVec2 min, ImVec2 max, float bar) {
  const Palette& palette = look().palette;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, packed(palette.overlayBack), scaled(4));
  const float small = look().small->FontSize;
  list.AddText(look().small, small, {min.x + scaled(8), min.y + scaled(5)}, packed(palette.overlayText), legend.title);
  const std::string name = std::string("legend/") + legend.name;
  ImGui::SetCursorScreenPos({min.x + scaled(6), min.y + small + scaled(9)});
  ImGui::SetNextItemWidth(max.x - min.x - scaled(12));
  const NumberEdit edit = numberField((name + "/range").c_str(), double(*legend.range), false,
                                      {legend.unit, kLeastRange, kGreatestRange, double(legend.step), false});
  if (edit.changed) *legend.range = std::clamp(float(edit.value), float(kLeastRange), float(kGreatestRange));
  if (edit.reset) *legend.range = legend.home;
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s Drag, or click and type; right click resets.", legend.help);
  legendBar(legend, {min.x + scaled(10), max.y - bar - scaled(10)}, bar);
  look().map.rectangle(name, min, max);
  return ImGui::IsMouseHoveringRect(min, max);
}

}  // namespace

bool colourLegends(const ViewArea& area, Overlays& overlays) {
  const std::vector<Legend> legends = legendsOf(overlays);
  const float fixedHeight = look().small->FontSize + ImGui::GetFrameHeight() + scaled(28);
  const std::vector<LegendBox> boxes =
      layoutLegends({area.max.x - area.min.x, area.max.y - area.min.y}, look().scale, fixedHeight, int(legends.size()));
  bool over = false;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    over |= drawLegend(legends[i], area.at(boxes[i].min), area.at(boxes[i].max), boxes[i].bar);
  return over;
}

void firstTreeHint(const ViewArea& area) {
  const ImVec2 centre{(area.min.x + area.max.x) / 2, area.min.y + (area.max.y - area.min.y) * 0.28f};
  textBox(centre, {"Draw your first wind tree", "Press D, then press on the ground, drag, and let go.",
                   "Start a drag at a point to branch from it; click, click, click goes on.",
                   "Enter or right click ends. F1 lists all keys."});
  look().map.fact("hint", "first tree");
}

}  // namespace windloom::editor
