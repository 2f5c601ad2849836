#include "editor/panels/export_run.hpp"

#include <algorithm>
#include <new>

#include "editor/core/size_text.hpp"
#include "engine/core/contract.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"
#include "engine/session/wind_context.hpp"

namespace windloom::editor {
namespace {

/// On the context's GPU, else on the CPU.
Result<std::unique_ptr<Simulation>> simulationFor(const Project& project, const WindContext& wind) {
  // One core stays with the window.
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1);
  if (wind.context != nullptr) {
    auto simulation = makeSimulation(project, Backend::Auto, wind, threads);
    if (simulation || simulation.error().kind != ErrorKind::Machine) return simulation;
    logWarning("The export runs on the processor: " + simulation.error().text());
  }
  return makeSimulation(project, Backend::Cpu, {}, threads);
}

WindContext contextFor(const Project& project) {
  Result<WindContext> wind = openWindContext(Backend::Auto, project);
  if (wind) return std::move(*wind);
  logWarning("The export runs on the processor: " + wind.error().text());
  return {};
}

ExportRun::Outcome outcomeOf(const Result<BakeReport>& report, const std::filesystem::path& folder) {
  using Kind = ExportRun::Outcome::Kind;
  if (!report) return {Kind::Failed, report.error().text(), folder};
  if (report->cancelled) return {Kind::Cancelled, "Export cancelled; nothing was written.", folder};
  std::string text = "Exported " + std::to_string(report->files.size()) + " files, " +
                     bytesText(static_cast<double>(report->bytes)) + ", to " + folder.string();
  if (report->header.crossfade > 0 && report->seam.seam > report->seam.step) {
    text += ". The loop jumps by up to " + fixed(static_cast<double>(report->seam.seam), 2) + " m/s, other frames by " +
            fixed(static_cast<double>(report->seam.step), 2);
  }
  return {Kind::Done, std::move(text), folder};
}

}  // namespace

ExportRun::~ExportRun() {
  m_cancel = true;
  if (m_worker.joinable()) m_worker.join();
}

void ExportRun::start(Job job) {
  WL_REQUIRE(!running(), "one export at a time");
  m_cancel = m_ended = m_onGpu = false;
  m_part = 0;
  m_phase = BakePhase::Recording;
  m_startedAt = std::chrono::steady_clock::now();
  m_worker = std::thread([this, job = std::move(job)] {
    // An export that doesn't fit into memory is no reason to lose the editor's work.
    try {
      work(job);
    } catch (const std::exception& failure) {
      m_outcome = {Outcome::Kind::Failed, std::string("There is not enough memory for this export: ") + failure.what(),
                   job.request.folder};
    }
    m_ended = true;
  });
}

void ExportRun::work(const Job& job) {
  const BakeRequest& request = job.request;
  const WindContext wind = contextFor(job.project);
  auto simulation = simulationFor(job.project, wind);
  if (!simulation) {
    m_outcome = outcomeOf(simulation.error(), request.folder);
    return;
  }
  if (job.warmUp) (*simulation)->startAt(std::max(0.0, request.plan.from - *job.warmUp));
  m_onGpu = (*simulation)->solver().backend() == Backend::Gpu;
  const auto keepGoing = [this](const BakeProgress& progress) {
    m_phase = progress.phase;
    m_part = progress.part;
    return !m_cancel;
  };
  m_outcome = outcomeOf(bake(**simulation, request, keepGoing), request.folder);
}

ExportRun::Progress ExportRun::progress() const {
  Progress progress{.phase = m_phase, .part = m_part, .leftSeconds = {}, .cancelling = m_cancel, .onGpu = m_onGpu};
  const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_startedAt).count();
  // The first steps are slow: caches, programs that are built.
  if (progress.phase == BakePhase::Recording && progress.part > 0.02)
    progress.leftSeconds = elapsed * (1 - progress.part) / progress.part;
  return progress;
}

std::optional<ExportRun::Outcome> ExportRun::poll() {
  if (!m_ended) return std::nullopt;
  m_worker.join();
  m_ended = false;
  return std::move(m_outcome);
}

}  // namespace windloom::editor
