#pragma once
// The view on the landscape: passes the mouse to tools and camera, shows the session's picture, and draws handles
// and instruments over it.

#include <functional>

#include "editor/core/workspace.hpp"
#include "editor/viewport/instruments.hpp"
#include "editor/viewport/scene_picture.hpp"

namespace windloom::editor {

class Viewport {
 public:
  Overlays overlays;
  GrassView grassView = GrassView::Normal;  ///< Bezier grass only
  BezierCulling bezierCulling;

  /// Lays it out in the current ImGui window, gives it the frame's mouse events, and draws what lies over the
  /// picture. Call it after the panels, so that a click here finds typed values entered.
  void draw(Workspace& workspace, bool hasScene);

  /// Draws the picture where it changed. `pixelRatio`: framebuffer pixels per window pixel; `detail` of the grass.
  /// True where it drew.
  bool updatePicture(Session& session, const Workspace& workspace, float pixelRatio, float detail);
  /// Copies the picture into the window under the user interface.
  void copyPicture(glm::ivec2 framebufferSize, float pixelRatio) const;

  /// The pointer is over it and not over anything on it.
  [[nodiscard]] bool hovered() const { return m_hovered; }
  /// A mouse button that went down in it is still held.
  [[nodiscard]] bool capturing() const { return m_captured != 0; }
  void focusLost() { m_captured = 0; }

 private:
  void passMouse(Workspace& workspace);
  void drawOver(Workspace& workspace, bool hasScene);

  ViewArea m_area;
  ScenePicture m_picture;
  unsigned m_captured = 0;  // bit per button
  bool m_hovered = false, m_overInstrument = false;
  ImVec2 m_lastMouse{-1, -1};
};

}  // namespace windloom::editor
