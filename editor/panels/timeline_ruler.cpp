// The ruler of the timeline: scale, loop range, scrubbing.
#include <algorithm>
#include <cmath>

#include "editor/panels/timeline_panel.hpp"

namespace windloom::editor {

namespace {

constexpr float kMarkPx = 6;  // how near to a mark of the loop a press takes it

}  // namespace

void TimelinePanel::drawRulerScale(const Area& area, float height) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& palette = look().palette;
  const double step = tickStep(m_axis.seconds * double(scaled(58) / (area.right - area.left)));
  list.PushClipRect({area.left, area.top}, {area.right, area.bottom}, true);
  for (const Tick& minor : ticksBetween(std::max(0.0, m_axis.from), m_axis.to(), step / 5)) {
    const float x = area.x(m_axis, minor.value);
    list.AddLine({x, area.top + height - scaled(3)}, {x, area.top + height}, packed(palette.muted, 0.6f));
  }
  for (const Tick& tick : ticksBetween(std::max(0.0, m_axis.from), m_axis.to(), step)) {
    const float x = area.x(m_axis, tick.value);
    list.AddLine({x, area.top + scaled(4)}, {x, area.top + height}, packed(palette.muted));
    list.AddText(look().small, look().small->FontSize, {x + scaled(3), area.top + scaled(2)}, packed(palette.muted),
                 (tick.text + " s").c_str());
  }
  list.PopClipRect();
}

void TimelinePanel::drawRuler(PanelContext& context, const Area& area, float height) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& palette = look().palette;
  ImGui::SetCursorScreenPos({area.left, area.top});
  ImGui::InvisibleButton("ruler", {area.right - area.left, height});
  markItem("timeline/ruler");
  look().map.fact("timeline.from", std::to_string(m_axis.from));
  look().map.fact("timeline.seconds", std::to_string(m_axis.seconds));
  list.AddRectFilled({area.left, area.top}, {area.right, area.top + height}, packed(palette.panelHeader));
  if (context.session) {
    const LoopRange& loop = context.session->loop();
    const float in = std::clamp(area.x(m_axis, loop.in), area.left, area.right);
    const float out = std::clamp(area.x(m_axis, loop.out), area.left, area.right);
    const ImVec4& colour = loop.on ? palette.accent : palette.muted;
    if (loop.on || m_grab == Grab::LoopNew) {
      list.AddRectFilled({in, area.top}, {out, area.top + height}, packed(colour, 0.3f));
      list.AddRectFilled({in, area.top}, {in + scaled(2), area.top + height}, packed(colour));
      list.AddRectFilled({out - scaled(2), area.top}, {out, area.top + height}, packed(colour));
    }
    takeRuler(context, area);
  }
  drawRulerScale(area, height);
}

void TimelinePanel::scrub(PanelContext& context, double time) {
  time = std::max(0.0, time);
  if (std::abs(time - m_scrubbed) < 1e-6) return;
  m_scrubbed = time;
  context.session->seek(time);
}

void TimelinePanel::takeRuler(PanelContext& context, const Area& area) {
  Session& session = *context.session;
  const ImGuiIO& io = ImGui::GetIO();
  const double time = std::max(0.0, m_axis.timeAt(double((io.MousePos.x - area.left) / (area.right - area.left))));
  LoopRange loop = session.loop();
  const auto near = [&](double mark) { return std::abs(area.x(m_axis, mark) - io.MousePos.x) < scaled(kMarkPx); };
  const bool atIn = loop.on && near(loop.in), atOut = loop.on && near(loop.out);
  if (ImGui::IsItemHovered()) {
    if (atIn || atOut) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (m_grab == Grab::None && io.MouseDelta.x == 0 && io.MouseDownDuration[0] < 0)
      ImGui::SetTooltip("Click or drag: go to a time. Shift+drag: loop range. Wheel: zoom, Shift+wheel: pan.");
  }
  if (ImGui::IsItemActivated()) {
    m_grabTime = time;
    m_scrubbed = -1;
    m_grab = io.KeyShift ? Grab::LoopNew : atOut ? Grab::LoopOut : atIn ? Grab::LoopIn : Grab::Playhead;
    m_playAfter = session.playing();
    if (m_grab == Grab::Playhead) session.pause();
  }
  if (m_grab == Grab::None || m_grab == Grab::Pan) return;
  if (m_grab == Grab::Playhead) scrub(context, time);
  if (m_grab == Grab::LoopIn) loop.in = std::min(time, loop.out - 0.05);
  if (m_grab == Grab::LoopOut) loop.out = std::max(time, loop.in + 0.05);
  if (m_grab == Grab::LoopNew && std::abs(time - m_grabTime) > 0.05)
    loop = {std::min(time, m_grabTime), std::max(time, m_grabTime), true};
  if (m_grab != Grab::Playhead) session.setLoop(loop);
  if (ImGui::IsItemActive()) return;
  if (m_grab == Grab::Playhead && m_playAfter) session.play();
  m_grab = Grab::None;
}

}  // namespace windloom::editor
