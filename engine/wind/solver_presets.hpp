#pragma once
// Solver settings with a name.

#include <optional>
#include <span>
#include <string_view>

#include "engine/model/project.hpp"

namespace windloom {

struct SolverPreset {
  std::string_view name;  ///< as on the command line: "cwd-sim"
  std::string_view help;  ///< one sentence
  SolverSettings settings;
};

/// "default", and "cwd-sim": the scheme of Choi & Sung, CWD-Sim, 2024 (20 Jacobi sweeps, semi-Lagrangian advection,
/// strong confinement), which on the staggered grid still is the better for it.
std::span<const SolverPreset> solverPresets();

/// The preset of this name, or nothing.
std::optional<SolverSettings> findSolverPreset(std::string_view name);

}  // namespace windloom
