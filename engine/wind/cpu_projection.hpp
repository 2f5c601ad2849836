#pragma once
// Projection of the CPU backend around the pressure solve, and what follows it. docs/solver.md sections 2, 6 and 7.

#include "engine/wind/cpu_fields.hpp"
#include "engine/wind/cpu_multigrid.hpp"

namespace windloom {

/// What the projection reports.
struct ProjectionReport {
  double divergenceBefore = 0, divergenceAfter = 0, maxDivergenceAfter = 0;  // 1/s
  int cycles = 0;
};

/// Makes `moved` free of divergence into `velocity`, and keeps phi for the next step.
ProjectionReport project(CpuFields& fields, CpuMultigrid& multigrid, ThreadPool& pool);

/// Sets the cell velocities and their ghosts from `velocity`.
void resampleToCells(CpuFields& fields, ThreadPool& pool);

}  // namespace windloom
