#version 450 core
// Uneven ground as tiles of a lattice. A vertex beside a coarser neighbour moves onto the neighbour's lattice, so that
// no gap opens between them. Tiles around the rectangle carry its edge's height out to the horizon.
#include "shaders/include/frame.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/shared/ground_tile.h"

layout(std430, binding = RENDER_SSBO_GROUND_TILES) readonly buffer Tiles { GroundTile tiles[]; };
uniform int firstTile;
uniform int level;
uniform float reach;  // m from the rectangle to the horizon

out vec3 groundWorld;

int onLattice(int at, uint around, int shift) { return (at >> int(around >> shift & 255u)) << int(around >> shift & 255u); }

// World coordinate along one axis.
float along(int tile, int at, int axis) {
  int last = int(frame.groundGrid[axis]) - 1;
  int count = (last + GROUND_TILE_SIDE - 1) / GROUND_TILE_SIDE;
  float low = frame.ground[axis];
  float spacing = 1.0 / frame.ground[2 + axis];
  if (tile > 0 && tile <= count) return low + spacing * float(min((tile - 1) * GROUND_TILE_SIDE + at, last));
  float out0 = float(tile == 0 ? GROUND_TILE_SIDE - at : at) / float(GROUND_TILE_SIDE);
  float beyond = reach * out0 * out0 * out0;
  return tile == 0 ? low - beyond : low + spacing * float(last) + beyond;
}

void main() {
  GroundTile tile = tiles[firstTile + gl_InstanceID];
  int side = (GROUND_TILE_SIDE >> level) + 1;
  ivec2 at = ivec2(gl_VertexID % side, gl_VertexID / side) << level;
  if (at.x == 0) at.y = onLattice(at.y, tile.around, 0);
  if (at.x == GROUND_TILE_SIDE) at.y = onLattice(at.y, tile.around, 8);
  if (at.y == 0) at.x = onLattice(at.x, tile.around, 16);
  if (at.y == GROUND_TILE_SIDE) at.x = onLattice(at.x, tile.around, 24);
  vec2 place = vec2(along(int(tile.x), at.x, 0), along(int(tile.z), at.y, 1));
  groundWorld = vec3(place.x, groundHeight(place), place.y);
  gl_Position = frame.viewProjection * vec4(groundWorld, 1.0);
}
