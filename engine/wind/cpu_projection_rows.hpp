#pragma once
// The two passes over the field around the pressure solve, row by row.

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

/// What a task of a pass found in its rows.
struct RowFindings {
  double fluxSquares = 0;       // of the field as it came
  double predictedSquares = 0;  // after the last pressure was taken off
  double speedSquares = 0;      // u^2 + w^2 over faces i < W, k < H
  double greatestFlux = 0;      // of the field as it came, or as it left
  double cellSquares = 0;       // |cell velocity|^2
  float greatestCellSquare = 0, greatestCellX = 0, greatestCellZ = 0;
  CpuHealth health;
};

/// Rows [begin, end) of: dissipation, health and limits of `moved`, blocked faces; the gradient of the expected
/// pressure taken off into
/// `velocity`; the flux of that into `flux`.
RowFindings predictRowsOf(CpuFields& fields, CpuPlane& flux, int begin, int end);

/// Rows [begin, end) of: the gradient of d = `factor` times `correction` taken off `velocity` into `moved`, phi =
/// expected + d, what the next step may expect, cell velocities.
RowFindings finishRowsOf(CpuFields& fields, const CpuPlane& correction, float factor, int begin, int end);

}  // namespace windloom
