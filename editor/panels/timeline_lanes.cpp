// The lanes of the timeline: one for each tree, the selected tree's opened for its curve.
#include <algorithm>
#include <cmath>

#include "editor/panels/timeline_panel.hpp"
#include "editor/widgets/icons.hpp"
#include "engine/core/text.hpp"
#include "engine/model/evaluate.hpp"

namespace windloom::editor {

namespace {

constexpr std::size_t kNamedLanes = 32;  // more trees than these get thin lanes without names
constexpr float kLanePx = 20, kThinLanePx = 8, kOpenLanePx = 104;
constexpr float kMarkPx = 4;  // pointer to mark

std::string nameOfTree(const WindGraph& graph, Id root) {
  const Point* point = findPoint(graph, root);
  return point && !point->name.empty() ? point->name : "Tree " + std::to_string(root);
}

double topOf(const Signal& signal) {
  double top = 1.15;
  if (signal.kind == SignalKind::Curve)
    for (const SignalKey& key : signal.keys) top = std::max(top, double(key.value) * 1.1);
  return top;
}

}  // namespace

/// Thin ticks; where many fall together, a band whose strength says how many.
void TimelinePanel::drawMarks(const Area& area, const TreeLane& lane, double delay, float top, float bottom) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec4& colour = look().palette.warning;
  const float cell = scaled(2);
  std::size_t i = 0;
  while (i < lane.marks.size()) {
    const float x = area.x(m_axis, delay + lane.marks[i].time);
    std::size_t end = i + 1;
    while (end < lane.marks.size() && area.x(m_axis, delay + lane.marks[end].time) < x + cell) ++end;
    const float part = std::min(1.0f, 0.45f + 0.15f * float(end - i));
    if (x >= area.left - cell && x <= area.right)
      list.AddRectFilled({x, bottom - (bottom - top) * part}, {x + scaled(1.5f), bottom}, packed(colour, part));
    i = end;
  }
}

void TimelinePanel::selectRoot(PanelContext& context, Id root) const {
  Selection& selection = context.workspace.selection;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl)
    selection.toggle(root);
  else if (io.KeyShift)
    selection.add(root);
  else
    selection.replace(root);
}

void TimelinePanel::laneHover(PanelContext& context, const TreeLane& lane, const Area& area) const {
  const WindGraph& graph = *context.project().graph;
  const double delay = double(signalOf(context.project(), lane.root).delay);
  const float mouse = ImGui::GetIO().MousePos.x;
  std::string text = nameOfTree(graph, lane.root);
  int more = 0;
  float nearest = scaled(kMarkPx);
  std::string found;
  for (const TreeLane::Mark& mark : lane.marks) {
    const float away = std::abs(area.x(m_axis, delay + mark.time) - mouse);
    if (away > scaled(kMarkPx)) continue;
    ++more;
    if (away > nearest) continue;
    nearest = away;
    const Point* point = findPoint(graph, mark.point);
    const std::string name = point && !point->name.empty() ? point->name : "Point " + std::to_string(mark.point);
    found = name + ": reached at " + fixed(delay + mark.time, 2) + " s";
  }
  if (!found.empty()) text += "\n" + found;
  if (more > 1) text += " (and " + std::to_string(more - 1) + " more points)";
  ImGui::SetTooltip("%s", text.c_str());
}

void TimelinePanel::drawLane(PanelContext& context, const TreeLane& lane, const Area& area, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool named = height >= ImGui::GetFontSize();
  const std::string id = "##lane" + std::to_string(lane.root);
  if (ImGui::Selectable(id.c_str(), context.workspace.selection.contains(lane.root),
                        ImGuiSelectableFlags_AllowItemOverlap, {area.right - at.x, height}))
    selectRoot(context, lane.root);
  markItem("timeline/lane/" + std::to_string(lane.root));
  if (ImGui::IsItemHovered() && m_grab == Grab::None) laneHover(context, lane, area);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& palette = look().palette;
  const float top = at.y + scaled(1), bottom = at.y + height - scaled(1);
  if (named) {
    list.PushClipRect({at.x, at.y}, {area.left - scaled(4), at.y + height}, true);
    list.AddText({at.x + scaled(4), at.y + (height - ImGui::GetFontSize()) / 2}, packed(palette.text),
                 nameOfTree(*context.project().graph, lane.root).c_str());
    list.PopClipRect();
  }
  const Signal signal = signalOf(context.project(), lane.root);
  list.PushClipRect({area.left, at.y}, {area.right, at.y + height}, true);
  list.AddRectFilled({area.left, top}, {area.right, bottom}, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(2));
  const double scale = topOf(signal);
  for (float x = area.left; x < area.right; x += scaled(2)) {
    const double time = m_axis.timeAt(double((x - area.left + scaled(1)) / (area.right - area.left)));
    if (time < 0) continue;
    const float factor = float(double(signalAt(signal, time)) / scale);
    list.AddRectFilled({x, bottom - factor * (bottom - top)}, {x + scaled(2), bottom}, packed(palette.accent, 0.6f));
  }
  drawMarks(area, lane, double(signal.delay), top, bottom);
  list.PopClipRect();
}

