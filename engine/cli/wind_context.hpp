#pragma once
// The OpenGL that the verbs run the wind on, where there is one worth it.

#include <memory>

#include "engine/core/result.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/model/project.hpp"
#include "engine/session/simulation.hpp"

namespace windloom::cli {

/// Both null: the CPU computes the wind.
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

/// "cpu" or "gpu".
const char* backendName(Backend backend);

}  // namespace windloom::cli
