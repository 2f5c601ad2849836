#version 450 core
// Forces: q = u + increments of arrows, gusts and vorticity confinement. docs/solver.md section 3. Increments are found
// in cell centres, shared in the work-group, and averaged to the faces; the first row and column of a group are there
// for that only.
#include "shaders/shared/grid_mapping.h"
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_FORCE_GROUP_X, local_size_y = WIND_FORCE_GROUP_Z) in;
layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Velocity { float velocity[]; };
layout(std430, binding = WIND_SSBO_CARRIED) writeonly buffer Carried { float carried[]; };
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };

#define WIND_GHOSTS_OF_VELOCITY
#define GHOST_TARGET carried
#include "shaders/wind/ghosts.glsl"
#include "shaders/wind/health.glsl"
#include "shaders/wind/cell_velocity.glsl"
layout(std430, binding = WIND_SSBO_TILE_START) readonly buffer TileStart { uint tileStart[]; };
layout(std430, binding = WIND_SSBO_ARROW_INCREMENTS) readonly buffer ArrowIncrements { vec2 arrowIncrements[]; };
#include "shaders/wind/gusts.glsl"

shared vec2 increments[WIND_FORCE_GROUP_Z][WIND_FORCE_GROUP_X];
shared float vorticity[WIND_FORCE_GROUP_Z + 1][WIND_FORCE_GROUP_X + 1];  // at the nodes around the group's cells

// The cell of this grid that a cell of the group stands for: across a periodic border the one of the other side;
// elsewhere a border face takes its one cell's.
ivec2 sourceOf(ivec2 cell) {
  ivec2 size = ivec2(wind.width, wind.height);
  return ivec2(periodicX() ? (cell.x + size.x) % size.x : clamp(cell.x, 0, size.x - 1),
               periodicZ() ? (cell.y + size.y) % size.y : clamp(cell.y, 0, size.y - 1));
}

// Node (n, m) of the group is the low corner of its cell (n, m), the last ones the high corners of the last cells.
void shareVorticity(ivec2 firstCell) {
  const int across = WIND_FORCE_GROUP_X + 1, count = across * (WIND_FORCE_GROUP_Z + 1);
  for (int n = int(gl_LocalInvocationIndex); n < count; n += WIND_FORCE_GROUP_X * WIND_FORCE_GROUP_Z) {
    ivec2 local = ivec2(n % across, n / across), node = firstCell + local, size = ivec2(wind.width, wind.height);
    node.x = periodicX() ? (node.x + size.x) % size.x : clamp(node.x, 0, size.x);
    node.y = periodicZ() ? (node.y + size.y) % size.y : clamp(node.y, 0, size.y);
    vorticity[local.y][local.x] = nodeVorticity(node.x, node.y);
  }
  barrier();
}

float speedSquare(vec2 v) { return dot(v, v); }

vec2 confinementIncrement(ivec2 local, vec2 v) {
  float lowLow = vorticity[local.y][local.x], highLow = vorticity[local.y][local.x + 1];
  float lowHigh = vorticity[local.y + 1][local.x], highHigh = vorticity[local.y + 1][local.x + 1];
  float a = abs(lowLow), b = abs(highLow), c = abs(lowHigh), d = abs(highHigh);
  vec2 eta = vec2((b + d) - (a + c), (c + d) - (a + b)) * 0.5 * vec2(wind.perHx, wind.perHz);
  float omega = ((lowLow + highLow) + (lowHigh + highHigh)) * 0.25;
  float h = sqrt(wind.hx * wind.hz);
  vec2 perHalf = 0.5 * vec2(wind.perHx, wind.perHz);
  float blur = 0.25 * WIND_CONFINEMENT_SOFTNESS * sqrt(2.0 * dot(perHalf, perHalf)) * ((a + b) + (c + d)) + 1e-5 / h;
  float push = wind.dt * wind.confinement * h * omega / (length(eta) + blur);
  vec2 added = vec2(push * eta.y, -push * eta.x);
  float own = speedSquare(v), size = speedSquare(added);
  float allowed = WIND_CONFINEMENT_LIMIT * WIND_CONFINEMENT_LIMIT * own;
  if (size > allowed) added *= sqrt(allowed / size);
  float gain = 1.0 + WIND_CONFINEMENT_GAIN * wind.dt, fastest = gain * gain * own;
  vec2 next = v + added;
  float reached = speedSquare(next);
  return (reached > fastest ? next * sqrt(fastest / reached) : next) - v;
}

// What arrows.comp found; it leaves out tiles that no arrow reaches.
vec2 arrowIncrement(int i, int k) {
  int tile = (k / wind.tileSide) * wind.tileColumns + i / wind.tileSide;
  return tileStart[tile] < tileStart[tile + 1] ? arrowIncrements[cellAt(i, k)] : vec2(0.0);
}

vec2 incrementOf(ivec2 local, int i, int k) {
  vec2 v = cellVelocity(i, k);
  vec2 place = cellCentreToWorld(vec2(i, k), wind.minCorner, vec2(wind.hx, wind.hz));
  vec2 sum = vec2(0.0);
  if (wind.tileColumns > 0) sum += arrowIncrement(i, k);
  if (wind.gusts > 0) sum += gustIncrement(place, v);
  if (wind.confinement > 0.0) sum += confinementIncrement(local, v);
  return sum;
}

void main() {
  ivec2 local = ivec2(gl_LocalInvocationID.xy);
  ivec2 firstCell = ivec2(gl_WorkGroupID.xy) * ivec2(WIND_FORCE_GROUP_X - 1, WIND_FORCE_GROUP_Z - 1) - 1;
  ivec2 cell = firstCell + local, size = ivec2(wind.width, wind.height), source = sourceOf(cell);
  if (wind.confinement > 0.0) shareVorticity(firstCell);
  bool near = cell.x <= size.x && cell.y <= size.y;
  ivec2 standIn = local + ivec2(periodicX() ? 0 : source.x - cell.x, periodicZ() ? 0 : source.y - cell.y);
  increments[local.y][local.x] = near ? incrementOf(standIn, source.x, source.y) : vec2(0.0);
  barrier();
  if (local.x == 0 || local.y == 0 || !near) return;
  vec2 own = increments[local.y][local.x];
  uint bad = 0u;
  if (cell.y < size.y) {
    float added = 0.5 * (increments[local.y][local.x - 1].x + own.x);
    storeU(cell.x, cell.y, healed(velocity[uAt(cell.x, cell.y)] + added, wind.ambient.x, bad));
  }
  if (cell.x < size.x) {
    float added = 0.5 * (increments[local.y - 1][local.x].y + own.y);
    storeW(cell.x, cell.y, healed(velocity[wAt(cell.x, cell.y)] + added, wind.ambient.y, bad));
  }
  reportUnhealthy(cell.x, cell.y, bad);
}
