#pragma once
// Forces of the CPU backend: arrows, gusts, vorticity confinement. docs/solver.md section 3.

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

/// forced = velocity + increments. Needs the ghosts of `velocity` and the cell velocities with their ghosts.
void applyForces(CpuFields& fields, ThreadPool& pool, std::span<const ArrowForce> arrows, const ArrowTiles& tiles, double time);

}  // namespace windloom
