#include "editor/panels/timeline_panel.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "editor/widgets/icons.hpp"
#include "engine/core/text.hpp"
#include "engine/model/evaluate.hpp"

namespace windloom::editor {

namespace {

constexpr double kSeekShownAfterS = 0.25;  // shorter ones only would flicker

void transportButton(PanelContext& context, const char* id, const char* symbol, const char* text) {
  const ActionTable& actions = context.workspace.actions;
  const bool on = std::string_view(id) != "play.toggle" && actions.checked(id);
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, look().palette.accentDim);
  ImGui::BeginDisabled(!actions.enabled(id));
  if (ImGui::Button(icons::icon(symbol, text), {scaled(34), 0})) context.workspace.actions.run(id);
  ImGui::EndDisabled();
  if (on) ImGui::PopStyleColor();
  markItem(std::string("timeline/") + id);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", actions.tooltip(id).c_str());
  ImGui::SameLine(0, scaled(4));
}

}  // namespace

void TimelinePanel::followProject(const PanelContext& context) {
  const Shared<WindGraph>& graph = context.project().graph;
  // While a drag is under way the lanes may lag behind: finding them again in every frame costs time with large graphs.
  if (graph != m_graph && (!context.workspace.document.previewing() || !m_graph)) {
    m_graph = graph;
    const GraphEvaluator evaluator(*graph);
    m_lanes.clear();
    m_reachedBy.assign(graph->points.size(), 0);
    std::unordered_map<Id, std::size_t> laneOf;
    for (const Id root : findRoots(*graph)) {
      laneOf.emplace(root, m_lanes.size());
      m_lanes.push_back({root, {}});
    }
    for (std::size_t i = 0; i < graph->points.size(); ++i) {
      const Arrival& arrival = evaluator.arrivals()[i];
      m_reachedBy[i] = arrival.root;
      const auto lane = laneOf.find(arrival.root);
      if (lane != laneOf.end()) m_lanes[lane->second].marks.push_back({arrival.time, graph->points[i].id});
    }
    for (TreeLane& lane : m_lanes) std::ranges::stable_sort(lane.marks, {}, &TreeLane::Mark::time);
  }
  const Id active = context.workspace.selection.active();
  const Arrow* arrow = findArrow(*m_graph, active);
  const auto point = std::ranges::find(m_graph->points, arrow ? arrow->from : active, &Point::id);
  m_root = point == m_graph->points.end() ? 0 : m_reachedBy[static_cast<std::size_t>(point - m_graph->points.begin())];
  if (std::ranges::find(m_lanes, active, &TreeLane::root) != m_lanes.end()) m_root = active;
}

/// Shows the time that was reached, which may be far from where the seek was asked for.
void TimelinePanel::cancelSeek(Session& session) {
  session.cancelSeek();
  m_axis = following(m_axis, session.time());
}

void TimelinePanel::drawSeek(PanelContext& context) {
  const auto seeking = context.session->seeking();
  look().map.fact("seek", seeking ? "yes" : "no");
  if (!seeking) {
    m_seekSince = -1;
    return;
  }
  if (m_seekSince < 0) m_seekSince = ImGui::GetTime();
  if (ImGui::GetTime() - m_seekSince < kSeekShownAfterS) return;
  ImGui::SameLine(0, scaled(10));
  const float cancel = ImGui::CalcTextSize("Cancel").x + 2 * ImGui::GetStyle().FramePadding.x;
  const float room = ImGui::GetContentRegionAvail().x - cancel - scaled(6);
  const std::string percent = std::to_string(int(seeking->part * 100)) + "%";
  const std::string text = "to " + fixed(seeking->target, 1) + " s  " + percent;
  const bool fits = ImGui::CalcTextSize(text.c_str()).x + scaled(8) < room;
  if (room > scaled(30)) {
    ImGui::ProgressBar(seeking->part, {std::min(room, scaled(200)), 0}, fits ? text.c_str() : percent.c_str());
    ImGui::SameLine(0, scaled(6));
  }
  if (ImGui::Button("Cancel")) cancelSeek(*context.session);
  markItem("timeline/cancel");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Stay at the time that was reached (Esc)");
}

void TimelinePanel::drawTransport(PanelContext& context) {
  const bool playing = context.session && context.session->playing();
  transportButton(context, "play.restart", icons::kRestart, "|<");
  transportButton(context, "play.toggle", playing ? icons::kPause : icons::kPlay, playing ? "||" : ">");
  transportButton(context, "play.step", icons::kStep, ">|");
  transportButton(context, "play.loop", icons::kLoop, "Loop");
  if (!context.session) return ImGui::TextDisabled("no live view");
  ImGui::SameLine(0, scaled(8));
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(look().strong);
  ImGui::Text("%s s", fixed(context.session->time(), 2).c_str());
  ImGui::PopFont();
  markItem("timeline/time");
  look().map.fact("time", fixed(context.session->time(), 2));
  look().map.fact("playing", playing ? "yes" : "no");
  const LoopRange& loop = context.session->loop();
  look().map.fact("loop", loop.on ? fixed(loop.in, 2) + " " + fixed(loop.out, 2) : "off");
  const double speed = context.session->status().timeScale;
  if (context.session->seeking()) return drawSeek(context);
  drawSeek(context);
  if (!playing) return;
  ImGui::SameLine(0, scaled(12));
  const bool slow = speed < 0.97;
  std::string text = slow ? fixed(speed, 2) + "x real time" : std::string("real time");
  const float room = ImGui::GetContentRegionAvail().x;
  if (ImGui::CalcTextSize(text.c_str()).x > room) text = fixed(speed, 2) + "x";
  if (ImGui::CalcTextSize(text.c_str()).x > room) return;
  ImGui::TextColored(slow ? look().palette.warning : look().palette.muted, "%s", text.c_str());
  if (slow && ImGui::IsItemHovered())
    ImGui::SetTooltip("This machine can't keep up, so time passes more slowly; no step is left out.");
}

