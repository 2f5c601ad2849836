#include "engine/session/session.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "engine/core/log.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/grass/touch_clock.hpp"
#include "engine/session/live_grid.hpp"
#include "engine/session/wind_readout.hpp"
#include "engine/session/wind_watch.hpp"

namespace windloom {
namespace {

using Clock = std::chrono::steady_clock;

// Wall time the steps of one advance() may take: half of the frame, within these bounds.
constexpr double kLeastBudgetMs = 6.0, kMostBudgetMs = 40.0;
// And of a slice of a seek: the window still answers, and most of the time goes into steps.
constexpr double kSeekSliceMs = 40.0;

double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// The median of the last few values.
class RecentMedian {
 public:
  void add(double value) { m_values[m_count++ % m_values.size()] = value; }
  [[nodiscard]] double value() const {
    std::array<double, 15> sorted = m_values;
    const std::size_t count = std::min(m_count, sorted.size());
    if (count == 0) return 0.0;
    std::nth_element(sorted.begin(), sorted.begin() + count / 2, sorted.begin() + count);
    return sorted[count / 2];
  }
  void clear() { m_count = 0; }

 private:
  std::array<double, 15> m_values{};
  std::size_t m_count = 0;
};

class SessionImpl final : public Session {
 public:
  SessionImpl(const SessionOptions& options, std::unique_ptr<FrameRenderer> renderer, WindReadout readout,
              WindWatch watch)
      : m_options(options), m_renderer(std::move(renderer)), m_readout(std::move(readout)), m_watch(std::move(watch)) {}

  Status start(const Project& project);
  Status setProject(const Project& project) override;
  Status setLiveGrid(LiveGrid choice) override;

  void play() override { m_playing = true; }
  void pause() override { m_playing = false; }
  [[nodiscard]] bool playing() const override { return m_playing; }
  void stepOnce() override;
  void restart() override;
  void seek(double seconds) override;
  void cancelSeek() override;
  [[nodiscard]] std::optional<SeekProgress> seeking() const override;
  void setLoop(const LoopRange& loop) override;
  [[nodiscard]] const LoopRange& loop() const override { return m_loop; }
  [[nodiscard]] double time() const override { return m_simulation->time(); }
  void setTransientForces(std::span<const ArrowForce> forces) override;
  void advance(double wallSeconds) override;
  void runTo(double seconds) override;
  void draw(const View& view) override;
  glm::vec2 windAt(glm::vec2 world) override;
  void watch(std::vector<glm::vec2> places) override { m_watch.setPlaces(std::move(places)); }
  std::vector<WindSample> takeSamples() override { return m_watch.take(); }
  void askField() override { m_field.ask(*m_simulation); }
  std::shared_ptr<const FieldSnapshot> field() override { return m_field.newest(); }
  [[nodiscard]] const SessionStatus& status() override;

 private:
  struct Seek {
    long from = 0, target = 0;  // steps
  };
  [[nodiscard]] double timeStep() const { return static_cast<double>(m_simulation->project().field->timeStep); }
  [[nodiscard]] bool onCpu() { return m_simulation->solver().backend() == Backend::Cpu; }
  Status fitGrid();
  void step();
  void fitGridToStep(double stepMs);
  void seekSlice();
  void timeJumped();
  void windChanged();
  WindTexture windTexture();
  bool uploadWind();
  FrameInput frameInput();

