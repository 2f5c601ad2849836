#pragma once
// What the verbs run the wind on and how they tell of it: OpenGL where there is one worth it, solver schemes,
// diagnostics.

#include <memory>

#include "engine/cli/common.hpp"
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

/// How the verbs that simulate begin and run: --initial, --initial-time, --solver, --threads.
struct RunOptions {
  std::string initial;     ///< .npy of the wind to start from; empty: rest
  double initialTime = 0;  ///< s: the moment it holds
  std::string solver;      ///< preset; empty: the project's settings
  int threads = 0;         ///< 0: all
};
void addRunOptions(CLI::App& app, RunOptions& options);

/// Adds --solver NAME, a solver preset by name.
void addSolverOption(CLI::App& app, std::string& name);

/// Puts the preset of this name on the project; nothing where the name is empty, Usage where it is unknown.
Status useSolver(Project& project, const std::string& name);

/// All that the solver told of a step; "residual" is the part of the divergence that the projection left.
Json diagnosticsJson(const WindDiagnostics& diagnostics);

}  // namespace windloom::cli
