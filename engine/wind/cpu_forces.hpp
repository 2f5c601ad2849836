#pragma once
// Forces of the CPU backend: arrows, gusts, vorticity confinement. docs/solver.md section 3.

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

/// forced = velocity + increments; what isn't finite becomes the ambient wind. Needs the ghosts of `velocity` and the
/// cell velocities with their ghosts.
CpuHealth applyForces(CpuFields& fields, ThreadPool& pool, std::span<const ArrowForce> arrows, const ArrowTiles& tiles,
                      double time);

}  // namespace windloom
