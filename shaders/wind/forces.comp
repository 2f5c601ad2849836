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

#define GHOST_TARGET carried
#include "shaders/wind/ghosts.glsl"
#include "shaders/wind/health.glsl"
#include "shaders/wind/cell_velocity.glsl"
#include "shaders/wind/arrows.glsl"
#include "shaders/wind/gusts.glsl"

shared vec2 increments[WIND_FORCE_GROUP_Z][WIND_FORCE_GROUP_X];

float speedSquare(vec2 v) { return dot(v, v); }

vec2 confinementIncrement(int i, int k, vec2 v) {
  float lowLow = nodeVorticity(i, k), highLow = nodeVorticity(i + 1, k);
  float lowHigh = nodeVorticity(i, k + 1), highHigh = nodeVorticity(i + 1, k + 1);
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

vec2 incrementOf(int i, int k) {
  vec2 v = cellVelocity(i, k);
  vec2 place = cellCentreToWorld(vec2(i, k), wind.minCorner, vec2(wind.hx, wind.hz));
  vec2 sum = vec2(0.0);
  if (wind.tileColumns > 0) sum += arrowIncrement(i, k, place, v);
  if (wind.gusts > 0) sum += gustIncrement(place, v);
  if (wind.confinement > 0.0) sum += confinementIncrement(i, k, v);
  return sum;
}

void main() {
  ivec2 local = ivec2(gl_LocalInvocationID.xy);
  ivec2 cell = ivec2(gl_WorkGroupID.xy) * ivec2(WIND_FORCE_GROUP_X - 1, WIND_FORCE_GROUP_Z - 1) + local - 1;
  ivec2 size = ivec2(wind.width, wind.height);
  // Across a periodic border a cell outside is the one of the other side; elsewhere a border face takes its one cell's.
  ivec2 source = cell;
  source.x = periodicX() ? (cell.x + size.x) % size.x : clamp(cell.x, 0, size.x - 1);
  source.y = periodicZ() ? (cell.y + size.y) % size.y : clamp(cell.y, 0, size.y - 1);
  bool near = cell.x <= size.x && cell.y <= size.y;
  increments[local.y][local.x] = near ? incrementOf(source.x, source.y) : vec2(0.0);
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
