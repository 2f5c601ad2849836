#pragma once
// Forces, advection and viscosity of the GPU backend: everything of a step before the projection. docs/solver.md
// sections 2 to 5.

#include "engine/gpu/program.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/timer.hpp"
#include "engine/wind/gpu_arrows.hpp"
#include "engine/wind/gpu_fields.hpp"

namespace windloom {

class GpuTransport {
 public:
  /// Fails with Machine where a shader doesn't compile.
  static Result<GpuTransport> create(gpu::ShaderLibrary& shaders);

  /// Forces and advection of a step; the answer is the buffer that holds q*.
  const gpu::Buffer& run(const GpuFields& fields, const GpuArrows& arrows, gpu::GpuTimer& timer) const;

  /// The ghosts of `velocity` where the ambient wind enters; after everything that writes it, with a barrier between.
  void findInflow(const GpuFields& fields) const;

  /// `velocity` from raw faces in `carried`: blocked faces 0, ghosts set.
  void fill(const GpuFields& fields) const;

 private:
  void force(const GpuFields& fields, const GpuArrows& arrows) const;
  void advect(const GpuFields& fields, const gpu::Buffer& carried) const;
  const gpu::Buffer& diffuse(const GpuFields& fields) const;

  const gpu::Program *m_fill = nullptr, *m_inflow = nullptr, *m_arrows = nullptr, *m_forces = nullptr;
  const gpu::Program *m_predict = nullptr, *m_predictSettle = nullptr, *m_correct = nullptr, *m_correctSettle = nullptr;
  const gpu::Program *m_viscosityStart = nullptr, *m_viscosity = nullptr, *m_viscositySettle = nullptr;
};

}  // namespace windloom
