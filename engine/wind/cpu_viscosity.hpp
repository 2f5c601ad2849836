#pragma once
// Implicit viscosity of the CPU backend. docs/solver.md section 5.

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

/// Diffuses `moved` over one step; `forced` and `corrected` are overwritten. Does nothing without viscosity.
void diffuse(CpuFields& fields, ThreadPool& pool);

/// Sweeps of the Chebyshev semi-iteration for a diagonal of 1 + 2 bx + 2 bz.
int viscositySweeps(double diagonal);

}  // namespace windloom
