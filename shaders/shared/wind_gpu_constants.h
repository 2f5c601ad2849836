// How the GPU wind solver cuts its work, the same in C++ and GLSL. These don't change results beyond the tolerance of
// the pressure solve, only speed: docs/benchmarks.md says what was measured.
#ifndef WINDLOOM_SHARED_WIND_GPU_CONSTANTS_H
#define WINDLOOM_SHARED_WIND_GPU_CONSTANTS_H

// Work-group of the passes that work on faces and cells one by one.
#define WIND_GROUP_X 32
#define WIND_GROUP_Z 8

// Work-group of the force pass: all but its first row and column write faces.
#define WIND_FORCE_GROUP_X 32
#define WIND_FORCE_GROUP_Z 16

// Pressure: a work-group holds a region of WIND_REGION x WIND_REGION cells in shared memory and registers, each
// invocation a strip of WIND_STRIP cells along z; the inner cells, WIND_HALO from each side, are its result.
#define WIND_REGION 64
#define WIND_STRIP 4
#define WIND_HALO 8
#define WIND_INNER (WIND_REGION - 2 * WIND_HALO)
#define WIND_STRIPS (WIND_REGION / WIND_STRIP)

// How many cells of a level, along each axis, make one of the next: 4; or 2 as on the CPU, then with 3 sweeps from 0.5.
#define WIND_GPU_COARSENING 4

// Smoothing sweeps before and after a coarser level; at most WIND_HALO - 1, since the residual needs one cell more.
// Their weights are the reciprocal Chebyshev points of [WIND_SMOOTH_FROM, 2]. Contraction of the residual a cycle,
// measured at 320 x 320 open, first and second joined cycle: by four, 5 sweeps from 0.2: 0.066, 0.033; 6: 0.042, 0.019;
// 7: 0.026, 0.015; with four discs 7: 0.030, 0.036. By two, 3 sweeps from 0.5, contracts like by four with 5 or 6 and
// takes twice the dispatches.
#define WIND_GPU_SWEEPS 7
#define WIND_SMOOTH_FROM 0.2f

// Levels from this many cells down are solved together by one work-group of WIND_TAIL_GROUP invocations.
#define WIND_TAIL_CELLS 4096
#define WIND_TAIL_GROUP 1024
#define WIND_MAX_LEVELS 16

#endif
