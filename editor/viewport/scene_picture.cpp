#include "editor/viewport/scene_picture.hpp"

#include "engine/core/log.hpp"

namespace windloom::editor {

namespace {

// The statistics of a picture arrive some frames later, and the quality follows them: a changed picture is drawn
// a few times more before it rests.
constexpr int kSettleFrames = 6;

bool sameCamera(const EditorCamera& a, const EditorCamera& b) {
  return a.target == b.target && a.yaw == b.yaw && a.pitch == b.pitch && a.distance == b.distance &&
         a.fieldOfView == b.fieldOfView && a.orthographic == b.orthographic;
}

ViewCamera viewCamera(const EditorCamera& camera) {
  const CameraPose pose = camera.pose();
  ViewCamera view;
  view.position = pose.position;
  view.target = pose.target;
  view.up = pose.up;
  view.fieldOfView = pose.fieldOfView;
  view.orthographic = pose.orthographic;
  view.orthographicHeight = pose.orthographicHeight;
  view.nearPlane = pose.nearPlane;
  view.farPlane = pose.farPlane;
  return view;
}

}  // namespace

bool ScenePicture::fresh(const SceneRequest& request, double time) const {
  return m_shown.size == request.size && m_shown.revision == request.revision && m_time == time &&
         m_shown.hovered == request.hovered && m_shown.detail == request.detail &&
         m_shown.selected == request.selected && sameCamera(m_shown.camera, request.camera) &&
         m_shown.overlays == request.overlays && m_shown.grassView == request.grassView &&
         m_shown.bezierCulling == request.bezierCulling;
}

bool ScenePicture::update(Session& session, const SceneRequest& request) {
  if (request.size.x < 1 || request.size.y < 1) return false;
  bool still = false;
  if (fresh(request, session.time())) {
    if (m_more == 0) return false;
    --m_more;
    still = m_more == 0;
  } else {
    m_more = kSettleFrames;
  }
  if (m_target.size() != request.size) {
    m_target = {};
    auto made = gpu::Framebuffer::create("viewport", request.size, {.colour = GL_RGBA8, .depth = 0});
    if (!made) {
      if (!m_failed) logError(made.error().text());
      m_failed = true;
      return false;
    }
    m_failed = false;
    m_target = std::move(made).value();
  }
  m_shown = request;
  m_time = session.time();
  Session::View view;
  view.camera = viewCamera(request.camera);
  view.size = request.size;
  view.framebuffer = m_target.name();
  view.overlays = request.overlays;
  view.grassView = request.grassView;
  view.bezierCulling = request.bezierCulling;
  view.highlight = {m_shown.selected, m_shown.hovered};
  view.quality = {.detail = request.detail, .still = still, .complete = false};
  session.draw(view);
  // Blades that are still being placed come with one of the next pictures.
  if (!session.status().frame.complete) m_more = kSettleFrames;
  return !still || m_more > 0;
}

void ScenePicture::copyToWindow(glm::ivec2 origin) const {
  if (m_target.name() != 0) m_target.resolveColour(0, origin);
}

}  // namespace windloom::editor
