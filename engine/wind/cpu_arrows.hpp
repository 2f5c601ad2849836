#pragma once
// What the arrows of a tile do to its cells. docs/solver.md section 3, "Arrows".

#include <span>

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

/// Cells [iBegin, iEnd) x [kBegin, kEnd).
struct CellBlock {
  int iBegin, iEnd, kBegin, kEnd;
};

/// Sets (not adds) the increments, m/s, of the block's cells from the arrows named by `indices`: cell (iBegin, kBegin)
/// at incrementX[0], the next row `stride` further.
void arrowIncrements(const CpuFields& fields, CellBlock block, std::span<const ArrowForce> arrows,
                     std::span<const std::uint32_t> indices, float* incrementX, float* incrementZ, int stride);

}  // namespace windloom
