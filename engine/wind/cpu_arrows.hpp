#pragma once
// What the arrows of a tile do to its cells. docs/solver.md section 3, "Arrows".

#include <span>

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

/// An arrow with what is the same for all cells.
struct PreparedArrow {
  glm::vec2 from, to;
  glm::vec2 along;      // to - from, in radii
  glm::vec2 partPer;    // part of the way from `from` to `to` that a radius along x (z) makes; 0 for a disc
  glm::vec2 direction;  // the way it drives: turned round where the strength is negative
  float inverseRadius;
  float rate, rateRoot;  // 1/s at the axis; its eighth root
  float strength, swirl, zLow, zHigh;
  bool speedDrive;
  explicit PreparedArrow(const ArrowForce& arrow);
};

/// Cells [iBegin, iEnd) x [kBegin, kEnd).
struct CellBlock {
  int iBegin, iEnd, kBegin, kEnd;
};

/// Increments of cells, m/s, from a block's first cell on.
struct CellIncrements {
  float *x, *z;
  std::ptrdiff_t stride;
};

/// Sets (not adds) the increments of the block's cells from the arrows named by `indices`. Up to WIND_TILE - 1 values
/// beyond a row's end are written too.
void arrowIncrements(const CpuFields& fields, CellBlock block, std::span<const PreparedArrow> arrows,
                     std::span<const std::uint32_t> indices, CellIncrements out);

}  // namespace windloom
