#pragma once
// Time: play, pause, step, restart, loop; a ruler to scrub along; a lane for each tree with its signal and when the
// wind reaches its points; the curve of the selected tree to edit.

#include <vector>

#include "editor/core/time_axis.hpp"
#include "editor/panels/panel_context.hpp"
#include "editor/widgets/curve_editor.hpp"

namespace windloom::editor {

/// When the signals of a tree's root reach its points.
struct TreeLane {
  Id root = 0;
  struct Mark {
    double time = 0;  ///< s after the root's onset
    Id point = 0;
  };
  std::vector<Mark> marks;  ///< by ascending time
};

class TimelinePanel {
 public:
  void draw(PanelContext& context);
  /// Keys that mean something here: those of the curve and F, Home while the pointer is over the lanes; Esc ends a
  /// seek. True where used.
  bool keyPressed(const KeyPress& press, PanelContext& context);
  void focusLost(Workspace& workspace) { m_curve.cancel(workspace); }
  /// The tree whose curve is shown: the selected root's, or the one that reaches what is selected; 0: none.
  [[nodiscard]] Id shownRoot() const { return m_root; }

 private:
  enum class Grab { None, Playhead, LoopIn, LoopOut, LoopNew, Pan };
  struct Area {
    float left, right, top, bottom;  ///< px, of the ruler and the lanes, without labels
    [[nodiscard]] float x(const TimeAxis& axis, double time) const {
      return left + float(axis.part(time)) * (right - left);
    }
  };
  void followProject(const PanelContext& context);
  void drawTransport(PanelContext& context);
  void drawSeek(PanelContext& context);
  void cancelSeek(Session& session);
  void drawRuler(PanelContext& context, const Area& area, float height);
  void drawRulerScale(const Area& area, float height) const;
  void takeRuler(PanelContext& context, const Area& area);
  void scrub(PanelContext& context, double time);
  void drawLanes(PanelContext& context, const Area& area);
  void drawLane(PanelContext& context, const TreeLane& lane, const Area& area, float height);
  void drawOpenLane(PanelContext& context, const TreeLane& lane, const Area& area, float height);
  void laneHover(PanelContext& context, const TreeLane& lane, const Area& area) const;
  void drawMarks(const Area& area, const TreeLane& lane, double delay, float top, float bottom) const;
  void drawPlayhead(const PanelContext& context, const Area& area, bool head) const;
  void takeAxis(const Area& area);
  void selectRoot(PanelContext& context, Id root) const;

  TimeAxis m_axis;
  CurveEditor m_curve;
  std::vector<TreeLane> m_lanes;
  std::vector<Id> m_reachedBy;  // root by index of points
  Shared<WindGraph> m_graph;    // that the lanes were made of
  Id m_root = 0, m_opened = 0;  // m_opened: whose lane was scrolled to
  Grab m_grab = Grab::None;
  double m_grabTime = 0, m_scrubbed = -1, m_lastNow = 0, m_seekSince = -1;
  bool m_playAfter = false, m_hovered = false;
};

}  // namespace windloom::editor
