#include "editor/panels/probe_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/core/text.hpp"

namespace windloom::editor {

namespace {

constexpr std::array<double, 4> kWindowsS{5, 15, 30, 120};
constexpr double kLeastTopMps = 4;
constexpr float kLeastHeightPx = 104;  // of a probe with both plots
constexpr float kHeadingPart = 0.36f;

std::string windText(glm::vec2 wind) {
  const auto heading = headingDeg(wind);
  std::string text = fixed(double(glm::length(wind)), 1) + " m/s";
  if (heading) text += "  to " + fixed(double(*heading), 0) + "°";
  return text;
}

/// Gridlines of a heading: as many as have room for their labels.
double headingStep(float heightPx) {
  const float line = look().small->FontSize;
  return heightPx > 5 * line ? 90 : heightPx > 3 * line ? 180 : 360;
}

std::string nameOf(const Probe& probe) {
  return probe.name.empty() ? "Probe " + std::to_string(probe.id) : probe.name;
}

}  // namespace

void ProbePanel::sample(PanelContext& context) {
  if (!context.session) return;
  const std::vector<Probe>& probes = *context.project().probes;
  m_traces.follow(probes);
  std::vector<glm::vec2> places;
  for (const Probe& probe : probes) places.push_back(probe.position);
  context.session->watch(std::move(places));
  m_traces.cutAfter(context.session->time());
  for (const WindSample& sample : context.session->takeSamples()) m_traces.add(sample.time, sample.place, sample.wind);
  std::erase_if(m_tops,
                [&](const auto& top) { return std::ranges::find(probes, top.first, &Probe::id) == probes.end(); });
}

float ProbePanel::gutter() const {
  return look().small->CalcTextSizeA(look().small->FontSize, FLT_MAX, 0, "100 m/s").x + scaled(8);
}

void ProbePanel::drawTitle(PanelContext& context, const Probe& probe) const {
  const auto& samples = m_traces.samples(probe.id);
  const glm::vec2 wind = samples.empty() ? context.session->windAt(probe.position) : samples.back().wind;
  const std::string both = windText(wind), speed = both.substr(0, both.find("  "));
  const float room = ImGui::GetContentRegionAvail().x, gap = scaled(8);
  // A narrow panel leaves out the heading before it cuts the speed.
  const bool withHeading = ImGui::CalcTextSize(both.c_str()).x + gap + scaled(60) < room;
  const std::string& value = withHeading ? both : speed;
  const float width = std::max(scaled(24), room - ImGui::CalcTextSize(value.c_str()).x - gap);
  if (ImGui::Selectable(nameOf(probe).c_str(), context.workspace.selection.contains(probe.id), 0, {width, 0}))
    context.workspace.selection.replace(probe.id);
  ImGui::SameLine(0, gap);
  ImGui::TextUnformatted(value.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("Speed, and where the air goes to: 0° is +X, 90° is +Z");
  look().map.fact("probe." + std::to_string(probe.id), value);
}

/// Back, gridlines and labels.
void ProbePanel::drawFrame(const Plot& plot, double step, const char* unit) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& palette = look().palette;
  list.AddRectFilled(plot.min, plot.max, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(2));
  const double seconds = tickStep(plot.axis.seconds * double(scaled(52) / (plot.max.x - plot.min.x)));
  for (const Tick& tick : ticksBetween(plot.axis.from, plot.axis.to(), seconds)) {
    const float x = plot.at(tick.value, 0).x;
    list.AddLine({x, plot.min.y}, {x, plot.max.y}, packed(palette.muted, 0.25f));
  }
  const float half = look().small->FontSize / 2;
  for (const Tick& tick : ticksBetween(0, plot.top, step)) {
    const float y = plot.at(plot.axis.from, tick.value).y;
    list.AddLine({plot.min.x, y}, {plot.max.x, y}, packed(palette.muted, 0.25f));
    const bool last = tick.value + step > plot.top + 1e-9;
    const std::string text = tick.text + (last ? unit : "");
    const float width = look().small->CalcTextSizeA(look().small->FontSize, FLT_MAX, 0, text.c_str()).x;
    const float top = std::clamp(y - half, plot.min.y, plot.max.y - 2 * half);
    list.AddText(look().small, look().small->FontSize, {plot.min.x - width - scaled(4), top}, packed(palette.muted),
                 text.c_str());
  }
}

void ProbePanel::drawSpeed(const Plot& plot, Id probe) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> line;
  const ImU32 colour = packed(look().palette.accent);
  const auto flush = [&] {
    if (line.size() == 1) list.AddCircleFilled(line[0], scaled(1.5f), colour);
    if (line.size() > 1) list.AddPolyline(line.data(), int(line.size()), colour, ImDrawFlags_None, scaled(1.5f));
    line.clear();
  };
  list.PushClipRect(plot.min, plot.max, true);
  double last = -1e9;
  for (const TraceSample& sample : m_traces.samples(probe)) {
    if (sample.time < plot.axis.from - ProbeTraces::kGapS) continue;
    if (sample.time - last > ProbeTraces::kGapS) flush();
    last = sample.time;
    const ImVec2 at = plot.at(sample.time, double(glm::length(sample.wind)));
    if (line.empty() || at.x - line.back().x >= 0.75f) line.push_back(at);
  }
  flush();
  list.PopClipRect();
}

/// Points instead of a line, which would jump across the plot where the heading passes 360 degrees.
void ProbePanel::drawHeading(const Plot& plot, Id probe) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(plot.min, plot.max, true);
  float lastX = -1e9f;
  const float size = scaled(1.2f);
  for (const TraceSample& sample : m_traces.samples(probe)) {
    const auto heading = headingDeg(sample.wind);
    if (!heading || sample.time < plot.axis.from) continue;
    const ImVec2 at = plot.at(sample.time, double(*heading));
    if (at.x - lastX < 0.75f) continue;
    lastX = at.x;
    list.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, packed(look().palette.warning));
  }
  list.PopClipRect();
}

