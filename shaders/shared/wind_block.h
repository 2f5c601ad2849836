// What every pass of the GPU wind solver knows (std140), and where its buffers are bound. docs/solver.md names the
// arrays.
#ifndef WINDLOOM_SHARED_WIND_BLOCK_H
#define WINDLOOM_SHARED_WIND_BLOCK_H
#include "shaders/shared/language.h"
#include "shaders/shared/wind_constants.h"
#include "shaders/shared/wind_gpu_constants.h"
#include "shaders/shared/wind_gust.h"
WL_SHARED_BEGIN

#define WIND_BORDER_OPEN 0
#define WIND_BORDER_WALL 1
#define WIND_BORDER_PERIODIC 2

// Cell flags: neighbours that air reaches, sides that are open to the ground (p = 0), solid, and whether the node at
// the cell's low corner touches a solid cell.
#define WIND_LINK_X_LOW 1u
#define WIND_LINK_X_HIGH 2u
#define WIND_LINK_Z_LOW 4u
#define WIND_LINK_Z_HIGH 8u
#define WIND_GROUND_X_LOW 16u
#define WIND_GROUND_X_HIGH 32u
#define WIND_GROUND_Z_LOW 64u
#define WIND_GROUND_Z_HIGH 128u
#define WIND_SOLID 256u
#define WIND_SOLID_NODE 512u
#define WIND_ALL_LINKS 15u

// Uniform buffers.
#define WIND_UBO_BLOCK 0
#define WIND_UBO_LEVEL 1   // the level at hand
#define WIND_UBO_LEVELS 2  // all of them

// Images.
#define WIND_IMAGE_CELLS 0

// Storage buffers of the velocity passes.
#define WIND_SSBO_VELOCITY 0
#define WIND_SSBO_CARRIED 1
#define WIND_SSBO_FIRST 2
#define WIND_SSBO_RESULT 3
#define WIND_SSBO_ARROWS 4
#define WIND_SSBO_TILE_START 5
#define WIND_SSBO_TILE_ARROWS 6
#define WIND_SSBO_CONTROL 7
#define WIND_SSBO_GUSTS 8
#define WIND_SSBO_ARROW_INCREMENTS 9
#define WIND_SSBO_BUSY_TILES 10
#define WIND_SSBO_FLAGS 15         // in every pass

// Storage buffers of the pressure passes.
#define WIND_SSBO_PHI 1            // the last step's
#define WIND_SSBO_D_IN 2
#define WIND_SSBO_DENSE 3          // tail: the inverse of the last level
#define WIND_SSBO_KINDS 3          // other passes of the cycles: of their regions, 1: plain
#define WIND_SSBO_D_OUT 4
#define WIND_SSBO_FLUX 5
#define WIND_SSBO_FACES 6          // not on level 0
#define WIND_SSBO_PREDICTED 6      // on level 0 only: what phi of this step is expected to be
#define WIND_SSBO_COARSE 8
#define WIND_SSBO_COARSE_FACES 9
#define WIND_SSBO_COARSER 10       // two levels down
#define WIND_SSBO_SUMS 11
#define WIND_SSBO_APPLIED 12       // A z, then the residual of odd cycles
#define WIND_SSBO_LAST_APPLIED 13  // A p of this cycle and the last, taking turns
#define WIND_SSBO_JOINED 14        // p, then the solution

struct WindBlock {
  int width, height;   // cells
  int stride;          // floats from row to row of a velocity array
  int zFaces;          // where the z-faces begin in a velocity buffer
  float hx, hz;        // m
  float perHx, perHz;  // 1/m
  vec2 minCorner;      // m
  float dt;            // s
  float maxSpeed;      // m/s
  vec2 ambient;        // m/s, without gusts
  float gustAmplitude; // m/s
  float gustPart;      // share of the lack that gusts make good in a step
  int xMin, xMax, zMin, zMax;                      // WIND_BORDER_*
  float wallXMin, wallXMax, wallZMin, wallZMax;    // m/s, where noSlip
  int noSlip;          // 0 or 1
  int tileColumns;     // arrow tiles in a row; 0: no arrows
  int tileSide;        // cells
  float keep;          // 1 / (1 + dissipation dt)
  float confinement;
  float tolerance;     // RMS(div) after / before that ends the pressure solve
  float perAir;        // 1 / number of air cells
  float perCell;       // 1 / number of cells
  float viscosityX, viscosityZ;  // nu dt / h^2
  float viscosityInverse;        // 1 / (1 + 2 viscosityX + 2 viscosityZ)
  int gusts;           // layers in use: 0 or WIND_GUST_LAYERS
  int ownLevels;       // levels of the pressure solve with passes of their own; the others make the tail
  int allLevels;
  int busyTiles;       // tiles that an arrow reaches
  int mayDrop;         // 1: where the expected pressure is of no use, the solve begins again without it
  int firstGroupsX, firstGroupsZ;  // work-groups of the flux pass
  int paddingA, paddingB;
  WindGustLayer gustLayers[WIND_GUST_LAYERS];
};

