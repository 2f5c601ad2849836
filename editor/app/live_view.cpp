#include "editor/app/live_view.hpp"

#include "engine/core/log.hpp"

namespace windloom::editor {

Result<std::unique_ptr<LiveView>> LiveView::create() {
  std::unique_ptr<LiveView> view(new LiveView());
  auto context = gpu::adoptCurrentContext();
  if (!context) return context.error();
  view->m_context = std::move(context).value();
  if (view->m_context->info().software) view->m_quality = QualityControl(kSoftwareTarget);
  auto shaders = gpu::ShaderLibrary::create();
  if (!shaders) return shaders.error();
  view->m_shaders = std::move(shaders).value();
  return view;
}

void LiveView::follow(const Document& document) {
  if (m_restart) {
    m_session.reset();
    m_failed.reset();
    m_revision = 0;
    m_strokesTime = 0;
    m_restart = false;
  }
  if (document.revision() == m_revision) return;
  // Tried again with another field only, of the edits: what else could help are new shaders or another driver.
  if (m_failed && m_failed == document.project().field) return;
  m_revision = document.revision();
  if (m_session) {
    if (const Status status = m_session->setProject(document.project()); !status) logError(status.error().text());
    return;
  }
  SessionOptions options;
  options.context = m_context.get();
  options.shaders = m_shaders.get();
  options.liveGrid = m_liveGrid;
  auto session = Session::create(document.project(), options);
  if (!session) {
    m_failed = document.project().field;
    logError("There is no live view: " + session.error().text());
    return;
  }
  m_session = std::move(session).value();
  m_failed.reset();
  m_session->play();
}

void LiveView::advance(double seconds) {
  if (m_session) m_session->advance(seconds);
}

void LiveView::advance(double seconds, BrushStrokes& strokes) {
  if (!m_session) return;
  // Steps since the last frame count, too.
  strokes.age(m_session->time() - m_strokesTime);
  m_session->setTransientForces(strokes.forces());
  m_strokesTime = m_session->time();
  advance(seconds);
}

void LiveView::reloadShaders() {
  const gpu::ShaderLibrary::Reload reload = m_shaders->reloadChanged();
  for (const Problem& problem : reload.problems) logError(problem.text());
  if (reload.problems.empty()) logInfo("Shaders: " + std::to_string(reload.replaced) + " programs replaced");
  m_failed.reset();
  m_revision = 0;
}

void LiveView::setLiveGrid(LiveGrid choice) {
  m_liveGrid = choice;
  if (!m_session) return;
  if (const Status status = m_session->setLiveGrid(choice); !status) logError(status.error().text());
}

void LiveView::frameDone(double wallSeconds, bool drawn) {
  m_frameSeconds += (wallSeconds - m_frameSeconds) * (m_frameSeconds == 0 ? 1.0 : 0.08);
  if (drawn) m_quality.frameDone(wallSeconds * 1000);
}

FrameFacts LiveView::facts() const {
  FrameFacts facts;
  facts.gpu = m_context->info().renderer;
  facts.frameMs = m_frameSeconds * 1000;
  facts.framesPerSecond = m_frameSeconds > 0 ? 1 / m_frameSeconds : 0;
  facts.quality = m_quality.detail();
  facts.fullQuality = m_fullQuality;
  return facts;
}

}  // namespace windloom::editor
