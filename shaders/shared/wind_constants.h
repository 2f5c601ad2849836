// Constants of the wind solver's discretisation, the same on both backends. Meaning: docs/solver.md.
#ifndef WINDLOOM_SHARED_WIND_CONSTANTS_H
#define WINDLOOM_SHARED_WIND_CONSTANTS_H

#define WIND_TILE 16                 // cells per side of a tile of arrows
#define WIND_MIN_RESPONSE 1e-3f      // s: shorter response times of arrows count as this
#define WIND_GUST_RESPONSE 0.5f      // s: how fast the air follows the gusts
#define WIND_GUST_LAYERS 3           // copies of the gust table
#define WIND_GUST_TABLE 256          // texels per side of the gust table
#define WIND_CONFINEMENT_LIMIT 0.2f  // largest increment of confinement a step, part of the local speed
#define WIND_CONFINEMENT_GAIN 0.1f   // 1/s: how fast confinement may make air faster at most
#define WIND_CONFINEMENT_SOFTNESS 0.25f  // gradients of vorticity below this part of it per cell have little direction
// Faces of an open border on each side of one that say how much of the ambient wind enters there. In a pocket behind an
// obstacle at the inflow 4, 8 and 24 all kept neighbouring faces from moving against each other.
#define WIND_INFLOW_REACH 8
#define WIND_ROUNDING_FLOOR 2e-7f    // residual that single precision can't see past, part of RMS speed times cell size
#define WIND_VISCOSITY_SWEEPS 64     // most Chebyshev sweeps of the implicit viscosity

// The smoother of the pressure solve: one sweep of this weight before a coarser level, WIND_SWEEPS_UP after it with the
// reciprocal Chebyshev points of [WIND_SMOOTH_FROM, 2] as weights.
#define WIND_SMOOTH_DOWN 0.8f
#define WIND_SWEEPS_UP 5
#define WIND_SMOOTH_FROM 0.3f
#define WIND_DENSE_CELLS 64          // levels of at most so many cells are solved exactly

#endif