  SessionOptions m_options;
  std::unique_ptr<FrameRenderer> m_renderer;
  WindReadout m_readout;
  WindWatch m_watch;
  FieldReadout m_field;
  LoopRange m_loop;
  std::optional<Seek> m_seek;
  std::vector<ArrowForce> m_transient;
  std::unique_ptr<Simulation> m_simulation;
  std::optional<LiveGridControl> m_grid;  // where the live grid may be coarser
  LiveGrid m_liveGrid = LiveGrid::Automatic;
  gpu::Texture m_windCopy;  // of the CPU backend's field
  long m_copiedStep = -1;
  bool m_complete = true;  // as the last view: whether pictures wait for blades
  bool m_playing = false, m_uploadFailed = false;
  double m_owedSeconds = 0;  // of simulated time
  RecentMedian m_stepMs;
  SessionStatus m_status;
};

Status SessionImpl::start(const Project& project) {
  SimulationOptions options;
  options.backend = m_options.backend;
  options.context = m_options.context;
  options.shaders = m_options.shaders;
  options.checkpoints = true;
  m_liveGrid = m_options.liveGrid;
  // Which backend runs is known once there is one; until then the grid is small, since making a full one and
  // throwing it away would cost the editor's start.
  if (m_liveGrid == LiveGrid::Automatic) options.resolution = LiveGridControl(*project.field).resolution();
  Result<std::unique_ptr<Simulation>> simulation = Simulation::create(project, options);
  if (!simulation) return simulation.error();
  m_simulation = std::move(*simulation);
  return fitGrid();
}

/// Brings the live grid to what backend and choice ask for.
Status SessionImpl::fitGrid() {
  m_stepMs.clear();
  windChanged();
  m_grid.reset();
  if (m_liveGrid == LiveGrid::Full) return m_simulation->setResolution(std::nullopt);
  // Most GPUs hold any project's grid; on a CPU a first step of it could stop the window for long.
  m_grid.emplace(*m_simulation->project().field, onCpu() ? LiveGridStart::Coarse : LiveGridStart::Project);
  return m_simulation->setResolution(m_grid->resolution());
}

Status SessionImpl::setProject(const Project& project) {
  const Shared<FieldSettings> field = m_simulation->project().field;
  const Shared<SolverSettings> solver = m_simulation->project().solver;
  const double oldStep = timeStep();
  if (Status set = m_simulation->setProject(project); !set) return set;
  windChanged();
  m_simulation->pinCheckpoint(m_loop.on ? m_simulation->stepAt(m_loop.in) : 0);
  // What was done of the way so far belongs to the old project.
  const bool otherWay = !m_simulation->runsFromStart() || timeStep() != oldStep;
  if (m_seek && otherWay) seek(static_cast<double>(m_seek->target) * oldStep);
  if (field != project.field || solver->backend != project.solver->backend) return fitGrid();
  return Done{};
}

Status SessionImpl::setLiveGrid(LiveGrid choice) {
  if (choice == m_liveGrid) return Done{};
  m_liveGrid = choice;
  return fitGrid();
}

/// Copies of the wind are not of what blows now, though no step was done.
void SessionImpl::windChanged() {
  m_copiedStep = -1;
  m_field.touch();
}

void SessionImpl::timeJumped() {
  m_owedSeconds = 0;
  windChanged();
  m_readout.forget();
  m_watch.timeJumped();
}

void SessionImpl::restart() {
  m_seek.reset();
  m_simulation->restart();
  timeJumped();
}

void SessionImpl::stepOnce() {
  m_seek.reset();
  step();
}

void SessionImpl::seek(double seconds) {
  const long target = m_simulation->stepAt(seconds), before = m_simulation->steps();
  if (m_seek && !m_simulation->runsFromStart()) m_simulation->restart();
  m_simulation->goTowards(target);
  if (m_simulation->steps() != before) timeJumped();
  m_seek.reset();
  if (m_simulation->steps() < target) m_seek = Seek{m_simulation->steps(), target};
}

void SessionImpl::cancelSeek() {
  if (!m_seek) return;
  m_seek.reset();
  m_playing = false;
}

std::optional<SeekProgress> SessionImpl::seeking() const {
  if (!m_seek) return std::nullopt;
  const double done = static_cast<double>(m_simulation->steps() - m_seek->from);
  const double all = static_cast<double>(std::max(1L, m_seek->target - m_seek->from));
  return SeekProgress{static_cast<double>(m_seek->target) * timeStep(), static_cast<float>(done / all)};
}

void SessionImpl::setLoop(const LoopRange& loop) {
  m_loop = loop;
  m_loop.in = std::max(0.0, loop.in);
  m_loop.out = std::max(m_loop.in + timeStep(), loop.out);
  m_simulation->pinCheckpoint(m_loop.on ? m_simulation->stepAt(m_loop.in) : 0);
}

void SessionImpl::setTransientForces(std::span<const ArrowForce> forces) {
  m_transient.assign(forces.begin(), forces.end());
}

/// Steps towards the target for a part of a frame.
void SessionImpl::seekSlice() {
  const auto start = Clock::now();
  double usedMs = 0;
  while (m_simulation->steps() < m_seek->target) {
    step();
    usedMs = std::max(msSince(start), usedMs + (onCpu() ? 0.0 : m_stepMs.value()));
    if (usedMs + m_stepMs.value() > kSeekSliceMs) return;
  }
  m_seek.reset();
}

void SessionImpl::step() {
  // What is combed while time is on its way would not be the wind that running from the start gives.
  m_simulation->setTransientForces(m_seek ? std::span<const ArrowForce>() : m_transient);
  const auto start = Clock::now();
  m_simulation->step();
  const double wallMs = msSince(start);
  const double stepMs = onCpu() ? wallMs : std::max(wallMs, m_simulation->solver().diagnostics().stepMs);
  m_stepMs.add(stepMs);
  m_watch.stepDone(*m_simulation);
  // On the way to a time the grid stays: another one would begin another run.
  if (!m_seek) fitGridToStep(stepMs);
}

void SessionImpl::fitGridToStep(double stepMs) {
  if (!m_grid || !m_grid->stepDone(stepMs)) return;
  if (Status set = m_simulation->setResolution(m_grid->resolution()); !set) logError(set.error().text());
  m_stepMs.clear();
  windChanged();
}

void SessionImpl::advance(double wallSeconds) {
  if (m_seek) return seekSlice();
  if (!m_playing || !(wallSeconds > 0.0)) return;
  const double dt = timeStep();
  const double budgetMs = std::clamp(500.0 * wallSeconds, kLeastBudgetMs, kMostBudgetMs);
  m_owedSeconds += wallSeconds;
  const auto start = Clock::now();
  double usedMs = 0, simulated = 0;
  // Always one step where one is due, however slow: time slows down but never stops.
  while (m_owedSeconds >= dt) {
    step();
    m_owedSeconds -= dt;
    simulated += dt;
    if (m_loop.on && m_simulation->steps() >= m_simulation->stepAt(m_loop.out)) {
      seek(m_loop.in);
      break;
    }
    usedMs = std::max(msSince(start), usedMs + (onCpu() ? 0.0 : m_stepMs.value()));
    if (usedMs + m_stepMs.value() > budgetMs) break;
  }
  const double scale = simulated / wallSeconds;
  m_owedSeconds = std::min(m_owedSeconds, dt);
  // Steps fall unevenly on frames: the shown scale is smoothed over about a second.
  const double weight = std::min(1.0, wallSeconds / 0.8);
  m_status.timeScale += (scale - m_status.timeScale) * weight;
}

void SessionImpl::runTo(double seconds) {
  m_simulation->setTransientForces(m_transient);
  const bool remembers = !m_simulation->project().colliders->empty() ||
                         m_simulation->project().grass->deformation == Deformation::Inertial;
  if (remembers) m_simulation->runTo(seconds - kTouchMemoryS);
  // Each step of the last seconds, so that the grass has been through what led to that time.
  while (remembers && m_simulation->steps() < m_simulation->stepAt(seconds)) {
    m_simulation->runTo(m_simulation->time() + timeStep());
    m_renderer->advance(frameInput());
  }
  m_simulation->runTo(seconds);
  windChanged();
}

/// The CPU backend's field as a texture, copied when a step has been done since the last time.
bool SessionImpl::uploadWind() {
  const GridMapping& grid = m_simulation->solver().grid();
  if (glm::ivec2(m_windCopy.size()) != grid.resolution) {
    Result<gpu::Texture> texture =
        gpu::Texture::create2D("wind copy", grid.resolution, GL_RG32F, {.filter = gpu::Filter::Linear});
    if (!texture) {
      if (!m_uploadFailed) logError(texture.error().text());
      m_uploadFailed = true;
      return false;
    }
    m_uploadFailed = false;
    m_windCopy = std::move(*texture);
    m_copiedStep = -1;
  }
  if (m_copiedStep != m_simulation->steps()) {
    m_windCopy.upload(GL_RG, GL_FLOAT, m_simulation->velocity().data());
    m_copiedStep = m_simulation->steps();
  }
  return true;
}

WindTexture SessionImpl::windTexture() {
  WindSolver& solver = m_simulation->solver();
  if (!onCpu()) return {solver.velocityTexture(), solver.grid()};
  return uploadWind() ? WindTexture{m_windCopy.name(), solver.grid()} : WindTexture{};
}

FrameInput SessionImpl::frameInput() {
  FrameInput input;
  input.project = &m_simulation->project();
  input.graph = &m_simulation->graph();
  input.wind = windTexture();
  input.time = m_simulation->time();
  input.quality.complete = m_complete;
  return input;
}

void SessionImpl::draw(const View& view) {
  FrameInput input = frameInput();
  input.camera = view.camera;
  input.size = view.size;
  input.framebuffer = view.framebuffer;
  input.origin = view.origin;
  input.overlays = view.overlays;
  input.highlight = view.highlight;
  input.quality = view.quality;
  m_complete = view.quality.complete;
  input.grassView = view.grassView;
  input.bezierCulling = view.bezierCulling;
  m_status.frame = m_renderer->render(input);
  if (!onCpu()) m_readout.sample(m_simulation->solver().velocityTexture(), m_simulation->solver().grid());
}

glm::vec2 SessionImpl::windAt(glm::vec2 world) {
  if (onCpu()) return m_simulation->windAt(world);
  return m_readout.ask(world, ambientVelocity(*m_simulation->project().ambient));
}

const SessionStatus& SessionImpl::status() {
  WindSolver& solver = m_simulation->solver();
  m_status.backend = solver.backend();
  m_status.liveResolution = solver.grid().resolution;
  m_status.projectResolution = m_simulation->project().field->resolution;
  m_status.stepMs = m_stepMs.value();
  m_status.wind = solver.diagnostics();
  return m_status;
}

}  // namespace

Result<std::unique_ptr<Session>> Session::create(const Project& project, const SessionOptions& options) {
  WL_REQUIRE(options.context != nullptr && options.shaders != nullptr, "a session draws with OpenGL");
  Result<std::unique_ptr<FrameRenderer>> renderer = FrameRenderer::create(*options.context, *options.shaders);
  if (!renderer) return renderer.error();
  Result<WindReadout> readout = WindReadout::create(*options.shaders);
  if (!readout) return readout.error();
  Result<WindWatch> watch = WindWatch::create(*options.shaders);
  if (!watch) return watch.error();
  auto session = std::make_unique<SessionImpl>(options, std::move(*renderer), std::move(*readout), std::move(*watch));
  if (Status started = session->start(project); !started) return started.error();
  return std::unique_ptr<Session>(std::move(session));
}

}  // namespace windloom
