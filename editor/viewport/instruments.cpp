#include "editor/viewport/instruments.hpp"

#include <algorithm>
#include <cmath>
#include <string>

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
  list.AddRectFilled({left - scaled(8), y - ImGui::GetTextLineHeight() - scaled(10)},
                     {left + width + scaled(8), y + scaled(9)}, packed(palette.overlayBack, 0.8f), scaled(4));
  const ImU32 colour = packed(palette.overlayText);
  list.AddLine({left, y}, {left + length, y}, colour, scaled(2));
  list.AddLine({left, y - tick}, {left, y + tick}, colour, scaled(2));
  list.AddLine({left + length, y - tick}, {left + length, y + tick}, colour, scaled(2));
  list.AddText({left + (length - ImGui::CalcTextSize(label.c_str()).x) / 2, y - ImGui::GetTextLineHeight() - scaled(5)},
               colour, label.c_str());
  look().map.fact("scale", shortest(metres) + " m in " + shortest(std::round(length * 100) / 100) + " px");
}

bool speedLegend(const ViewArea& area, float& range) {
  const Palette& palette = look().palette;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float barWidth = scaled(12), boxWidth = scaled(84);
  const float barHeight = std::min(scaled(110), (area.max.y - area.min.y) * 0.3f);
  if (barHeight < scaled(50)) return false;  // no room to read it
  const ImVec2 max{area.max.x - scaled(12), area.max.y - scaled(12)};
  const ImVec2 min{max.x - boxWidth, max.y - barHeight - ImGui::GetFrameHeight() - scaled(26)};
  list.AddRectFilled(min, max, packed(palette.overlayBack), scaled(4));

  ImGui::SetCursorScreenPos({min.x + scaled(6), min.y + scaled(6)});
  ImGui::SetNextItemWidth(boxWidth - scaled(12));
  const NumberEdit edit = numberField("legend/range", double(range), false, {"m/s", 0.5, 200, 1, false});
  if (edit.changed) range = std::clamp(float(edit.value), 0.5f, 200.0f);
  if (edit.reset) range = Overlays{}.speedRange;
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("Wind speed at the top of the colours. Drag, or click and type; right click resets.");

  const float left = min.x + scaled(10), top = min.y + ImGui::GetFrameHeight() + scaled(16);
  constexpr int kBands = 32;
  for (int i = 0; i < kBands; ++i) {
    const glm::vec3 colour = speedColour(1.0f - (float(i) + 0.5f) / kBands);
    const float y = top + barHeight * float(i) / kBands;
    list.AddRectFilled({left, y}, {left + barWidth, y + barHeight / kBands + 0.5f},
                       packed({colour.x, colour.y, colour.z, 1.0f}));
  }
  for (int i = 0; i <= 4; ++i) {
    const float y = top + barHeight * float(i) / 4;
    list.AddLine({left + barWidth, y}, {left + barWidth + scaled(4), y}, packed(palette.overlayText));
    const std::string label = displayNumber(double(range) * (4 - i) / 4, 1, false);
    list.AddText(look().small, look().small->FontSize, {left + barWidth + scaled(8), y - look().small->FontSize / 2},
                 packed(palette.overlayText), label.c_str());
  }
  return ImGui::IsMouseHoveringRect(min, max);
}

void firstTreeHint(const ViewArea& area) {
  const ImVec2 centre{(area.min.x + area.max.x) / 2, area.min.y + (area.max.y - area.min.y) * 0.28f};
  textBox(centre, {"Draw your first wind tree", "Press D, then press on the ground, drag, and let go.",
                   "Start a drag at a point to branch from it; click, click, click goes on.",
                   "Enter or right click ends. F1 lists all keys."});
  look().map.fact("hint", "first tree");
}

}  // namespace windloom::editor
