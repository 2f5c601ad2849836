#pragma once
// The incompressible wind field on a MAC grid, with two backends of equal rank behind one interface.
// Equations, discretisation and sources: docs/solver.md.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/grid_mapping.hpp"
#include "engine/core/result.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/project.hpp"

namespace windloom {

namespace gpu {
class Context;
class ShaderLibrary;
}  // namespace gpu

/// Speeds of wall borders along themselves (along x for zMin and zMax, along z for xMin and xMax), m/s.
struct WallSpeeds {
  float xMin = 0, xMax = 0, zMin = 0, zMax = 0;
};

/// What a solver is built for. A change of `field.size`, `resolution` or `borders`, or of
/// `solver.backend`, needs a new solver; everything else goes through configure().
struct WindSetup {
  FieldSettings field;
  SolverSettings solver;
  AmbientWind ambient;
  std::vector<Obstacle> obstacles;   ///< muted ones are ignored
  std::optional<WallSpeeds> noSlip;  ///< wall borders hold the air at these speeds; without it air slips along them
};

/// What one step did. On the GPU backend these are of a recent finished step: nothing waits for them.
struct WindDiagnostics {
  long step = 0;                                        ///< the step these belong to; 0: none yet
  double divergenceBefore = 0;                          ///< RMS of div u over air cells before projection, 1/s
  double divergenceAfter = 0;                           ///< and after it
  double maxDivergenceBefore = 0;                       ///< 1/s
  double maxDivergenceAfter = 0;                        ///< 1/s
  double kineticEnergy = 0;                             ///< half the mean of |u|^2 over air cells, m^2/s^2
  double maxSpeed = 0;                                  ///< m/s
  double cfl = 0;                                       ///< fastest cell crossing in cells a step
  int cycles = 0;                                       ///< V-cycles or Jacobi sweeps done
  long nonFiniteCells = 0;                              ///< cells reset since the start because they were not finite
  glm::ivec2 firstNonFinite{-1, -1};                    ///< a cell among them
  double stepMs = 0;                                    ///< time of the step on its processor
  std::vector<std::pair<std::string, double>> stageMs;  ///< the same by stage, in order
};

/// All that decides how the wind goes on, kept by WindSolver::save. It may outlive its solver.
class WindState {
 public:
  virtual ~WindState() = default;
  [[nodiscard]] virtual std::size_t bytes() const = 0;  ///< of memory, on whichever processor
};

class WindSolver {
 public:
  virtual ~WindSolver() = default;

  /// Changes settings that keep the grid (see WindSetup) without touching the wind. New solids stop the
  /// air inside them.
  virtual void configure(const WindSetup& setup) = 0;

  /// One time step of `field.timeStep` under these arrows; `time` (s) places the ambient gusts.
  virtual void step(std::span<const ArrowForce> arrows, double time) = 0;

  /// Starts again from the ambient wind.
  virtual void reset() = 0;

  /// Starts from a given cell-centred field: width x height (vx, vz) in m/s, row k at z ascending, cell
  /// (i, k) at index k * width + i. Values that aren't finite are refused (BadInput, naming the cell).
  virtual Status setVelocity(std::span<const glm::vec2> cells) = 0;

  /// The field that all outside the solver reads: cell-centred, laid out as for setVelocity. On the GPU
  /// backend this waits for the GPU; use the texture in a frame.
  virtual void readVelocity(std::vector<glm::vec2>& cells) = 0;

  /// Keeps the state as it is now; nothing waits for the GPU. Fails with Machine where there is no memory.
  virtual Result<std::unique_ptr<WindState>> save() = 0;
  /// Goes on from a state that this solver saved, with the settings it had then: the same steps give the same bytes as
  /// if nothing had come between.
  virtual void restore(const WindState& state) = 0;

  /// Name of an RG32F texture with that field, texel (i, k) = cell (i, k), on the GPU backend; 0 on
  /// the CPU backend. Stays valid while the solver lives.
  [[nodiscard]] virtual unsigned velocityTexture() const = 0;

  [[nodiscard]] virtual const GridMapping& grid() const = 0;
  [[nodiscard]] virtual const WindDiagnostics& diagnostics() = 0;
  [[nodiscard]] virtual std::size_t memoryBytes() const = 0;
  [[nodiscard]] virtual Backend backend() const = 0;  ///< Cpu or Gpu
};

/// `threads` as for ThreadPool. Results are the same bytes for any number of threads.
Result<std::unique_ptr<WindSolver>> makeCpuWindSolver(const WindSetup& setup, int threads = 0);

/// Needs a current OpenGL 4.5 context; `shaders` must outlive the solver.
Result<std::unique_ptr<WindSolver>> makeGpuWindSolver(const WindSetup& setup, gpu::Context& context,
                                                      gpu::ShaderLibrary& shaders);

}  // namespace windloom
