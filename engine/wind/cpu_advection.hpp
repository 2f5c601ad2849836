#pragma once
// Advection of the CPU backend. docs/solver.md section 4.

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

/// Carries `forced` along `velocity`; the result is in `moved` (q*). Needs the ghosts of
/// `velocity` and `forced`.
void advect(CpuFields& fields, ThreadPool& pool);

}  // namespace windloom
