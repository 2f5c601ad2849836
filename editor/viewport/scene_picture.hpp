#pragma once
// The session's picture, kept in an offscreen target and copied under the user interface: while nothing in it
// changes, the interface can be drawn without drawing the meadow again. The session tone maps and writes sRGB
// values; nothing after it converts them again.

#include <cstdint>
#include <vector>

#include "editor/core/camera_control.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/session/session.hpp"

namespace windloom::editor {

/// Everything that the picture depends on.
struct SceneRequest {
  EditorCamera camera;
  glm::ivec2 size{0};          ///< framebuffer pixels
  std::uint64_t revision = 0;  ///< of the project
  Overlays overlays;
  GrassView grassView = GrassView::Normal;
  BezierCulling bezierCulling;
  std::vector<Id> selected;
  Id hovered = 0;
  float detail = 1;  ///< of the grass, 0..1
};

class ScenePicture {
 public:
  /// Draws where the request or the session's time differ from what the picture shows; true where it drew a picture
  /// of motion. What rests is drawn a last time as fine as it can be, which tells nothing about the frame time.
  /// A target that can't be made is told in the log, once.
  bool update(Session& session, const SceneRequest& request);

  /// Copies it into the window's framebuffer, its lower left corner at `origin`.
  void copyToWindow(glm::ivec2 origin) const;

 private:
  [[nodiscard]] bool fresh(const SceneRequest& request, double time) const;
  gpu::Framebuffer m_target;
  SceneRequest m_shown;
  double m_time = -1;
  int m_more = 0;  // frames still to draw after a change
  bool m_failed = false;
};

}  // namespace windloom::editor