void TimelinePanel::drawOpenLane(PanelContext& context, const TreeLane& lane, const Area& area, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float labels = area.left - at.x - scaled(6);
  Workspace& workspace = context.workspace;
  ImGui::PushID(int(lane.root));
  ImGui::PushClipRect(at, {area.left, at.y + height}, true);
  const std::string name = nameOfTree(*context.project().graph, lane.root);
  ImGui::SetCursorScreenPos({at.x + scaled(4), at.y + scaled(2)});
  if (ImGui::Selectable(name.c_str(), workspace.selection.contains(lane.root), 0, {labels - scaled(4), 0}))
    selectRoot(context, lane.root);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", name.c_str());
  const Signal signal = signalOf(context.project(), lane.root);
  constexpr const char* kKinds[] = {"Constant", "Pulse", "Gusts", "Curve"};
  ImGui::SetCursorScreenPos({at.x + scaled(4), at.y + scaled(4) + ImGui::GetTextLineHeightWithSpacing()});
  ImGui::SetNextItemWidth(labels - scaled(4));
  if (ImGui::BeginCombo("##kind", kKinds[static_cast<std::size_t>(signal.kind)], ImGuiComboFlags_HeightLarge)) {
    for (int kind = 0; kind < 4; ++kind) {
      if (ImGui::Selectable(kKinds[kind], kind == int(signal.kind)) && kind != int(signal.kind)) {
        Signal other = signalOf(workspace.document.committed(), lane.root);
        other.kind = static_cast<SignalKind>(kind);
        const bool empty = other.kind == SignalKind::Curve && other.keys.empty();
        workspace.apply(putSignalEdit(empty ? asCurve(other) : other, std::string("Play ") + kKinds[kind]));
      }
      markItem("curve/kind/" + std::to_string(kind));
    }
    ImGui::EndCombo();
  }
  markItem("curve/kind");
  const float buttonTop = at.y + scaled(8) + ImGui::GetTextLineHeightWithSpacing() + ImGui::GetFrameHeight();
  ImGui::SetCursorScreenPos({at.x + scaled(4), buttonTop});
  if (signal.kind != SignalKind::Curve || signal.keys.empty()) {
    if (ImGui::Button("To curve", {labels - scaled(4), 0}))
      workspace.apply(convertToCurveEdit(workspace.document.committed(), lane.root));
    markItem("curve/convert");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Convert to a curve with keys that plays the same");
  } else {
    const std::string keys = std::to_string(signal.keys.size()) + (signal.keys.size() == 1 ? " key" : " keys");
    ImGui::TextDisabled("%s%s", keys.c_str(), signal.loop ? ", loops" : "");
  }
  ImGui::PopClipRect();
  m_curve.draw(workspace, lane.root, {area.left, at.y + scaled(1)}, {area.right, at.y + height - scaled(1)}, m_axis);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect({area.left, at.y}, {area.right, at.y + height}, true);
  drawMarks(area, lane, double(signal.delay), at.y + height - scaled(9), at.y + height - scaled(1));
  list.PopClipRect();
  ImGui::SetCursorScreenPos({at.x, at.y + height});
  ImGui::Dummy({0, 0});
  ImGui::PopID();
}

void TimelinePanel::drawLanes(PanelContext& context, const Area& area) {
  if (m_lanes.empty()) {
    ImGui::SetCursorScreenPos({area.left - std::min(scaled(116), area.left), area.top + scaled(6)});
    ImGui::SetCursorPosX(0);
    return ImGui::TextDisabled("The signals of your wind trees will play here.");
  }
  ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x, area.top});
  ImGui::BeginChild("lanes", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse);
  if (ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows) && ImGui::GetIO().MousePos.x < area.left)
    ImGui::SetScrollY(ImGui::GetScrollY() - ImGui::GetIO().MouseWheel * scaled(30));
  const float thin = scaled(m_lanes.size() > kNamedLanes ? kThinLanePx : kLanePx);
  const float all = thin * float(m_lanes.size() - (m_root ? 1 : 0));
  const float open = std::max(scaled(kOpenLanePx), area.bottom - area.top - all - scaled(2));
  const float top = ImGui::GetCursorScreenPos().y;
  float y = top;
  for (const TreeLane& lane : m_lanes) {
    const bool isOpen = lane.root == m_root;
    const float height = isOpen ? std::min(open, std::max(scaled(kOpenLanePx), area.bottom - area.top)) : thin;
    const bool visible = y + height >= area.top && y <= area.bottom;
    ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x, y});
    if (isOpen && (visible || m_curve.dragging()))
      drawOpenLane(context, lane, area, height);
    else if (visible)
      drawLane(context, lane, area, height);
    if (isOpen && m_opened != m_root) ImGui::SetScrollFromPosY(y - ImGui::GetWindowPos().y, 0.0f);
    y += height;
  }
  m_opened = m_root;
  drawPlayhead(context, area, false);
  ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x, y});
  ImGui::Dummy({1, 0});
  ImGui::EndChild();
}

}  // namespace windloom::editor
