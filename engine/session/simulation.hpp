#pragma once
// A project's wind over time: graph evaluation, solver and fixed-step clock together. Needs no OpenGL on
// the CPU backend; `sample` and `bake` use it directly, the live Session builds on it.

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/session/checkpoints.hpp"
#include "engine/wind/wind_solver.hpp"

namespace windloom {

struct SimulationOptions {
  Backend backend = Backend::Auto;           ///< overrides the project's unless Auto
  std::optional<glm::ivec2> resolution;      ///< instead of the project's (live preview)
  gpu::Context* context = nullptr;           ///< null: only the CPU backend is there
  gpu::ShaderLibrary* shaders = nullptr;     ///< must be given with a context; both must outlive the simulation
  int threads = 0;                           ///< CPU backend; as for ThreadPool
  bool checkpoints = false;                  ///< keeps states on the way, for goTowards()
  std::size_t checkpointBytes = 256u << 20;  ///< of all states together
};

class Simulation {
 public:
  /// Starts at time 0 from the ambient wind. Fails with Machine where the GPU backend was asked for by name and
  /// there is no context, and with BadInput where the project is not valid.
  static Result<std::unique_ptr<Simulation>> create(const Project& project, const SimulationOptions& options);

  /// Takes over what changed between the last project and this one; the air keeps moving unless the grid or
  /// the backend changed, which starts again at time 0. Changes to the graph apply from the next step. On
  /// failure the last project stays.
  Status setProject(const Project& project);

  /// Continues at another resolution (none: the project's): time stays and the air is resampled. On failure
  /// nothing changes.
  Status setResolution(std::optional<glm::ivec2> resolution);

  /// Starts from a given field instead (see WindSolver::setVelocity), now and after each restart. Refused
  /// (BadInput) where the resolution isn't the simulation's. Time goes on from step `step`, so that arrows and gusts
  /// do, too.
  Status setInitialField(glm::ivec2 resolution, std::span<const glm::vec2> cells, long step = 0);

  /// Forces beside the graph's in the steps from now on, until they are set again: no part of the project.
  void setTransientForces(std::span<const ArrowForce> forces) { m_transient.assign(forces.begin(), forces.end()); }
  void step();
  /// Back to the start: the ambient wind at time 0, or the initial field at its time.
  void restart();
  /// From the ambient wind at `seconds`, rounded to whole steps, instead of at 0: what blew before is left out.
  void startAt(double seconds);
  /// Steps until time() is `seconds` rounded to whole steps; does nothing where that lies behind. `cancelled`
  /// is asked before each step; where it says yes, stops there and returns false.
  bool runTo(double seconds, const std::function<bool(double time)>& cancelled = {});

  /// The step whose time is nearest to `seconds`.
  [[nodiscard]] long stepAt(double seconds) const;
  /// Jumps to the latest known state from which steps lead to step `step`: now, a checkpoint, or the start. Running on
  /// from there gives the same bytes as running from the start, unless the air now comes from before an edit and is
  /// not later than `step`: then it goes on from now.
  void goTowards(long step);
  /// Keeps a checkpoint at this step whenever it comes by (the start of a loop); 0: none.
  void pinCheckpoint(long step) { m_checkpoints.pin(step); }
  /// Whether the air is what running from the start with this project gives.
  [[nodiscard]] bool runsFromStart() const { return m_fromStart; }
  [[nodiscard]] const Checkpoints& checkpoints() const { return m_checkpoints; }

  [[nodiscard]] double time() const { return m_seconds; }  ///< simulated, s
  [[nodiscard]] long steps() const { return m_steps; }     ///< time() in time steps

  /// Wind at a world position (x, z), m/s, bilinear between cell centres, clamped to the field. Reads the
  /// field back at most once a step.
  glm::vec2 windAt(glm::vec2 world);
  /// The whole cell-centred field (see WindSolver::readVelocity), read back at most once a step.
  const std::vector<glm::vec2>& velocity();

  WindSolver& solver() { return *m_solver; }
  /// What it was created with; null: it has no OpenGL.
  [[nodiscard]] gpu::ShaderLibrary* shaders() const { return m_options.shaders; }
  [[nodiscard]] const GraphEvaluator& graph() const { return *m_graph; }
  [[nodiscard]] const Project& project() const { return m_project; }

 private:
  Simulation() = default;
  Status build(const Project& project);
  void adopt(const Project& project);
  [[nodiscard]] bool shows(WindSource source) const;
  void showCard();
  void setStep(long step);
  [[nodiscard]] bool startsFromField() const;
  [[nodiscard]] long startStep() const;  // where restart() leads
  void keepCheckpoint();

  Project m_project;
  SimulationOptions m_options;
  std::unique_ptr<WindSolver> m_solver;
  std::unique_ptr<GraphEvaluator> m_graph;
  std::vector<ArrowForce> m_transient;
  std::vector<glm::vec2> m_initial;
  std::vector<glm::vec2> m_cells;
  long m_initialStep = 0;
  bool m_cellsFresh = false;
  Checkpoints m_checkpoints;
  bool m_fromStart = true;  // the air is what running from the start with this project gives
  long m_steps = 0;
  double m_seconds = 0;
};

/// Bilinear sample of a cell-centred field at a world position, clamped to its outermost centres.
glm::vec2 sampleCells(std::span<const glm::vec2> cells, const GridMapping& grid, glm::vec2 world);

}  // namespace windloom
