// How the GPU wind solver cuts its work, the same in C++ and GLSL. These don't change results beyond the tolerance of the
// pressure solve, only speed: docs/benchmarks.md says what was measured.
#ifndef WINDLOOM_SHARED_WIND_GPU_CONSTANTS_H
#define WINDLOOM_SHARED_WIND_GPU_CONSTANTS_H

// Work-group of the passes that work on faces and cells one by one.
#define WIND_GROUP_X 32
#define WIND_GROUP_Z 8

// Work-group of the force pass: all but its first row and column write faces.
#define WIND_FORCE_GROUP_X 32
#define WIND_FORCE_GROUP_Z 16

// Pressure: a work-group holds a region of WIND_REGION x WIND_REGION cells in shared memory and registers, each invocation
// a strip of WIND_STRIP cells along z; the inner cells, WIND_HALO from each side, are its result.
#define WIND_REGION 64
#define WIND_STRIP 4
#define WIND_HALO 8
#define WIND_INNER (WIND_REGION - 2 * WIND_HALO)
#define WIND_STRIPS (WIND_REGION / WIND_STRIP)

// Smoothing sweeps before and after a coarser level; at most WIND_HALO - 1, since the residual needs one cell more. Their
// weights are the reciprocal Chebyshev points of [WIND_SMOOTH_FROM, 2]. A level is coarsened by four: with 6 or 7 sweeps
// from 0.2 a cycle contracts as much as with 3 from 0.5 and coarsening by two, in half the dispatches.
#define WIND_GPU_SWEEPS 7
#define WIND_SMOOTH_FROM 0.2f

// Levels from this many cells down are solved together by one work-group of WIND_TAIL_GROUP invocations.
#define WIND_TAIL_CELLS 4096
#define WIND_TAIL_GROUP 1024
#define WIND_MAX_LEVELS 16

#endif
