// How the GPU wind solver cuts its work, the same in C++ and GLSL. These don't change results beyond rounding, only
// speed: docs/benchmarks.md says what was measured.
#ifndef WINDLOOM_SHARED_WIND_GPU_CONSTANTS_H
#define WINDLOOM_SHARED_WIND_GPU_CONSTANTS_H
#include "shaders/shared/wind_constants.h"

// Work-group of the passes that work on faces and cells one by one.
#define WIND_GROUP_X 32
#define WIND_GROUP_Z 16

// The last pass: cells along z of each invocation, so that few partial sums are left.
#define WIND_PROJECT_STRIP 2

// Work-group of the force pass: all but its first row and column write faces.
#define WIND_FORCE_GROUP_X 32
#define WIND_FORCE_GROUP_Z 16

// Pressure: a work-group holds a square region of cells in shared memory and registers, each invocation a strip of
// WIND_STRIP cells along z. Coarser levels have few cells: smaller regions keep more of the GPU busy.
#define WIND_FINE_REGION 64
#define WIND_COARSE_REGION 32
#define WIND_STRIP 4

// On the way up the inner cells, WIND_HALO from each side, are the result: one cell for each sweep, one for the
// residual. Even, so that the cells of a coarser one stay together.
#define WIND_HALO (WIND_SWEEPS_UP + 1)
#define WIND_INNER(REGION) ((REGION) - 2 * WIND_HALO)

// On the way down a work-group answers for this many cells of the next level along each axis: around them lie a ring of
// that level, and of this one a ring for the residual and one for the flux.
#define WIND_DOWN_INNER(REGION) (((REGION) - 4) / 2 - 2)

// Levels from this many cells down are solved together by one work-group of WIND_TAIL_GROUP invocations.
#define WIND_TAIL_CELLS 1024
#define WIND_TAIL_GROUP 1024
#define WIND_MAX_LEVELS 24

// The work-group that adds up the sums of the others.
#define WIND_TOTAL_GROUP 512

#endif
