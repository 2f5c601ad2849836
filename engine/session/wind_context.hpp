#pragma once
// OpenGL without a window for those who only compute wind: bake, sample, the editor's export.

#include <memory>

#include "engine/core/result.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/model/project.hpp"
#include "engine/session/simulation.hpp"

namespace windloom {

/// Both null: the CPU computes the wind. Current in the thread that opened it; end it there.
struct WindContext {
  std::unique_ptr<gpu::Context> context;
  std::unique_ptr<gpu::ShaderLibrary> shaders;
};

/// What the wind of a project needs: nothing for the CPU backend; an offscreen context for the GPU one, failing with
/// Machine where there is none; for Auto a context only where a real GPU is behind it. `asked` (--backend) comes
/// before the project's own choice.
Result<WindContext> openWindContext(Backend asked, const Project& project);

/// A simulation on that context. `threads` as for ThreadPool.
Result<std::unique_ptr<Simulation>> makeSimulation(const Project& project, Backend asked, const WindContext& wind,
                                                   int threads);

}  // namespace windloom
