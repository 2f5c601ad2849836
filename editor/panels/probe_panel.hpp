#pragma once
// What the probes feel: speed and heading over the last seconds, all on one time axis, and the wind now.

#include <map>
#include <string>

#include "editor/core/probe_traces.hpp"
#include "editor/core/time_axis.hpp"
#include "editor/panels/panel_context.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {

class ProbePanel {
 public:
  /// Takes what the session sampled at every probe. Call once a frame, drawn or not, after the session advanced.
  void sample(PanelContext& context);
  void draw(PanelContext& context);

 private:
  /// A rectangle with time from left to right and values from bottom to top.
  struct Plot {
    ImVec2 min, max;
    TimeAxis axis;
    double top;  ///< value at the upper end; 0 at the lower one
    [[nodiscard]] ImVec2 at(double time, double value) const {
      return {min.x + float(axis.part(time)) * (max.x - min.x), max.y - float(value / top) * (max.y - min.y)};
    }
  };
  void drawProbe(PanelContext& context, const Probe& probe, const TimeAxis& axis, float height);
  void drawTitle(PanelContext& context, const Probe& probe) const;
  void drawFrame(const Plot& plot, double step, const char* unit) const;
  void drawSpeed(const Plot& plot, Id probe) const;
  void drawHeading(const Plot& plot, Id probe) const;
  void drawHover(const PanelContext& context, const Probe& probe, const Plot& plot, float bottom) const;
  void drawTimes(const TimeAxis& axis);
  [[nodiscard]] float gutter() const;

  ProbeTraces m_traces;
  std::map<Id, SteadyTop> m_tops;
  int m_window = 1;  // which of the windows of time is shown
};

}  // namespace windloom::editor
