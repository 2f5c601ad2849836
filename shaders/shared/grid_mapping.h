// The one mapping between world metres and the wind grid, shared by C++ and GLSL: solver, grass,
// overlays, terrain and bakes all use it, so that nothing is ever off by half a texel.
//
// The field is a rectangle in the XZ plane; cell (i, k) has i along +X and k along +Z, cell (0, 0)
// at the low corner. Texel (i, k) of a texture is the value at the centre of cell (i, k).
#ifndef WINDLOOM_SHARED_GRID_MAPPING_H
#define WINDLOOM_SHARED_GRID_MAPPING_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

struct GridMapping {
  vec2 minCorner;   // world position of the low corner, m
  vec2 size;        // extent of the field, m
  ivec2 resolution; // cells
  vec2 cellSize;    // size / resolution, m
};

/// World position (x, z) in m to texture coordinates: 0..1 inside the field.
WL_FUNCTION vec2 worldToUv(vec2 world, vec2 minCorner, vec2 size) { return (world - minCorner) / size; }

/// Centre of cell (i, k) in the world, m. For faces of a staggered grid pass i or k minus one half.
WL_FUNCTION vec2 cellCentreToWorld(vec2 cell, vec2 minCorner, vec2 cellSize) {
  return minCorner + (cell + vec2(0.5f, 0.5f)) * cellSize;
}

/// Continuous cell coordinates: (i, k) exactly at the centre of cell (i, k).
WL_FUNCTION vec2 worldToCell(vec2 world, vec2 minCorner, vec2 cellSize) {
  return (world - minCorner) / cellSize - vec2(0.5f, 0.5f);
}

WL_SHARED_END
#endif
