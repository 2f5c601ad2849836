#include "editor/panels/timeline_panel.hpp"

#include <algorithm>
#include <cmath>

#include "editor/widgets/icons.hpp"
#include "engine/core/text.hpp"
#include "engine/model/evaluate.hpp"

namespace windloom::editor {

namespace {

constexpr double kSecondsShown = 24;
constexpr std::size_t kMaxLanes = 32;

void transportButton(PanelContext& context, const char* id, const char* symbol, const char* text) {
  const ActionTable& actions = context.workspace.actions;
  ImGui::BeginDisabled(!actions.enabled(id));
  if (ImGui::Button(icons::icon(symbol, text), {scaled(34), 0})) context.workspace.actions.run(id);
  ImGui::EndDisabled();
  markItem(std::string("timeline/") + id);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", actions.tooltip(id).c_str());
  ImGui::SameLine();
}

void drawTransport(PanelContext& context) {
  const bool playing = context.session && context.session->playing();
  transportButton(context, "play.restart", icons::kRestart, "|<");
  transportButton(context, "play.toggle", playing ? icons::kPause : icons::kPlay, playing ? "||" : ">");
  transportButton(context, "play.step", icons::kStep, ">|");
  if (!context.session) return ImGui::TextDisabled("no live view");
  ImGui::PushFont(look().strong);
  ImGui::Text("%s s", fixed(context.session->time(), 2).c_str());
  ImGui::PopFont();
  markItem("timeline/time");
  look().map.fact("time", fixed(context.session->time(), 2));
  const double speed = context.session->status().timeScale;
  if (playing) {
    ImGui::SameLine(0, scaled(12));
    const bool slow = speed < 0.97;
    std::string text = slow ? fixed(speed, 2) + "x real time" : std::string("real time");
    if (ImGui::CalcTextSize(text.c_str()).x > ImGui::GetContentRegionAvail().x) text = fixed(speed, 2) + "x";
    ImGui::TextColored(slow ? look().palette.warning : look().palette.muted, "%s", text.c_str());
    if (slow && ImGui::IsItemHovered())
      ImGui::SetTooltip("This machine can't keep up, so time passes more slowly; no step is left out.");
  }
}

/// One root's factor over time as a filled curve.
void drawLane(const Signal& signal, ImVec2 min, ImVec2 max, double first) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& palette = look().palette;
  list.AddRectFilled(min, max, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(2));
  const int columns = std::max(1, int((max.x - min.x) / scaled(2)));
  const float width = (max.x - min.x) / float(columns);
  for (int i = 0; i < columns; ++i) {
    const double t = first + (i + 0.5) / columns * kSecondsShown;
    const float factor = t < 0 ? 0.0f : std::clamp(signalAt(signal, t), 0.0f, 1.5f) / 1.5f;
    const float top = max.y - factor * (max.y - min.y);
    const float left = min.x + float(i) * width;
    list.AddRectFilled({left, top}, {left + width, max.y}, packed(palette.accent, 0.75f));
  }
}

void drawSignals(PanelContext& context) {
  const WindGraph& graph = *context.project().graph;
  const std::vector<Id> roots = findRoots(graph);
  if (roots.empty()) return ImGui::TextDisabled("The signals of your wind trees will play here.");
  const double now = context.session ? context.session->time() : 0;
  // The playhead moves through the first third and stays there while time scrolls by.
  const double first = std::max(0.0, now - kSecondsShown / 3);
  const float labelWidth = scaled(110), height = scaled(20);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float left = origin.x + labelWidth, right = origin.x + ImGui::GetContentRegionAvail().x - scaled(4);
  if (right - left < scaled(40)) return;
  const std::size_t lanes = std::min(roots.size(), kMaxLanes);
  for (std::size_t i = 0; i < lanes; ++i) {
    const Point* point = findPoint(graph, roots[i]);
    const Signal* own = findSignal(graph, roots[i]);
    Signal constant;
    constant.root = roots[i];
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string label = point && !point->name.empty() ? point->name : "Tree " + std::to_string(roots[i]);
    if (ImGui::Selectable((label + "##" + std::to_string(roots[i])).c_str(),
                          context.workspace.selection.contains(roots[i]), 0, {labelWidth - scaled(6), height}))
      context.workspace.selection.replace(roots[i]);
    drawLane(own ? *own : constant, {left, at.y}, {right, at.y + height}, first);
  }
  const float x = left + float((now - first) / kSecondsShown) * (right - left);
  const float bottom = ImGui::GetCursorScreenPos().y;
  ImGui::GetWindowDrawList()->AddLine({x, origin.y}, {x, bottom}, packed(look().palette.text), scaled(1.5f));
  if (roots.size() > lanes) ImGui::TextDisabled("and %d more trees", int(roots.size() - lanes));
}

}  // namespace

void drawTimelinePanel(PanelContext& context) {
  drawTransport(context);
  ImGui::Spacing();
  ImGui::BeginChild("signals");
  drawSignals(context);
  ImGui::EndChild();
}

}  // namespace windloom::editor