/// Wheel zooms about the pointer; Shift+wheel and the middle button pan.
void TimelinePanel::takeAxis(const Area& area) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool inside = io.MousePos.x >= area.left && io.MousePos.x <= area.right && io.MousePos.y >= area.top &&
                      io.MousePos.y <= area.bottom;
  m_hovered =
      inside && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows | ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  const double perPixel = m_axis.seconds / double(area.right - area.left);
  if (m_hovered && io.MouseWheel != 0) {
    const double at = m_axis.timeAt(double((io.MousePos.x - area.left) / (area.right - area.left)));
    m_axis = io.KeyShift ? panned(m_axis, -double(io.MouseWheel) * 0.1 * m_axis.seconds)
                         : zoomed(m_axis, std::pow(0.8, double(io.MouseWheel)), at);
  }
  if (m_hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) m_grab = Grab::Pan;
  if (m_grab != Grab::Pan) return;
  m_axis = panned(m_axis, -double(io.MouseDelta.x) * perPixel);
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Middle)) m_grab = Grab::None;
}

/// Over the window at hand: the ruler and the lanes are two.
void TimelinePanel::drawPlayhead(const PanelContext& context, const Area& area, bool head) const {
  if (!context.session) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& palette = look().palette;
  list.PushClipRect({area.left, area.top}, {area.right, area.bottom}, true);
  if (const auto seeking = context.session->seeking()) {
    const float target = area.x(m_axis, seeking->target);
    list.AddLine({target, area.top}, {target, area.bottom}, packed(palette.warning, 0.8f), scaled(1.5f));
  }
  const float x = area.x(m_axis, context.session->time());
  list.AddLine({x, area.top}, {x, area.bottom}, packed(palette.text), scaled(1.5f));
  list.PopClipRect();
  if (!head) return;
  list.AddTriangleFilled({x - scaled(5), area.top}, {x + scaled(5), area.top}, {x, area.top + scaled(7)},
                         packed(palette.text));
  look().map.rectangle("timeline/playhead", {x - scaled(5), area.top}, {x + scaled(5), area.top + scaled(7)});
}

void TimelinePanel::draw(PanelContext& context) {
  followProject(context);
  drawTransport(context);
  ImGui::Spacing();
  ImGui::BeginChild("time", {0, 0}, false, ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar);
  const ImVec2 origin = ImGui::GetCursorScreenPos(), size = ImGui::GetContentRegionAvail();
  const float labels = std::min(scaled(116), size.x * 0.3f), ruler = look().small->FontSize + scaled(8);
  // The lanes may scroll: ruler and lanes keep the same width.
  const float right = origin.x + size.x - ImGui::GetStyle().ScrollbarSize - scaled(2);
  const Area area{origin.x + labels, right, origin.y, origin.y + size.y};
  if (area.right - area.left > scaled(40) && size.y > ruler) {
    const double now = context.session ? context.session->time() : 0;
    const bool inView = m_lastNow >= m_axis.from && m_lastNow <= m_axis.to();
    if (now != m_lastNow && inView && m_grab == Grab::None && !m_curve.dragging()) m_axis = following(m_axis, now);
    m_lastNow = now;
    takeAxis(area);
    drawRuler(context, area, ruler);
    Area lanes = area;
    lanes.top += ruler;
    drawLanes(context, lanes);
    Area rulerOnly = area;
    rulerOnly.bottom = area.top + ruler;
    ImGui::PushClipRect({area.left, area.top}, {area.right, area.bottom}, true);
    drawPlayhead(context, rulerOnly, true);
    ImGui::PopClipRect();
  }
  ImGui::EndChild();
  look().map.fact("curve.root", std::to_string(m_root));
}

bool TimelinePanel::keyPressed(const KeyPress& press, PanelContext& context) {
  if (m_root != 0 && m_curve.keyPressed(press, context.workspace)) return true;
  if (press.key == Key::Escape && context.session && context.session->seeking()) {
    cancelSeek(*context.session);
    return true;
  }
  if (!m_hovered || press.modifiers.any() || (press.key != Key::F && press.key != Key::Home)) return false;
  if (m_root != 0) {
    m_axis = CurveEditor::frameOf(signalOf(context.project(), m_root));
  } else {
    m_axis = following({0, 24}, context.session ? context.session->time() : 0);
  }
  return true;
}

}  // namespace windloom::editor
