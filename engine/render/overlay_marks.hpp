#pragma once
// The overlay's marks from a project: pure, on the CPU, when the project or what is marked changes.

#include <vector>

#include "engine/model/graph_links.hpp"
#include "engine/render/frame_renderer.hpp"
#include "engine/render/overlay_signals.hpp"
#include "shaders/shared/overlay_mark.h"

namespace windloom {

using shared::OverlayMark;

struct OverlayMarks {
  std::vector<OverlayMark> arrows;
  std::vector<OverlayMark> points;  ///< and probes
  std::vector<OverlayMark> outlines;
};

/// Hidden things are left out; arrows need both their points. `signals` must have been built for the graph.
OverlayMarks makeOverlayMarks(const Project& project, const GraphLinks& links, const OverlaySignals& signals,
                              const Highlight& highlight);

/// Marks and signals of the project last seen, made again only where something they show has changed.
class MarkCache {
 public:
  struct Change {
    bool marks = false, levels = false;
  };
  /// What changed since the last call.
  Change update(const FrameInput& input);

  [[nodiscard]] const OverlayMarks& marks() const { return m_marks; }
  [[nodiscard]] const OverlaySignals& signals() const { return m_signals; }

 private:
  [[nodiscard]] bool fresh(const FrameInput& input) const;

  Shared<WindGraph> m_graph;
  Shared<std::vector<Obstacle>> m_obstacles;
  Shared<std::vector<Probe>> m_probes;
  bool m_evaluated = false;
  std::vector<Id> m_selected;
  Id m_hovered = 0;
  OverlayMarks m_marks;
  OverlaySignals m_signals;
};

}  // namespace windloom
