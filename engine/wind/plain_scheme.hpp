#pragma once
// The paper's scheme written the plain way, as a yardstick for `windloom bench solver`: collocated grid, textures, one
// pass a dispatch, 20 Jacobi sweeps of one dispatch each, 26 dispatches a step. Source: Choi & Sung, CWD-Sim, 2024, eq.
// 4 to 10, with the corrections of docs/solver.md.

#include <glm/glm.hpp>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/thread_pool.hpp"
#include "engine/gpu/program.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"

namespace windloom {

class PlainScheme {
 public:
  static constexpr int kSweeps = 20;
  static constexpr int kDispatches = 6 + kSweeps;

  /// A field of `cells` cells of one metre. Fails with Machine.
  static Result<PlainScheme> create(gpu::ShaderLibrary& shaders, glm::ivec2 cells);

  /// One step of `dt` seconds: force at the centre of the field, curl, confinement, divergence, sweeps, gradient,
  /// advection.
  void step(float dt);

  /// Velocities of the cells, m/s, row by row; the pressure is forgotten.
  void setVelocity(std::span<const glm::vec2> cells);

  /// As step(), and gives the RMS of the divergence (central differences, 1/s) before and after its projection. Waits
  /// for the GPU.
  std::pair<double, double> measureStep(float dt);
  /// The same for one projection of the velocity as it is, which stays unchanged; the pressure starts from 0.
  std::pair<double, double> measureProjection();

  [[nodiscard]] unsigned velocityTexture() const { return m_velocity[m_at].name(); }
  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  enum Pass { Force, Curl, Confine, Divergence, Sweep, Subtract, Advect, kPasses };
  PlainScheme() = default;
  void run(Pass pass, std::initializer_list<const gpu::Texture*> inputs, const gpu::Texture& output) const;
  void transport(float dt);
  void solve();
  void subtract();
  void advect();
  [[nodiscard]] double rootMeanSquare(const gpu::Texture& texture) const;

  glm::ivec2 m_cells{0};
  const gpu::Program* m_programs[kPasses] = {};
  gpu::Texture m_velocity[2], m_pressure[2], m_curl, m_divergence;
  int m_at = 0;  // which velocity is current
  float m_dt = 1.0f / 60;
};

/// The programs of the scheme.
std::span<const gpu::ProgramSpec> plainPrograms();

/// One plain Jacobi sweep on the CPU, the unit that CPU solvers are measured in: next = (sum of the four neighbours of
/// p - divergence) / 4 on width x height cells, p = 0 outside.
void plainJacobiSweep(ThreadPool& pool, int width, int height, std::span<const float> p,
                      std::span<const float> divergence, std::span<float> next);

}  // namespace windloom
