// The GPU backend: the stages of docs/solver.md in order, each in as few dispatches as it takes.
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "engine/gpu/context.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/timer.hpp"
#include "engine/wind/gpu_arrows.hpp"
#include "engine/wind/gpu_cycles.hpp"
#include "engine/wind/gpu_fields.hpp"
#include "engine/wind/gpu_pressure.hpp"
#include "engine/wind/gpu_programs.hpp"
#include "engine/wind/gpu_transport.hpp"
#include "engine/wind/gusts.hpp"
#include "engine/wind/initial_field.hpp"

namespace windloom {
namespace {

constexpr std::size_t kReportBytes = offsetof(shared::WindControl, groups);
constexpr shared::uint kNoCell = 0xffffffffu;
constexpr long kTimedEvery = 8;  // steps from one whose stages are timed to the next: time stamps cost time themselves

/// What of the CPU's knowledge of the steps decides about the next ones. Reports of the last steps are still on their
/// way when a state is saved: the solver puts them in when they come.
struct StepsKnown {
  GpuCycles cycles;
  WindDiagnostics diagnostics;
  long step = 0;
};

struct GpuWindState final : WindState {
  [[nodiscard]] std::size_t bytes() const override {
    std::size_t sum = arrows.arrows.size() * sizeof(ArrowForce) + cellBytes;
    for (const gpu::Buffer& buffer : buffers) sum += buffer.bytes();
    return sum;
  }
  std::vector<gpu::Buffer> buffers;  // copies, in the order of GpuWindSolver::kept()
  gpu::Texture cells;
  std::size_t cellBytes = 0;
  GpuArrows::Sent arrows;
  std::shared_ptr<StepsKnown> known;
};

void copyBuffer(const gpu::Buffer& from, const gpu::Buffer& to) {
  WL_REQUIRE(from.bytes() == to.bytes(), "a state of another grid");
  glCopyNamedBufferSubData(from.name(), to.name(), 0, 0, static_cast<GLsizeiptr>(from.bytes()));
}

class GpuWindSolver final : public WindSolver {
 public:
  static Result<std::unique_ptr<WindSolver>> make(const WindSetup& setup, gpu::ShaderLibrary& shaders);

  void configure(const WindSetup& setup) override;
  void step(std::span<const ArrowForce> arrows, double time) override;
  void reset() override;
  Status setVelocity(std::span<const glm::vec2> cells) override;
  void readVelocity(std::vector<glm::vec2>& cells) override;
  Result<std::unique_ptr<WindState>> save() override;
  void restore(const WindState& state) override;

  [[nodiscard]] unsigned velocityTexture() const override { return m_fields.cells.name(); }
  [[nodiscard]] const GridMapping& grid() const override { return m_fields.grid.mapping; }
  [[nodiscard]] const WindDiagnostics& diagnostics() override;
  [[nodiscard]] Backend backend() const override { return Backend::Gpu; }
  [[nodiscard]] std::size_t memoryBytes() const override {
    return m_fields.memoryBytes() + m_pressure.memoryBytes() + m_arrows.memoryBytes();
  }

 private:
  GpuWindSolver(GpuFields fields, GpuTransport transport, GpuPressure pressure, gpu::ReadbackRing ring,
                const gpu::Program& resample)
      : m_fields(std::move(fields)),
        m_transport(std::move(transport)),
        m_pressure(std::move(pressure)),
        m_ring(std::move(ring)),
        m_resample(resample) {}

  void takeReports(long upTo, gpu::ReadbackRing::Wait wait);
  void take(long step, const shared::WindControl& report);
  [[nodiscard]] std::array<const gpu::Buffer*, 4> kept() const;
  void copyCells(const gpu::Texture& from, const gpu::Texture& to) const;
  void startFrom(const std::vector<float>& faces);
  void resample();
  void clearControl();

