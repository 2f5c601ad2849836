#pragma once
// The pressure solve of the GPU backend: multigrid or plain Jacobi sweeps. docs/solver.md section 6.

#include <array>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/program.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/wind/gpu_fields.hpp"
#include "engine/wind/pressure_levels.hpp"

namespace windloom {

enum class SolveStart { Warm, Cold };  ///< Cold: no step came before

class GpuPressure {
 public:
  /// Fails with Machine: no memory, or a shader that doesn't compile.
  static Result<GpuPressure> create(GpuFields& fields, gpu::ShaderLibrary& shaders);

  /// Makes the levels again after the solids changed.
  Status rebuild(GpuFields& fields);

  /// Records a solve of at most `cycles` V-cycles for the velocity `star` (q*), starting from what the steps before
  /// make one expect; where there were none, from one cycle more. The GPU skips cycles once it has converged.
  void solve(const GpuFields& fields, const gpu::Buffer& star, SolveStart start, int cycles);

  /// u = q* - gradient of the pressure into `result` with ghosts, cell velocities and the numbers of the step.
  void project(const GpuFields& fields, const gpu::Buffer& star, const gpu::Buffer& result);

  /// Planes of floats that the next solve reads: the last pressure, and what the next one is expected to be.
  [[nodiscard]] std::array<const gpu::Buffer*, 2> history() const { return {&m_phi, &m_predicted}; }

  /// Work-groups of the pass that finds the flux.
  [[nodiscard]] glm::ivec2 groupsOfFlux(Pressure kind) const {
    const shared::WindLevel& b = m_levels[0].block;
    return kind == Pressure::Jacobi ? glm::ivec2(b.upGroupsX, b.upGroupsZ) : glm::ivec2(b.downGroupsX, b.downGroupsZ);
  }

  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  struct Level {
    shared::WindLevel block{};
    gpu::Buffer faces, flux, d;  // not on level 0; flux: the right-hand side
  };
  Status makeLevel(Level& level, const PressureLevel& source);
  Status makeTail(std::span<const PressureLevel> levels, std::size_t first);
  Status sendLevels(std::span<const PressureLevel> levels, const WindGrid& grid);
  Status findKinds(std::span<const PressureLevel> levels, const WindGrid& grid, std::vector<shared::WindLevel>& blocks);
  Status loadPrograms();
  void solveMultigrid(const GpuFields& fields, SolveStart start, int cycles);
  void recordCycles(const GpuFields& fields, int cycles);
  void solveJacobi(const GpuFields& fields, const gpu::Buffer& spare, int sweeps);
  std::size_t goDown(std::size_t level, const gpu::Program& program, const gpu::Buffer* commands);
  void goUp(std::size_t level, const gpu::Buffer* commands);
  void runTail(const gpu::Program& program, const gpu::Buffer* commands);
  void addUp(const gpu::Program& program, glm::ivec2 groups, const gpu::Buffer* commands) const;
  std::size_t findFlux(const GpuFields& fields);
  void bindLevel(std::size_t level) const;
  static const gpu::Buffer& bindScratch(const GpuFields& fields, const gpu::Buffer& star);
  [[nodiscard]] const gpu::Buffer& fluxOf(std::size_t level) const;
  [[nodiscard]] const gpu::Buffer& resultOf(std::size_t level) const;
  [[nodiscard]] const Level& at(std::size_t level) const;

  gpu::ShaderLibrary* m_shaders = nullptr;
  std::vector<Level> m_levels;  // with passes of their own; those after them make the tail
  Level m_tail;                 // its first level; faces: of all its levels
  gpu::Buffer m_levelBlocks;    // one every 256 bytes
  gpu::Buffer m_allLevels;      // one after the other
  gpu::Buffer m_kinds;          // of regions, see isPlainRegion()
  gpu::Buffer m_lastInverse;    // of the last level, see denseInverse()
  std::string m_tailDefines;
  gpu::Buffer m_phi;        // the last step's pressure
  gpu::Buffer m_predicted;  // what this step's is expected to be
  gpu::Buffer m_d;          // level 0: what the cycle found
  gpu::Buffer m_flux;       // residual of level 0 in even cycles
  const gpu::Program *m_first = nullptr, *m_again = nullptr, *m_down = nullptr, *m_up = nullptr, *m_top = nullptr;
  const gpu::Program *m_start = nullptr, *m_endCycle = nullptr, *m_report = nullptr, *m_startTail = nullptr;
  const gpu::Program *m_adopt = nullptr, *m_runTail = nullptr, *m_jacobiFirst = nullptr, *m_jacobi = nullptr;
  const gpu::Program *m_project = nullptr, *m_projectJacobi = nullptr;
};

}  // namespace windloom
