#include "editor/panels/clipping_view.hpp"

#include <algorithm>
#include <cmath>

#include "editor/widgets/look.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

constexpr double kEveryS = 0.5;

/// "no", "< 0.1% of", "0.3% of", "12% of" (cells).
std::string partText(float part) {
  const double percent = double(part) * 100;
  if (percent <= 0) return "no";
  if (percent < 0.1) return "< 0.1% of";
  return fixed(percent, percent < 10 ? 1 : 0) + "% of";
}

}  // namespace

void ClippingView::sample(Session& session, double seconds, float fullScale) {
  const bool changed = fullScale != m_fullScale;
  if (!changed && seconds - m_at < kEveryS) return;
  session.askField();
  const std::shared_ptr<const FieldSnapshot> kept = session.field();
  const FieldSnapshot& field = *kept;
  if (field.number == 0 || (!changed && field.number == m_number)) return;
  m_at = seconds;
  m_number = field.number;
  m_fullScale = fullScale;
  m_histogram = speedHistogram(field.cells, fullScale > 0 ? fullScale : 1e-3f);
  if (fullScale <= 0) m_histogram.clipped = 0;
}

void ClippingView::draw() const {
  if (m_number == 0) return;
  const Palette& palette = look().palette;
  const ImVec2 min = ImGui::GetCursorScreenPos(), size(ImGui::GetContentRegionAvail().x, scaled(44));
  const ImVec2 max(min.x + size.x, min.y + size.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, packed(palette.border, 0.6f));
  const float full = m_fullScale > 0 ? m_fullScale : m_histogram.top;
  const float edge = min.x + size.x * std::min(1.0f, full / m_histogram.top);
  const float bar = size.x / float(SpeedHistogram::kBins);
  for (int i = 0; i < SpeedHistogram::kBins; ++i) {
    const float part = m_histogram.parts[std::size_t(i)];
    if (part <= 0) continue;
    // Few cells are fast, and they are what matters: the root keeps them visible.
    const float top = max.y - std::max(scaled(1), std::sqrt(part) * size.y), left = min.x + bar * float(i);
    const bool over = left + bar / 2 > edge;
    list.AddRectFilled({left, top}, {left + bar - scaled(1), max.y}, packed(over ? palette.warning : palette.accent));
  }
  if (m_fullScale > 0) list.AddLine({edge, min.y}, {edge, max.y}, packed(palette.text), scaled(1));
  ImGui::Dummy(size);
  markItem("export/clipping");
  const std::string fastest = fixed(double(m_histogram.fastest), 1) + " m/s";
  const std::string text = m_fullScale > 0 ? "Now " + partText(m_histogram.clipped) + " cells clip, fastest " + fastest
                                           : "Speeds now, fastest " + fastest;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(m_histogram.clipped > 0 ? palette.warning : palette.muted, "%s", text.c_str());
  ImGui::PopTextWrapPos();
  look().map.fact("export.clipping", text);
}

}  // namespace windloom::editor
