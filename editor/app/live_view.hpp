#pragma once
// The session that shows the open document, the OpenGL behind it, and how its frames go.

#include <cstdint>
#include <memory>

#include "editor/core/brush_strokes.hpp"
#include "editor/core/document.hpp"
#include "editor/panels/panel_context.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/session/quality_control.hpp"
#include "engine/session/session.hpp"

namespace windloom::editor {

class LiveView {
 public:
  /// Takes over the context that is current. Fails with Machine where it is too old or there are no shaders.
  static Result<std::unique_ptr<LiveView>> create();

  /// Shows what the document now has. Failures go to the log, once; the last good project stays shown.
  void follow(const Document& document);
  /// Another project was opened: the next follow() makes it a session of its own, so that nothing of the old one's
  /// buffers stays. Until then session() is the old one, as panels may be using it in this frame.
  void restart() { m_restart = true; }
  /// Runs the wind for `seconds` of real time.
  void advance(double seconds);
  /// The same with strokes of the wind brush in the air; they grow older with the wind's time.
  void advance(double seconds, BrushStrokes& strokes);
  /// Builds changed shaders again; problems go to the log and the old ones stay.
  void reloadShaders();

  /// The GPU was reset: there will be no picture any more.
  [[nodiscard]] bool lost() { return m_context->lost(); }
  [[nodiscard]] const gpu::Context& context() const { return *m_context; }
  /// Null where the session can't be made; the editor works on without its picture.
  [[nodiscard]] Session* session() { return m_session.get(); }
  /// How much of the grass to draw.
  [[nodiscard]] float detail() const { return m_fullQuality ? 1.0f : m_quality.detail(); }
  [[nodiscard]] bool fullQuality() const { return m_fullQuality; }
  void setFullQuality(bool on) { m_fullQuality = on; }
  void setLiveGrid(LiveGrid choice);
  [[nodiscard]] LiveGrid liveGrid() const { return m_liveGrid; }

  /// A frame ended after `wallSeconds`; with `drawn` the scene was drawn in it.
  void frameDone(double wallSeconds, bool drawn);
  [[nodiscard]] FrameFacts facts() const;

 private:
  LiveView() = default;
  std::unique_ptr<gpu::Context> m_context;
  std::unique_ptr<gpu::ShaderLibrary> m_shaders;
  std::unique_ptr<Session> m_session;
  QualityControl m_quality;
  Shared<FieldSettings> m_failed;  // of a project that no session could be made for
  bool m_fullQuality = false, m_restart = false;
  LiveGrid m_liveGrid = LiveGrid::Automatic;
  std::uint64_t m_revision = 0;
  double m_strokesTime = 0;   // of the wind when strokes were last given to it
  double m_frameSeconds = 0;  // smoothed
};

}  // namespace windloom::editor