  GpuFields m_fields;
  GpuTransport m_transport;
  GpuPressure m_pressure;
  GpuArrows m_arrows;
  GpuCycles m_cycles;
  gpu::ReadbackRing m_ring;
  gpu::GpuTimer m_timer;
  const gpu::Program& m_resample;
  WindDiagnostics m_diagnostics;
  long m_step = 0;                                    // recorded since the last start
  long m_reported = 0;                                // newest step whose report has been taken
  std::vector<std::weak_ptr<StepsKnown>> m_awaiting;  // of saved states, reports that are on their way
};

Result<std::unique_ptr<WindSolver>> GpuWindSolver::make(const WindSetup& setup, gpu::ShaderLibrary& shaders) {
  Result<GpuFields> fields = GpuFields::create(setup);
  if (!fields) return fields.error();
  Result<GpuTransport> transport = GpuTransport::create(shaders);
  if (!transport) return transport.error();
  Result<GpuPressure> pressure = GpuPressure::create(*fields, shaders);
  if (!pressure) return pressure.error();
  Result<gpu::ReadbackRing> ring =
      gpu::ReadbackRing::create("wind reports", kReportBytes, static_cast<int>(GpuCycles::kDelay) + 1);
  if (!ring) return ring.error();
  const Result<gpu::Program*> resample = shaders.load(windProgram("wind/resample"));
  if (!resample) return resample.error();
  std::unique_ptr<GpuWindSolver> solver(
      new GpuWindSolver(std::move(*fields), std::move(*transport), std::move(*pressure), std::move(*ring), **resample));
  solver->reset();
  return std::unique_ptr<WindSolver>(std::move(solver));
}

void GpuWindSolver::configure(const WindSetup& setup) {
  const WindGrid& grid = m_fields.grid;
  WL_REQUIRE(setup.field.resolution == grid.mapping.resolution && setup.field.size == grid.mapping.size,
             "another grid needs a new solver");
  const std::vector<std::uint8_t> old = grid.solid;
  const float oldSpeedLimit = m_fields.solver.maxSpeed;
  m_fields.applySettings(setup);
  const bool newSolids = grid.solid != old;
  if (newSolids) {
    m_cycles.forget(m_step + 1);
    // Where the levels can't be made the old ones stay: their conductances are wrong, their sizes right.
    if (const Status made = m_pressure.rebuild(m_fields); !made)
      WL_REQUIRE(false, "levels of a grid that fit before fit again");
  }
  m_fields.sendBlock();
  // The ghosts hold the ambient wind, and new solids stop the air inside them.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);  // velocity by the last step's projection
  glCopyNamedBufferSubData(m_fields.velocity.name(), m_fields.carried.name(), 0, 0,
                           static_cast<GLsizeiptr>(m_fields.velocity.bytes()));
  m_transport.fill(m_fields);
  if (newSolids || oldSpeedLimit != m_fields.solver.maxSpeed) resample();
}

void GpuWindSolver::step(std::span<const ArrowForce> arrows, double time) {
  const gpu::DebugGroup group("wind step");
  const long step = m_step + 1;
  takeReports(step - GpuCycles::kDelay, gpu::ReadbackRing::Wait::Yes);
  const auto layers = gustLayersAt(m_fields.ambient, time);
  if (m_fields.block.gusts > 0) std::copy(layers.begin(), layers.end(), m_fields.block.gustLayers);
  if (m_arrows.send(m_fields, arrows)) m_cycles.forget(step);  // an artist's edit may ask for more than any step before
  // Looking whether the solve must begin again costs a dispatch: multigrid does it only where much may have changed.
  const bool sure = m_fields.solver.pressure == Pressure::Multigrid && m_cycles.knows(step);
  m_fields.block.mayDrop = sure ? 0 : 1;
  const glm::ivec2 firstGroups = m_pressure.groupsOfFlux(m_fields.solver.pressure);
  m_fields.block.firstGroupsX = firstGroups.x;
  m_fields.block.firstGroupsZ = firstGroups.y;
  m_fields.sendBlock();
  const bool timed = step % kTimedEvery == 1;
  if (timed) m_timer.beginFrame();
  m_fields.bindShared();
  const gpu::Buffer& star = m_transport.run(m_fields, m_arrows, m_timer);
  m_timer.stage("pressure");
  m_pressure.solve(m_fields, star, step == 1 ? SolveStart::Cold : SolveStart::Warm,
                   m_cycles.plan(step, m_fields.solver.maxCycles));
  m_timer.stage("projection");
  m_pressure.project(m_fields, star, m_fields.velocity);
  m_transport.findInflow(m_fields);
  if (timed) m_timer.endFrame();
  m_step = step;
  m_ring.request(m_fields.control, 0, kReportBytes, step);
}

void GpuWindSolver::takeReports(long upTo, gpu::ReadbackRing::Wait wait) {
  while (m_reported < std::min(upTo, m_step)) {
    const auto arrival = m_ring.takeOldest(wait);
    if (!arrival) return;
    shared::WindControl report{};
    std::memcpy(&report, arrival->bytes.data(), arrival->bytes.size());
    m_reported = arrival->tag;
    take(arrival->tag, report);
  }
}

void GpuWindSolver::take(long step, const shared::WindControl& report) {
  const double area = double(m_fields.grid.hx) * double(m_fields.grid.hz);
  const bool jacobi = m_fields.solver.pressure == Pressure::Jacobi;
  WindDiagnostics& d = m_diagnostics;
  d.step = step;
  d.divergenceBefore = std::sqrt(double(report.fluxBefore)) / area;
  d.divergenceAfter = std::sqrt(double(report.fluxAfter)) / area;
  d.maxDivergenceBefore = double(report.maxFluxBefore) / area;
  d.maxDivergenceAfter = double(report.maxFluxAfter) / area;
  d.kineticEnergy = double(report.energy);
  d.maxSpeed = std::min(std::sqrt(double(report.maxSpeedSquare)), double(m_fields.solver.maxSpeed));
  d.cfl = double(report.crossing);
  d.cycles = jacobi ? m_fields.solver.jacobiSweeps : static_cast<int>(report.cycles);
  d.nonFiniteCells = static_cast<long>(report.nonFinite);
  if (report.firstNonFinite != kNoCell) {
    const int cell = static_cast<int>(report.firstNonFinite);
    d.firstNonFinite = {cell % m_fields.width(), cell / m_fields.width()};
  }
  const double residual = report.flux > 0 ? std::sqrt(double(report.flux) / double(report.wanted)) : 0;
  m_cycles.learn(step, static_cast<int>(report.cycles), residual);
  for (const std::weak_ptr<StepsKnown>& awaiting : m_awaiting) {
    const std::shared_ptr<StepsKnown> known = awaiting.lock();
    if (!known || step > known->step) continue;
    known->cycles.learn(step, static_cast<int>(report.cycles), residual);
    known->diagnostics = d;
  }
  std::erase_if(m_awaiting, [&](const std::weak_ptr<StepsKnown>& awaiting) {
    const std::shared_ptr<StepsKnown> known = awaiting.lock();
    return !known || step >= known->step;
  });
}

const WindDiagnostics& GpuWindSolver::diagnostics() {
  takeReports(m_step, gpu::ReadbackRing::Wait::No);
  m_diagnostics.stageMs = m_timer.stages();
  m_diagnostics.stepMs = m_timer.totalMs();
  return m_diagnostics;
}

void GpuWindSolver::clearControl() {
  shared::WindControl control{};
  control.firstNonFinite = kNoCell;
  m_fields.control.write(&control, sizeof control);
}

void GpuWindSolver::startFrom(const std::vector<float>& faces) {
  takeReports(m_step, gpu::ReadbackRing::Wait::Yes);
  m_fields.carried = gpu::Buffer();  // its place is taken by one that already holds the faces
  Result<gpu::Buffer> filled =
      gpu::Buffer::create("wind carried", faces.size() * sizeof(float), gpu::BufferUse::Static, faces.data());
  WL_REQUIRE(filled.ok(), "a buffer that was there before is there again");
  m_fields.carried = std::move(*filled);
  clearControl();  // also: no pressure of an earlier step
  m_fields.sendBlock();
  m_transport.fill(m_fields);
  resample();
  m_diagnostics = {};
  m_step = m_reported = 0;
  m_cycles.forget(1);
}

void GpuWindSolver::resample() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // velocity by the fill pass
  m_fields.bindShared();
  m_fields.velocity.bindStorage(WIND_SSBO_VELOCITY);
  m_fields.cells.bindImage(WIND_IMAGE_CELLS, GL_WRITE_ONLY);
  m_resample.dispatchOver({m_fields.width(), m_fields.height()});
}

void GpuWindSolver::reset() {
  const VelocityLayout& layout = m_fields.layout;
  std::vector<float> faces(layout.floats, m_fields.block.ambient.x);
  std::fill(faces.begin() + layout.zFaces, faces.end(), m_fields.block.ambient.y);
  startFrom(faces);
}

Status GpuWindSolver::setVelocity(std::span<const glm::vec2> cells) {
  const WindGrid& grid = m_fields.grid;
  if (Status status = checkInitialField(grid, cells); !status) return status;
  const VelocityLayout& layout = m_fields.layout;
  std::vector<float> faces(layout.floats, 0.0f);
  const float limit = m_fields.solver.maxSpeed;
  for (int k = 0; k <= grid.height; ++k) {
    for (int i = 0; i <= grid.width; ++i) {
      if (k < grid.height) faces[layout.u(i, k)] = initialFaceX(grid, cells, i, k, limit);
      if (i < grid.width) faces[layout.w(i, k)] = initialFaceZ(grid, cells, i, k, limit);
    }
  }
  startFrom(faces);
  return Done{};
}

void GpuWindSolver::readVelocity(std::vector<glm::vec2>& cells) {
  cells.resize(m_fields.grid.solid.size());
  m_fields.cells.read(GL_RG, GL_FLOAT, cells.data(), cells.size() * sizeof(glm::vec2));
  takeReports(m_step, gpu::ReadbackRing::Wait::Yes);
  m_timer.finish();
}

std::array<const gpu::Buffer*, 4> GpuWindSolver::kept() const {
  const auto history = m_pressure.history();
  return {&m_fields.velocity, &m_fields.control, history[0], history[1]};
}

void GpuWindSolver::copyCells(const gpu::Texture& from, const gpu::Texture& to) const {
  glCopyImageSubData(from.name(), GL_TEXTURE_2D, 0, 0, 0, 0, to.name(), GL_TEXTURE_2D, 0, 0, 0, 0, m_fields.width(),
                     m_fields.height(), 1);
}

Result<std::unique_ptr<WindState>> GpuWindSolver::save() {
  auto state = std::make_unique<GpuWindState>();
  // The last step's passes wrote the buffers and, as an image, the texture.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  for (const gpu::Buffer* buffer : kept()) {
    Result<gpu::Buffer> copy = gpu::Buffer::create("wind state", buffer->bytes(), gpu::BufferUse::Static);
    if (!copy) return copy.error();
    copyBuffer(*buffer, *copy);
    state->buffers.push_back(std::move(*copy));
  }
  Result<gpu::Texture> cells =
      gpu::Texture::create2D("wind state cells", {m_fields.width(), m_fields.height()}, GL_RG32F);
  if (!cells) return cells.error();
  state->cells = std::move(*cells);
  copyCells(m_fields.cells, state->cells);
  state->cellBytes = m_fields.grid.solid.size() * sizeof(glm::vec2);
  state->arrows = m_arrows.sent(m_fields);
  state->known = std::make_shared<StepsKnown>(StepsKnown{m_cycles, m_diagnostics, m_step});
  if (m_reported < m_step) m_awaiting.push_back(state->known);
  return std::unique_ptr<WindState>(std::move(state));
}

void GpuWindSolver::restore(const WindState& state) {
  const auto* own = dynamic_cast<const GpuWindState*>(&state);
  WL_REQUIRE(own != nullptr, "a state of another backend");
  takeReports(m_step, gpu::ReadbackRing::Wait::Yes);
  // Steps that are thrown away wrote what is written here, and the passes of the next ones read it.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
  const auto targets = kept();
  for (std::size_t b = 0; b < targets.size(); ++b) copyBuffer(own->buffers[b], *targets[b]);
  copyCells(own->cells, m_fields.cells);
  m_arrows.restore(m_fields, own->arrows);
  m_cycles = own->known->cycles;
  m_diagnostics = own->known->diagnostics;
  m_step = m_reported = own->known->step;
}

}  // namespace

Result<std::unique_ptr<WindSolver>> makeGpuWindSolver(const WindSetup& setup, gpu::Context& context,
                                                      gpu::ShaderLibrary& shaders) {
  if (Status status = checkWindSetup(setup); !status) return status.error();
  context.makeCurrent();
  return GpuWindSolver::make(setup, shaders);
}

}  // namespace windloom
