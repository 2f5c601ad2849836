#include "engine/session/simulation.hpp"

#include <algorithm>
#include <cmath>

#include "engine/gpu/context.hpp"
#include "engine/model/calibration_card.hpp"
#include "engine/model/validate.hpp"

namespace windloom {
namespace {

/// The backend that will run: the caller's choice, else the project's; Auto takes the GPU only where OpenGL is
/// there and is not a software renderer.
Result<Backend> chooseBackend(Backend asked, Backend wanted, const gpu::Context* context) {
  const Backend choice = asked != Backend::Auto ? asked : wanted;
  if (choice == Backend::Cpu) return Backend::Cpu;
  if (choice == Backend::Auto) return context != nullptr && !context->info().software ? Backend::Gpu : Backend::Cpu;
  if (context == nullptr) {
    return makeError(ErrorKind::Machine,
                     "the GPU backend needs OpenGL 4.5, which is not available here; use --backend cpu");
  }
  return Backend::Gpu;
}

bool sameGrid(const FieldSettings& a, const FieldSettings& b) {
  return a.centre == b.centre && a.size == b.size && a.resolution == b.resolution && a.xMin == b.xMin &&
         a.xMax == b.xMax && a.zMin == b.zMin && a.zMax == b.zMax;
}

long stepsInASecond(const Project& project) {
  return std::max(1L, std::lround(1.0 / static_cast<double>(project.field->timeStep)));
}

WindSetup setupOf(const Project& project, const SimulationOptions& options) {
  WindSetup setup{*project.field, *project.solver, *project.ambient, *project.obstacles, {}};
  if (options.resolution) setup.field.resolution = *options.resolution;
  return setup;
}

Status requireValid(const Project& project) {
  if (std::vector<Problem> problems = validate(project); !problems.empty()) {
    return Error{ErrorKind::BadInput, std::move(problems)};
  }
  return Done{};
}

}  // namespace

Result<std::unique_ptr<Simulation>> Simulation::create(const Project& project, const SimulationOptions& options) {
  if (Status valid = requireValid(project); !valid) return valid.error();
  std::unique_ptr<Simulation> simulation(new Simulation);
  simulation->m_options = options;
  simulation->m_checkpoints = Checkpoints({.bytes = options.checkpointBytes});
  if (Status built = simulation->build(project); !built) return built.error();
  simulation->adopt(project);
  return simulation;
}

Status Simulation::build(const Project& project) {
  const Result<Backend> backend = chooseBackend(m_options.backend, project.solver->backend, m_options.context);
  if (!backend) return backend.error();
  const WindSetup setup = setupOf(project, m_options);
  Result<std::unique_ptr<WindSolver>> solver = *backend == Backend::Gpu
                                                   ? makeGpuWindSolver(setup, *m_options.context, *m_options.shaders)
                                                   : makeCpuWindSolver(setup, m_options.threads);
  if (!solver) return solver.error();
  m_solver = std::move(*solver);
  m_seconds = 0;
  m_steps = 0;
  m_checkpoints.clear(stepsInASecond(project));
  m_fromStart = true;
  return Done{};
}

void Simulation::adopt(const Project& project) {
  if (!m_graph || project.graph != m_project.graph) m_graph = std::make_unique<GraphEvaluator>(*project.graph);
  m_project = project;
  m_cellsFresh = false;
  if (shows(WindSource::Card)) showCard();
}

bool Simulation::shows(WindSource source) const {
  return m_project.solver->source == source;
}

void Simulation::showCard() {
  const GridMapping& grid = m_solver->grid();
  m_cells.clear();
  for (int k = 0; k < grid.resolution.y; ++k) {
    for (int i = 0; i < grid.resolution.x; ++i)
      m_cells.push_back(cardWind((glm::vec2(i, k) + 0.5f) / glm::vec2(grid.resolution), m_seconds));
  }
  const Status set = m_solver->setVelocity(m_cells);
  WL_REQUIRE(set.ok(), "the card is finite");
  m_cellsFresh = true;
}

Status Simulation::setProject(const Project& project) {
  if (project.sameAs(m_project)) return Done{};
  if (Status valid = requireValid(project); !valid) return valid;
  const bool rebuild = !sameGrid(*project.field, *m_project.field) ||
                       project.solver->backend != m_project.solver->backend ||
                       project.solver->source != m_project.solver->source;
  const bool otherSetup = project.field != m_project.field || project.solver != m_project.solver ||
                          project.ambient != m_project.ambient || project.obstacles != m_project.obstacles;
  if (rebuild) {
    if (Status built = build(project); !built) return built;
  } else if (otherSetup) {
    m_solver->configure(setupOf(project, m_options));
    if (project.field->timeStep != m_project.field->timeStep)
      m_steps = std::lround(m_seconds / static_cast<double>(project.field->timeStep));
  }
  if (!rebuild && (otherSetup || project.graph != m_project.graph)) {
    // The air that blows now isn't what running from the start would give, and what was kept doesn't lead to it.
    m_checkpoints.clear(stepsInASecond(project));
    m_fromStart = m_fromStart && !otherSetup && m_steps == startStep();
  }
  adopt(project);
  return Done{};
}

Status Simulation::setResolution(std::optional<glm::ivec2> resolution) {
  if (resolution.value_or(m_project.field->resolution) == m_solver->grid().resolution) {
    m_options.resolution = resolution;
    return Done{};
  }
  const std::vector<glm::vec2> air = velocity();
  const GridMapping before = m_solver->grid();
  const SimulationOptions options = m_options;
  const double seconds = m_seconds;
  const long steps = m_steps;
  const bool untouched = m_fromStart && m_steps == 0;
  m_options.resolution = resolution;
  if (Status built = build(m_project); !built) {
    m_options = options;
    return built;
  }
  m_seconds = seconds;
  m_steps = steps;
  m_cellsFresh = false;
  // At the start the new solver's own air is the right one.
  m_fromStart = untouched;
  if (shows(WindSource::Card)) {
    showCard();
    return Done{};
  }
  if (untouched) return Done{};
  const GridMapping& grid = m_solver->grid();
  std::vector<glm::vec2> cells;
  cells.reserve(static_cast<std::size_t>(grid.resolution.x) * static_cast<std::size_t>(grid.resolution.y));
  for (int k = 0; k < grid.resolution.y; ++k) {
    for (int i = 0; i < grid.resolution.x; ++i) {
      cells.push_back(sampleCells(air, before, cellCentreToWorld({i, k}, grid.minCorner, grid.cellSize)));
    }
  }
  return m_solver->setVelocity(cells);
}

Status Simulation::setInitialField(glm::ivec2 resolution, std::span<const glm::vec2> cells, long step) {
  if (shows(WindSource::Card))
    return makeError(ErrorKind::BadInput, "the calibration card is known at every time, it takes no initial field");
  const glm::ivec2 expected = m_solver->grid().resolution;
  if (resolution != expected) {
    return makeError(ErrorKind::BadInput, "the initial field has " + std::to_string(resolution.x) + " x " +
                                              std::to_string(resolution.y) + " cells, expected " +
                                              std::to_string(expected.x) + " x " + std::to_string(expected.y));
  }
  if (Status set = m_solver->setVelocity(cells); !set) return set;
  m_initial.assign(cells.begin(), cells.end());
  m_initialStep = step;
  setStep(step);
  m_checkpoints.clear();
  m_fromStart = true;
  return Done{};
}

void Simulation::step() {
  if (shows(WindSource::Card)) return setStep(m_steps + 1);
  std::vector<ArrowForce> forces = m_graph->forcesAt(m_seconds);
  forces.insert(forces.end(), m_transient.begin(), m_transient.end());
  // Air that was combed is not the air that playing from the start gives.
  if (!m_transient.empty()) m_fromStart = false;
  m_solver->step(forces, m_seconds);
  ++m_steps;
  m_seconds += static_cast<double>(m_project.field->timeStep);
  m_cellsFresh = false;
  keepCheckpoint();
}

void Simulation::keepCheckpoint() {
  if (m_options.checkpoints && m_fromStart)
    m_checkpoints.offer(m_steps, m_seconds, [this] { return m_solver->save(); });
}

long Simulation::startStep() const {
  return startsFromField() ? m_initialStep : 0;
}

bool Simulation::startsFromField() const {
  return static_cast<int>(m_initial.size()) == m_solver->grid().resolution.x * m_solver->grid().resolution.y;
}

long Simulation::stepAt(double seconds) const {
  const double steps = seconds / static_cast<double>(m_project.field->timeStep);
  return std::max(startStep(), std::lround(std::clamp(steps, 0.0, 1e9)));
}

void Simulation::goTowards(long step) {
  if (step == m_steps) return;
  const auto* kept = m_checkpoints.newestUpTo(step);
  if (step > m_steps && (kept == nullptr || kept->first <= m_steps || !m_fromStart)) return;
  if (kept == nullptr) return restart();
  m_solver->restore(*kept->second.state);
  m_steps = kept->first;
  m_seconds = kept->second.seconds;
  m_cellsFresh = false;
  m_fromStart = true;
}

void Simulation::restart() {
  m_solver->reset();
  m_fromStart = true;
  if (startsFromField() && !shows(WindSource::Card)) {
    const Status set = m_solver->setVelocity(m_initial);
    WL_REQUIRE(set.ok(), "an initial field that was taken once is taken again");
    setStep(m_initialStep);
    return;
  }
  setStep(0);
}

void Simulation::startAt(double seconds) {
  m_solver->reset();
  m_checkpoints.clear(stepsInASecond(m_project));
  setStep(stepAt(seconds));
  m_fromStart = m_steps == startStep();
}

void Simulation::setStep(long step) {
  m_steps = step;
  m_seconds = static_cast<double>(step) * static_cast<double>(m_project.field->timeStep);
  m_cellsFresh = false;
  if (shows(WindSource::Card)) showCard();
}

bool Simulation::runTo(double seconds, const std::function<bool(double time)>& cancelled) {
  // Half a step of slack, so that a time that is a whole number of steps takes exactly that number.
  while (m_seconds + 0.5 * static_cast<double>(m_project.field->timeStep) <= seconds) {
    if (cancelled && cancelled(m_seconds)) return false;
    step();
  }
  return true;
}

const std::vector<glm::vec2>& Simulation::velocity() {
  if (!m_cellsFresh) m_solver->readVelocity(m_cells);
  m_cellsFresh = true;
  return m_cells;
}

glm::vec2 Simulation::windAt(glm::vec2 world) {
  return sampleCells(velocity(), m_solver->grid(), world);
}

glm::vec2 sampleCells(std::span<const glm::vec2> cells, const GridMapping& grid, glm::vec2 world) {
  const glm::vec2 last(grid.resolution - 1);
  const glm::vec2 at = glm::clamp(worldToCell(world, grid.minCorner, grid.cellSize), glm::vec2(0), last);
  const glm::ivec2 low = glm::min(glm::ivec2(at), glm::max(grid.resolution - 2, glm::ivec2(0)));
  const glm::ivec2 high = glm::min(low + 1, grid.resolution - 1);
  const glm::vec2 f = at - glm::vec2(low);
  const auto cell = [&](int i, int k) { return cells[static_cast<std::size_t>(k) * grid.resolution.x + i]; };
  return glm::mix(glm::mix(cell(low.x, low.y), cell(high.x, low.y), f.x),
                  glm::mix(cell(low.x, high.y), cell(high.x, high.y), f.x), f.y);
}

}  // namespace windloom