void ProbePanel::drawHover(const PanelContext& context, const Probe& probe, const Plot& plot, float bottom) const {
  const float x = ImGui::GetIO().MousePos.x;
  const double time = plot.axis.timeAt(double((x - plot.min.x) / (plot.max.x - plot.min.x)));
  ImGui::GetWindowDrawList()->AddLine({x, plot.min.y}, {x, bottom}, packed(look().palette.text, 0.6f));
  const auto wind = m_traces.at(probe.id, time);
  const std::string at = nameOf(probe) + "\n" + fixed(std::max(0.0, time), 2) + " s: ";
  const bool future = time > context.session->time();
  ImGui::SetTooltip("%s%s", at.c_str(), wind ? windText(*wind).c_str() : future ? "not yet" : "no sample");
}

void ProbePanel::drawProbe(PanelContext& context, const Probe& probe, const TimeAxis& axis, float height) {
  ImGui::PushID(int(probe.id));
  drawTitle(context, probe);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x - scaled(2), left = at.x + gutter();
  const float plots = height - ImGui::GetTextLineHeightWithSpacing() - scaled(6);
  double greatest = 0;
  for (const TraceSample& sample : m_traces.samples(probe.id))
    if (sample.time >= axis.from) greatest = std::max(greatest, double(glm::length(sample.wind)));
  const double top = m_tops.try_emplace(probe.id, kLeastTopMps).first->second.update(greatest, ImGui::GetTime());
  const float headingTop = at.y + plots * (1 - kHeadingPart) + scaled(4);
  const Plot speed{{left, at.y}, {right, headingTop - scaled(6)}, axis, top};
  const Plot heading{{left, headingTop}, {right, at.y + plots}, axis, 360};
  ImGui::InvisibleButton("plots", {right - at.x, plots});
  markItem("probe.plot/" + std::to_string(probe.id));
  if (ImGui::IsItemClicked()) context.workspace.selection.replace(probe.id);
  const bool hovered = ImGui::IsItemHovered() && ImGui::GetIO().MousePos.x >= left;
  const double labelRoom = double(look().small->FontSize * 1.4f / (speed.max.y - speed.min.y));
  drawFrame(speed, std::max(1.0, tickStep(top * labelRoom)), " m/s");
  drawFrame(heading, headingStep(heading.max.y - heading.min.y), "°");
  drawSpeed(speed, probe.id);
  drawHeading(heading, probe.id);
  const float now = speed.at(context.session->time(), 0).x;
  ImGui::GetWindowDrawList()->AddLine({now, speed.min.y}, {now, heading.max.y}, packed(look().palette.text, 0.7f));
  if (hovered) drawHover(context, probe, speed, heading.max.y);
  ImGui::Dummy({0, scaled(2)});
  ImGui::PopID();
}

/// The shared axis, and the choice how much of it is shown.
void ProbePanel::drawTimes(const TimeAxis& axis) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = at.x + gutter(), right = at.x + ImGui::GetContentRegionAvail().x - scaled(2);
  const std::string shown = fixed(kWindowsS[std::size_t(m_window)], 0) + " s";
  ImGui::PushFont(look().small);
  ImGui::SetNextItemWidth(gutter() - scaled(6));
  if (ImGui::BeginCombo("##window", shown.c_str(), ImGuiComboFlags_NoArrowButton)) {
    for (std::size_t i = 0; i < kWindowsS.size(); ++i)
      if (ImGui::Selectable((fixed(kWindowsS[i], 0) + " s").c_str(), int(i) == m_window)) m_window = int(i);
    ImGui::EndCombo();
  }
  markItem("probe.window");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("How much time the plots show");
  ImGui::PopFont();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = right - left, y = at.y + ImGui::GetStyle().FramePadding.y;
  const double step = tickStep(axis.seconds * double(scaled(52) / width));
  for (const Tick& tick : ticksBetween(std::max(0.0, axis.from), axis.to(), step)) {
    const std::string text = tick.text + " s";
    const float half = look().small->CalcTextSizeA(look().small->FontSize, FLT_MAX, 0, text.c_str()).x / 2;
    const float x = std::max(left + float(axis.part(tick.value)) * width, left + half - scaled(4));
    if (x + half > right + scaled(2)) continue;
    list.AddText(look().small, look().small->FontSize, {x - half, y}, packed(look().palette.muted), text.c_str());
  }
}

void ProbePanel::draw(PanelContext& context) {
  const std::vector<Probe>& probes = *context.project().probes;
  if (probes.empty() || !context.session) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("No probes yet: press P and click where the wind is to be watched.");
    ImGui::PopTextWrapPos();
    return;
  }
  const double window = kWindowsS[std::size_t(m_window)];
  const TimeAxis axis{std::max(0.0, context.session->time() - window * 0.98), window};
  const float times = look().small->FontSize + 2 * ImGui::GetStyle().FramePadding.y + scaled(2);
  const float room = ImGui::GetContentRegionAvail().y - times - ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("probes", {0, room});
  const float shown = ImGui::GetContentRegionAvail().y / float(std::min<std::size_t>(probes.size(), 3));
  const float height = std::max(scaled(kLeastHeightPx), shown - scaled(6));
  for (const Probe& probe : probes) drawProbe(context, probe, axis, height);
  ImGui::EndChild();
  drawTimes(axis);
}

}  // namespace windloom::editor
