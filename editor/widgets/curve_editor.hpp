#pragma once
// A root's signal as a curve that can be edited: keys of a curve, handles of the other kinds. What it changes goes
// through editor/core/signal_edits.hpp; a drag is a preview until it is let go.

#include <optional>
#include <vector>

#include "editor/core/shortcut.hpp"
#include "editor/core/signal_edits.hpp"
#include "editor/core/time_axis.hpp"
#include "editor/core/workspace.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {

class CurveEditor {
 public:
  /// Draws the signal of `root` into the rectangle and takes the mouse there. `axis` is the time at its sides.
  void draw(Workspace& workspace, Id root, ImVec2 min, ImVec2 max, const TimeAxis& axis);
  /// Del, A, Esc while the pointer is over it or a drag is under way. True where used.
  bool keyPressed(const KeyPress& press, Workspace& workspace);
  /// Ends a drag without a change.
  void cancel(Workspace& workspace);
  [[nodiscard]] bool hovered() const { return m_hovered; }
  [[nodiscard]] bool dragging() const { return m_drag != Drag::None; }
  /// The stretch of time in which the signal shows all it does.
  static TimeAxis frameOf(const Signal& signal);

 private:
  enum class Drag { None, Keys, Handle, Box, Ended };
  struct View;
  struct Shown {
    std::size_t key = 0;
    ImVec2 at;
  };
  void follow(const Workspace& workspace, Id root);
  void drawGrid(const View& view) const;
  void drawCourse(const View& view, const Signal& signal) const;
  void drawKeys(const View& view, const Signal& signal);
  void drawHandles(const View& view, const Signal& signal) const;
  void takeMouse(Workspace& workspace, const View& view);
  void press(Workspace& workspace, const View& view, const Signal& signal);
  void pressKey(std::size_t key);
  bool addKey(Workspace& workspace, const View& view, ImVec2 at);
  void dragTo(Workspace& workspace, const View& view);
  void dragKeys(Workspace& workspace, const View& view);
  void letGo(Workspace& workspace, const View& view);
  void selectBox(const View& view);
  void drawMenu(Workspace& workspace);
  void drawKeyMenu(Workspace& workspace, const Signal& signal);
  [[nodiscard]] std::optional<Shown> keyNear(ImVec2 at) const;
  [[nodiscard]] bool selected(std::size_t key) const;
  void apply(Workspace& workspace, Edit edit);

  Id m_root = 0;
  std::vector<std::size_t> m_selected;  // ascending
  std::vector<Shown> m_shown;           // of every round on the screen
  Drag m_drag = Drag::None;
  bool m_hovered = false, m_moved = false;
  std::size_t m_grabbed = 0;
  SignalHandle m_handle = SignalHandle::Delay;
  ImVec2 m_pressedAt, m_menuAt;
  double m_around = 0, m_grabTime = 0, m_grabValue = 0;
  double m_top = 1.25;  // of the scale; stays while dragging
  int m_gesture = 0;    // makes the edits of one gesture one undo step
};

}  // namespace windloom::editor
