#pragma once
// What the verbs run the wind on and how they tell of it: solver schemes, diagnostics.

#include "engine/cli/common.hpp"
#include "engine/core/result.hpp"
#include "engine/model/project.hpp"
#include "engine/session/wind_context.hpp"

namespace windloom::cli {

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
