// The CPU backend: the stages of docs/solver.md in order.
#include "engine/wind/cpu_solver.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <new>

#include "engine/core/contract.hpp"
#include "engine/wind/cpu_advection.hpp"
#include "engine/wind/cpu_borders.hpp"
#include "engine/wind/cpu_forces.hpp"
#include "engine/wind/cpu_viscosity.hpp"
#include "engine/wind/initial_field.hpp"

namespace windloom {
namespace {

using Clock = std::chrono::steady_clock;

double msBetween(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Times the stages of a step into its diagnostics.
class StageClock {
 public:
  explicit StageClock(WindDiagnostics& diagnostics) : m_diagnostics(diagnostics) { diagnostics.stageMs.clear(); }
  void end(const char* stage) {
    const Clock::time_point now = Clock::now();
    m_diagnostics.stageMs.emplace_back(stage, msBetween(m_last, now));
    m_last = now;
    m_diagnostics.stepMs = msBetween(m_begin, now);
  }

 private:
  WindDiagnostics& m_diagnostics;
  Clock::time_point m_begin = Clock::now(), m_last = m_begin;
};

/// The planes that the next step reads, and the cell velocities.
std::array<CpuPlane*, 6> planesOf(CpuFields& f) {
  return {&f.velocity.u, &f.velocity.w, &f.phi, &f.expected, &f.speedX, &f.speedZ};
}

struct CpuWindState final : WindState {
  [[nodiscard]] std::size_t bytes() const override {
    std::size_t floats = 0;
    for (const std::vector<float>& plane : planes) floats += plane.size();
    return floats * sizeof(float);
  }
  std::array<std::vector<float>, 6> planes;
  bool hasPhi = false;
  WindDiagnostics diagnostics;
};

CpuFields makeFields(const WindSetup& setup) {
  CpuFields f;
  f.grid = makeWindGrid(setup.field, setup.obstacles);
  for (CpuVelocity* v : {&f.velocity, &f.forced, &f.moved, &f.corrected, &f.lowest, &f.highest})
    *v = CpuVelocity(f.grid);
  for (CpuPlane* p : {&f.phi, &f.expected, &f.speedX, &f.speedZ}) *p = CpuPlane(f.grid.width, f.grid.height);
  return f;
}

void takeGustTable(CpuFields& f, const std::vector<glm::vec2>& table) {
  constexpr std::size_t kSide = WIND_GUST_TABLE;
  f.gustTable.clear();
  for (std::size_t k = 0; k <= kSide; ++k) {
    for (std::size_t i = 0; i <= kSide; ++i) f.gustTable.push_back(table[(k % kSide) * kSide + i % kSide]);
  }
}

}  // namespace

CpuWindSolver::CpuWindSolver(const WindSetup& setup, int threads)
    : m_pool(threads), m_fields(makeFields(setup)), m_multigrid(m_fields.grid) {
  findBlocked(m_fields);
  applySettings(setup);
  reset();
}

void CpuWindSolver::configure(const WindSetup& setup) {
  WindGrid& grid = m_fields.grid;
  WL_REQUIRE(setup.field.resolution == grid.mapping.resolution && setup.field.size == grid.mapping.size,
             "another grid needs a new solver");
  const std::vector<std::uint8_t> old = grid.solid;
  grid.mapping = makeGridMapping(setup.field.centre, setup.field.size, setup.field.resolution);
  rasteriseSolids(grid, setup.obstacles);
  applySettings(setup);
  if (grid.solid == old) return;
  findBlocked(m_fields);
  m_multigrid.rebuild(grid);
  blockFaces(m_fields, m_fields.velocity);
  resampleToCells(m_fields, m_pool);
}

std::size_t CpuWindSolver::memoryBytes() const {
  const CpuFields& f = m_fields;
  std::size_t sum = m_multigrid.memoryBytes() + f.phi.bytes() + f.expected.bytes() + f.speedX.bytes() +
                    f.speedZ.bytes() + f.grid.solid.size();
  for (const CpuVelocity* v : {&f.velocity, &f.forced, &f.moved, &f.corrected, &f.lowest, &f.highest})
    sum += v->u.bytes() + v->w.bytes();
  return sum;
}

void CpuWindSolver::applySettings(const WindSetup& setup) {
  CpuFields& f = m_fields;
  if (f.gustTable.empty() || f.solver.seed != setup.solver.seed) takeGustTable(f, makeGustTable(setup.solver.seed));
  f.solver = setup.solver;
  f.ambientSettings = setup.ambient;
  f.noSlip = setup.noSlip;
  f.dt = setup.field.timeStep;
  f.ambient = ambientVelocity(setup.ambient);
  if (const float speed = glm::length(f.ambient); speed > f.solver.maxSpeed) f.ambient *= f.solver.maxSpeed / speed;
  f.gustAmplitude = gustAmplitude(setup.ambient);
}

void CpuWindSolver::step(std::span<const ArrowForce> arrows, double time) {
  StageClock clock(m_diagnostics);
  fillGhosts(m_fields, m_fields.velocity, OpenGhost::Ambient);
  binArrows(m_fields.grid, arrows, m_tiles);
  CpuHealth health = applyForces(m_fields, m_pool, arrows, m_tiles, time);
  fillGhosts(m_fields, m_fields.forced, OpenGhost::Ambient);
  clock.end("forces");
  advect(m_fields, m_pool);
  clock.end("advection");
  if (m_fields.solver.viscosity > 0) {
    diffuse(m_fields, m_pool);
    clock.end("viscosity");
  }
  const ProjectionReport report = project(m_fields, m_multigrid, m_pool);
  takeReport(report);
  health.add(report.health);
  if (health.count > 0 && m_diagnostics.nonFiniteCells == 0) m_diagnostics.firstNonFinite = health.first;
  m_diagnostics.nonFiniteCells += health.count;
  ++m_diagnostics.step;
  clock.end("projection");
}

void CpuWindSolver::takeReport(const ProjectionReport& report) {
  m_diagnostics.divergenceBefore = report.divergenceBefore;
  m_diagnostics.divergenceAfter = report.divergenceAfter;
  m_diagnostics.maxDivergenceBefore = report.maxDivergenceBefore;
  m_diagnostics.maxDivergenceAfter = report.maxDivergenceAfter;
  m_diagnostics.cycles = report.cycles;
  m_diagnostics.kineticEnergy = report.kineticEnergy;
  m_diagnostics.maxSpeed = std::min(report.maxSpeed, double(m_fields.solver.maxSpeed));
  m_diagnostics.cfl = report.cfl;
}

void CpuWindSolver::reset() {
  CpuFields& f = m_fields;
  for (int k = 0; k <= f.height(); ++k) {
    if (k < f.height()) std::fill_n(f.velocity.u.row(k), f.width() + 1, f.ambient.x);
    std::fill_n(f.velocity.w.row(k), f.width(), f.ambient.y);
  }
  blockFaces(f, f.velocity);
  forgetPressure(f);
  m_diagnostics = {};
  resampleToCells(f, m_pool);
}

Status CpuWindSolver::setVelocity(std::span<const glm::vec2> cells) {
  CpuFields& f = m_fields;
  if (Status status = checkInitialField(f.grid, cells); !status) return status;
  for (int k = 0; k <= f.height(); ++k) {
    for (int i = 0; k < f.height() && i <= f.width(); ++i)
      f.velocity.u.at(i, k) = initialFaceX(f.grid, cells, i, k, f.solver.maxSpeed);
    for (int i = 0; i < f.width(); ++i) f.velocity.w.at(i, k) = initialFaceZ(f.grid, cells, i, k, f.solver.maxSpeed);
  }
  forgetPressure(f);
  m_diagnostics = {};
  resampleToCells(f, m_pool);
  return Done{};
}

void CpuWindSolver::readVelocity(std::vector<glm::vec2>& cells) {
  const CpuFields& f = m_fields;
  cells.resize(static_cast<std::size_t>(f.width()) * static_cast<std::size_t>(f.height()));
  forRows(m_pool, f.width(), f.height(), [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      glm::vec2* out = cells.data() + static_cast<std::size_t>(k) * static_cast<std::size_t>(f.width());
      for (int i = 0; i < f.width(); ++i) {
        const glm::vec2 v(f.speedX.at(i, k), f.speedZ.at(i, k));
        const float speed = glm::length(v);
        out[i] = speed > f.solver.maxSpeed ? v * (f.solver.maxSpeed / speed) : v;
      }
    }
  });
}

Result<std::unique_ptr<WindState>> CpuWindSolver::save() {
  auto state = std::make_unique<CpuWindState>();
  const std::array<CpuPlane*, 6> planes = planesOf(m_fields);
  try {
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const float* memory = planes[p]->memory();
      state->planes[p].assign(memory, memory + planes[p]->bytes() / sizeof(float));
    }
  } catch (const std::bad_alloc&) {
    return makeError(ErrorKind::Machine, "there is no memory to keep a state of the wind");
  }
  state->hasPhi = m_fields.hasPhi;
  state->diagnostics = m_diagnostics;
  return std::unique_ptr<WindState>(std::move(state));
}

void CpuWindSolver::restore(const WindState& state) {
  const auto* own = dynamic_cast<const CpuWindState*>(&state);
  WL_REQUIRE(own != nullptr, "a state of another backend");
  const std::array<CpuPlane*, 6> planes = planesOf(m_fields);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    WL_REQUIRE(own->planes[p].size() * sizeof(float) == planes[p]->bytes(), "a state of another grid");
    std::memcpy(planes[p]->memory(), own->planes[p].data(), planes[p]->bytes());
  }
  m_fields.hasPhi = own->hasPhi;
  m_diagnostics = own->diagnostics;
}

Result<std::unique_ptr<WindSolver>> makeCpuWindSolver(const WindSetup& setup, int threads) {
  if (Status status = checkWindSetup(setup); !status) return status.error();
  return std::unique_ptr<WindSolver>(std::make_unique<CpuWindSolver>(setup, threads));
}

}  // namespace windloom
