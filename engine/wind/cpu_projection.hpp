#pragma once
// Everything after the advection on the CPU backend: dissipation, health, borders, projection, cell velocities.
// docs/solver.md sections 2, 6 and 7.

#include "engine/wind/cpu_fields.hpp"
#include "engine/wind/cpu_multigrid.hpp"

namespace windloom {

/// What a step reports.
struct ProjectionReport {
  double divergenceBefore = 0, maxDivergenceBefore = 0, divergenceAfter = 0, maxDivergenceAfter = 0;  // 1/s
  int cycles = 0;
  double kineticEnergy = 0, maxSpeed = 0, cfl = 0;
  CpuHealth health;
};

/// The next projection starts from nothing.
void forgetPressure(CpuFields& fields);

/// Settles `moved` and makes it free of divergence into `velocity`; keeps phi for the next step and sets the cell
/// velocities with their ghosts. `moved` is overwritten.
ProjectionReport project(CpuFields& fields, CpuMultigrid& multigrid, ThreadPool& pool);

/// Sets the cell velocities and their ghosts from `velocity`.
void resampleToCells(CpuFields& fields, ThreadPool& pool);

}  // namespace windloom
