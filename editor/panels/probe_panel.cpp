#include "editor/panels/probe_panel.hpp"

#include <algorithm>
#include <cmath>

#include "editor/widgets/look.hpp"
#include "editor/widgets/number_field.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {

void ProbePanel::sample(PanelContext& context) {
  if (!context.session) return;
  const double time = context.session->time();
  if (time == m_sampledAt) return;
  const bool restarted = time < m_sampledAt;
  m_sampledAt = time;
  for (auto& [id, trace] : m_traces) trace.live = false;
  for (const Probe& probe : *context.project().probes) {
    Trace& trace = m_traces[probe.id];
    if (trace.speedMps.empty() || restarted) trace.speedMps.assign(kSamples, 0.0f);
    trace.live = true;
    trace.now = context.session->windAt(probe.position);
    trace.speedMps[trace.next] = glm::length(trace.now);
    trace.next = (trace.next + 1) % kSamples;
  }
  std::erase_if(m_traces, [](const auto& entry) { return !entry.second.live; });
}

void ProbePanel::draw(PanelContext& context) {
  if (context.project().probes->empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("No probes yet: press P and click where the wind is to be watched.");
    ImGui::PopTextWrapPos();
    return;
  }
  ImGui::BeginChild("probes");
  for (const Probe& probe : *context.project().probes) {
    const auto found = m_traces.find(probe.id);
    if (found == m_traces.end()) continue;
    const Trace& trace = found->second;
    const float speed = glm::length(trace.now);
    const double degrees = std::atan2(double(trace.now.y), double(trace.now.x)) * 180.0 / 3.14159265358979;
    ImGui::PushID(int(probe.id));
    const std::string name = probe.name.empty() ? "Probe " + std::to_string(probe.id) : probe.name;
    const std::string value = fixed(double(speed), 1) + " m/s",
                      way = "to " + displayNumber(std::round(degrees), 1, false) + "°";
    const float gap = scaled(10), room = ImGui::GetContentRegionAvail().x;
    const float valueWidth = ImGui::CalcTextSize(value.c_str()).x, wayWidth = ImGui::CalcTextSize(way.c_str()).x;
    // A narrow panel leaves out the direction before it cuts the speed.
    const bool withWay = room > valueWidth + wayWidth + gap * 2 + scaled(60);
    const float nameWidth =
        std::max(scaled(24), std::min(scaled(120), room - valueWidth - gap - (withWay ? wayWidth + gap : 0)));
    if (ImGui::Selectable(name.c_str(), context.workspace.selection.contains(probe.id), 0, {nameWidth, 0}))
      context.workspace.selection.replace(probe.id);
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted(value.c_str());
    if (withWay) {
      ImGui::SameLine(0, gap);
      ImGui::TextDisabled("%s", way.c_str());
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("Where the air goes to, from +X towards +Z");
    }
    const float top = std::max(4.0f, *std::max_element(trace.speedMps.begin(), trace.speedMps.end()) * 1.1f);
    ImGui::PlotLines("##trace", trace.speedMps.data(), int(kSamples), int(trace.next), nullptr, 0.0f, top,
                     {ImGui::GetContentRegionAvail().x, scaled(36)});
    ImGui::PopID();
  }
  ImGui::EndChild();
}

}  // namespace windloom::editor
