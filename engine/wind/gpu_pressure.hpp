#pragma once
// The pressure solve of the GPU backend: multigrid or plain Jacobi sweeps. docs/solver.md section 6, with the levels
// and sweeps of shaders/shared/wind_gpu_constants.h.

#include <span>
#include <string>
#include <vector>

#include "engine/gpu/program.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/wind/gpu_fields.hpp"
#include "engine/wind/pressure_levels.hpp"

namespace windloom {

class GpuPressure {
 public:
  /// Fails with Machine: no memory, or a shader that doesn't compile.
  static Result<GpuPressure> create(GpuFields& fields, gpu::ShaderLibrary& shaders);

  /// Makes the levels again after the solids changed.
  Status rebuild(GpuFields& fields);

  /// Records a solve of at most `cycles` V-cycles for the velocity `star` (q*), starting from the last step's pressure.
  /// The GPU skips cycles once it has converged.
  void solve(const GpuFields& fields, const gpu::Buffer& star, int cycles);

  /// u = q* - grad phi - grad d into `result` with ghosts, phi += d, cell velocities and the numbers of the step.
  void project(const GpuFields& fields, const gpu::Buffer& star, const gpu::Buffer& result);

  /// Forgets the last step's pressure.
  void reset() { m_planes[m_phi].clear(); }

  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  struct Level {
    shared::WindLevel block{};
    glm::ivec2 factor{1};                    // to the next level
    gpu::Buffer faces, inverse, flux;        // not on level 0; flux: the right-hand side
    gpu::Buffer down, up;                    // d after the way down and after the way up; not on level 0
    const gpu::Program* downward = nullptr;  // on level 0 of the cycles after the first
    const gpu::Program* upward = nullptr;
  };
  Status makeLevel(Level& level, const PressureLevel& source);
  Status makeTail(std::span<const PressureLevel> levels, std::size_t first);
  Status sendLevels(std::span<const PressureLevel> levels, const WindGrid& grid);
  Status loadPrograms();
  void solveMultigrid(const GpuFields& fields, int cycles);
  void solveJacobi(const GpuFields& fields, int sweeps);
  void startWith(const gpu::Program& first, const gpu::Buffer& control);
  void goDown(std::size_t level, const gpu::Program& program, const gpu::Buffer* control);
  void goUp(std::size_t level, const gpu::Buffer& control);
  void runTail(const gpu::Buffer& control);
  void bindLevel(std::size_t level) const;
  static void bindScratch(const GpuFields& fields, const gpu::Buffer& star);
  [[nodiscard]] const gpu::Buffer& fluxOf(std::size_t level) const;
  [[nodiscard]] const gpu::Buffer& downOf(std::size_t level) const;
  [[nodiscard]] const gpu::Buffer& upOf(std::size_t level) const;
  [[nodiscard]] const gpu::Buffer& facesOf(std::size_t level) const;

  gpu::ShaderLibrary* m_shaders = nullptr;
  std::vector<Level> m_levels;  // with passes of their own; those after them make the tail
  gpu::Buffer m_levelBlocks;    // one every 256 bytes
  gpu::Buffer m_allLevels;      // one after the other
  gpu::Buffer m_tailFaces, m_tailInverse, m_tailFlux, m_tailUp;
  std::string m_tailDefines;
  gpu::Buffer m_planes[3];  // phi, d after the way down and d after the way up of level 0 take turns in these
  gpu::Buffer m_flux;       // residual of level 0 in even cycles
  std::size_t m_phi = 0, m_down = 1, m_up = 2;
  const gpu::Program *m_first = nullptr, *m_tail = nullptr, *m_jacobiFirst = nullptr, *m_jacobi = nullptr;
  const gpu::Program *m_project = nullptr, *m_projectJacobi = nullptr;
};

}  // namespace windloom