// Indirect dispatches of the pressure solve.
#define WIND_COMMAND_DOWN 0                     // + level
#define WIND_COMMAND_UP WIND_MAX_LEVELS         // + level
#define WIND_COMMAND_TAIL (2 * WIND_MAX_LEVELS)
#define WIND_COMMAND_FIRST (WIND_COMMAND_TAIL + 1)  // the first pass of the solve once more
#define WIND_COMMANDS (WIND_COMMAND_TAIL + 2)

// One level of the pressure solve (std140).
struct WindLevel {
  int width, height;              // cells
  int coarseWidth, coarseHeight;  // of the next level; 0 on the last
  int factorX, factorZ;           // cells of this level in one of the next: 1 or 2
  int xMin, xMax, zMin, zMax;     // WIND_BORDER_*
  float scaleX, scaleZ;           // conductance of a whole face between whole cells
  float coarseScaleX, coarseScaleZ;
  int coarseFactorX, coarseFactorZ;  // of the next level
  int pair;                       // 1: its way down takes the next level along
  int upGroupsX, upGroupsZ;       // work-groups of its passes
  int downGroupsX, downGroupsZ;
  int cells;                      // tail: where its cells begin in shared memory
  int faces;                      // tail: where its nodes begin, counted without the first level's
  int upKinds, downKinds;         // where the kinds of its regions begin
  int paddingA, paddingB, paddingC;
};

// What is known of the steps before: nothing; what to expect; that it led astray, so that the next step knows nothing.
#define WIND_HISTORY_NONE 0u
#define WIND_HISTORY_GOOD 1u
#define WIND_HISTORY_BAD 2u

// What a step tells the CPU, and the work-groups of the passes of the pressure solve: none once it has converged.
struct WindControl {
  float fluxBefore, fluxStart;    // mean squares over air cells of f0 and b, m^4/s^2
  float wanted;                   // mean square of the flux that ends the solve
  float flux;                     // mean square of the residual after the last cycle
  uint cycles;                    // done this step
  uint nonFinite;                 // cells reset since the start
  uint firstNonFinite;            // k * width + i; 0xffffffff: none
  float maxFluxBefore;            // m^2/s
  float fluxAfter, maxFluxAfter;  // mean square and greatest size, m^2/s
  float energy;                   // mean of |v|^2 / 2
  float maxSpeedSquare;           // m^2/s^2
  float crossing;                 // cells a step
  float alpha, beta;              // how far to go along p, and how much of the last p is taken off z
  float size;                     // A p . A p
  uint history;                   // WIND_HISTORY_*
  uint paddingA, paddingB, paddingC;
  uint groups[WIND_COMMANDS * 4]; // indirect dispatches: x, y, z of each command
};

WL_SHARED_END
#ifdef __cplusplus
#include <cstddef>
static_assert(sizeof(windloom::shared::WindBlock) == 176 + 96, "std140 layout");
static_assert(offsetof(windloom::shared::WindBlock, minCorner) == 32, "std140 layout");
static_assert(offsetof(windloom::shared::WindBlock, ambient) == 48, "std140 layout");
static_assert(offsetof(windloom::shared::WindBlock, gustLayers) == 176, "std140 layout");
static_assert(sizeof(windloom::shared::WindLevel) == 112, "std140 layout");
static_assert(offsetof(windloom::shared::WindControl, groups) == 80, "std430 layout");
#endif
#endif
