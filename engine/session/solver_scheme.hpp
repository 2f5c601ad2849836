#pragma once
// Solver presets put to use on a project: a preset says how the wind is computed, not where and from which seed.

#include "engine/model/project.hpp"
#include "engine/wind/solver_presets.hpp"

namespace windloom {

/// The preset's settings with backend, seed, speed limit and unknown keys of `current`.
SolverSettings withScheme(const SolverSettings& current, const SolverPreset& preset);

/// Whether withScheme would change nothing.
bool hasScheme(const SolverSettings& current, const SolverPreset& preset);

}  // namespace windloom
