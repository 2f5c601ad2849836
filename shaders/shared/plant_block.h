// Plants other than blades as their passes see them (std430).
#ifndef WINDLOOM_SHARED_PLANT_BLOCK_H
#define WINDLOOM_SHARED_PLANT_BLOCK_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

// Species drawn at most; further ones are left out.
#define PLANT_KINDS 16
// Levels of detail: the mesh, and a smaller one.
#define PLANT_LEVELS 2u
#define PLANT_GROUP 64

/// A species.
struct PlantKind {
  vec4 size;    // x height m, y its variation, z m of the mesh's unit at that height, w widest part over the height
  vec4 growth;  // x mean number of candidates in a cell, y patchiness, z patch size m, w side of a cell m
  vec4 motion;  // x F / stiffness s/m, y stiffness variation, z flutter, w slope alignment
  vec4 levels;  // x height in pixels from which the mesh is drawn, y width in pixels below which plants are thinned,
                // z height in pixels at which they are gone, w most widening of thinned ones
  vec4 tint;    // rgb times the mesh's colour; w 1 for a built-in flower, 0 for a mesh from a file
  uint seed;
  uint first[2];  // per level: place of the first plant in the list
  uint room[2];   // and how many fit
  uint padding[3];
};

/// A plant ready to be drawn. 48 bytes.
struct PlantInstance {
  float x;     // root, m
  float y;
  float z;
  uint sizes;  // half2: height over that of the species, widening
  uint bend;   // half2: direction times angle of its tip, rad
  uint turn;   // snorm2x16: cosine and sine of its yaw
  uint tilt;   // snorm2x16: x and z of the unit vector it grows along
  uint shade;  // half2: height of shadows over the root m, |F| of CWD-Sim eq. 14
  uint tint;   // unorm4: half the brightness, hue from -1..1, openness beside solids, phase
  uint felt;   // half2: wind that flutters its petals, m/s
  uint canopy; // half2: height of the grass around it m, sunlight the slope takes over level ground
  uint place;  // hash of the plant
};

/// glDrawElementsIndirect arguments.
struct PlantCommand {
  uint count;
  uint instances;
  uint firstIndex;
  uint baseVertex;
  uint baseInstance;
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::PlantKind) == 112, "std430 layout");
static_assert(sizeof(windloom::shared::PlantInstance) == 48, "std430 layout");
static_assert(sizeof(windloom::shared::PlantCommand) == 20, "std430 layout");
#endif
#endif
