#version 450 core
// What the arrows do to the air of the cells they reach: increments of velocity. docs/solver.md section 3. A work-group
// takes a block of WIND_TILE x WIND_TILE cells of one tile, so that all its cells meet the same arrows; the arrows come
// through shared memory, made ready once for all of them.
#include "shaders/shared/arrow_force.h"
#include "shaders/shared/grid_mapping.h"
#include "shaders/wind/block.glsl"

const int kRows = 4;  // of invocations; each takes kCells cells, kRows apart
const int kCells = WIND_TILE / kRows;
const int kGroup = WIND_TILE * kRows;
layout(local_size_x = WIND_TILE, local_size_y = 4) in;
layout(std430, binding = WIND_SSBO_VELOCITY) readonly buffer Velocity { float velocity[]; };
layout(std430, binding = WIND_SSBO_ARROWS) readonly buffer Arrows { ArrowForce arrows[]; };
layout(std430, binding = WIND_SSBO_TILE_START) readonly buffer TileStart { uint tileStart[]; };
layout(std430, binding = WIND_SSBO_TILE_ARROWS) readonly buffer TileArrows { uint tileArrows[]; };
layout(std430, binding = WIND_SSBO_BUSY_TILES) readonly buffer BusyTiles { uint busyTiles[]; };
layout(std430, binding = WIND_SSBO_ARROW_INCREMENTS) writeonly buffer Increments { vec2 increments[]; };
#include "shaders/wind/cell_velocity.glsl"

// An arrow with what is the same for all cells.
struct Ready {
  vec2 from, along;
  vec2 direction;  // of the pull, turned round for a negative strength
  vec2 to;
  float perSquare;  // 1 / length^2; 0 for a disc
  float radiusSquare, sharpness, rate;
  float strength;  // speed: its size; force: as it is
  float swirlPeak, swirlSign;  // greatest speed of the profile over d; 0: no swirl
  uint kind;
};
const uint kNone = 0u, kSpeed = 1u, kForce = 2u;
shared Ready ready[kGroup];

Ready madeReady(ArrowForce a) {
  Ready r;
  r.from = a.from;
  r.along = a.to - a.from;
  r.to = a.to;
  float square = dot(r.along, r.along);
  r.perSquare = square > 0.0 ? 1.0 / square : 0.0;
  r.radiusSquare = a.radius * a.radius;
  r.sharpness = -2.0 / r.radiusSquare;
  r.rate = min(abs(a.factor), 1.0) / max(a.response, WIND_MIN_RESPONSE);
  bool speed = a.drive == ARROW_DRIVE_SPEED;
  float sign = speed && a.strength < 0.0 ? -1.0 : 1.0;
  r.direction = sign * a.direction;
  r.strength = sign * a.strength;
  r.kind = a.strength == 0.0 ? kNone : speed ? kSpeed : kForce;
  r.swirlPeak = abs(a.swirl) * (2.0 / a.radius) * 1.6487213;  // exp(1/2)
  r.swirlSign = a.swirl >= 0.0 ? 1.0 : -1.0;
  return r;
}

struct Sums {
  float rate;       // drive speed
  vec2 target;
  vec2 force;       // drive force
  float swirlRate;  // swirl
  vec2 swirl;
};
Sums sums[kCells];
vec2 places[kCells], speeds[kCells];

// Falls off from 1 on the arrow to exp(-2) at its radius, 0 beyond.
float influence(Ready r, vec2 place) {
  vec2 from = place - r.from;
  float t = clamp(dot(from, r.along) * r.perSquare, 0.0, 1.0);
  vec2 away = from - t * r.along;
  float d2 = dot(away, away);
  return d2 < r.radiusSquare ? exp(r.sharpness * d2) : 0.0;
}

void addSpeed(Ready r) {
  for (int n = 0; n < kCells; ++n) {
    float rate = influence(r, places[n]) * r.rate;
    if (rate <= 0.0) continue;  // a strength that isn't finite harms no cell but those it reaches
    sums[n].rate += rate;
    sums[n].target += (rate * max(dot(speeds[n], r.direction), r.strength)) * r.direction;
  }
}

void addForce(Ready r) {
  for (int n = 0; n < kCells; ++n) {
    float g = influence(r, places[n]);
    if (g > 0.0) sums[n].force += (g * r.strength) * r.direction;
  }
}

void addSwirl(Ready r) {
  for (int n = 0; n < kCells; ++n) {
    vec2 e = places[n] - r.to;
    float d2 = dot(e, e);
    if (d2 >= r.radiusSquare || d2 <= 0.0) continue;
    float d = sqrt(d2), g = exp(r.sharpness * d2);
    vec2 tangent = vec2(-e.y, e.x) * (r.swirlSign / d);
    float lacking = max(r.swirlPeak * d * g - dot(speeds[n], tangent), 0.0);
    sums[n].swirlRate += g * r.rate;
    sums[n].swirl += (g * r.rate * lacking) * tangent;
  }
}

// (1 - exp(-rate dt)) / rate
float approach(float rate) { return rate * wind.dt < 1e-4 ? wind.dt : (1.0 - exp(-rate * wind.dt)) / rate; }

void main() {
  int job = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x);
  int blocksAcross = wind.tileSide / WIND_TILE, blocks = blocksAcross * blocksAcross;
  if (job >= wind.busyTiles * blocks) return;
  int tile = int(busyTiles[job / blocks]), block = job % blocks;
  ivec2 corner = ivec2(tile % wind.tileColumns, tile / wind.tileColumns) * wind.tileSide +
                 ivec2(block % blocksAcross, block / blocksAcross) * WIND_TILE;
  ivec2 first = corner + ivec2(gl_LocalInvocationID.xy);
  ivec2 last = ivec2(wind.width, wind.height) - 1;
  for (int n = 0; n < kCells; ++n) {
    ivec2 cell = min(first + ivec2(0, n * kRows), last);
    places[n] = cellCentreToWorld(vec2(cell), wind.minCorner, vec2(wind.hx, wind.hz));
    speeds[n] = cellVelocity(cell.x, cell.y);
    sums[n] = Sums(0.0, vec2(0.0), vec2(0.0), 0.0, vec2(0.0));
  }
  uint end = tileStart[tile + 1];
  for (uint begin = tileStart[tile]; begin < end; begin += uint(kGroup)) {
    int count = int(min(end - begin, uint(kGroup)));
    int mine = int(gl_LocalInvocationIndex);
    if (mine < count) ready[mine] = madeReady(arrows[tileArrows[begin + uint(mine)]]);
    barrier();
    for (int n = 0; n < count; ++n) {
      Ready r = ready[n];
      if (r.kind == kSpeed) addSpeed(r);
      if (r.kind == kForce) addForce(r);
      if (r.swirlPeak > 0.0) addSwirl(r);
    }
    barrier();
  }
  for (int n = 0; n < kCells; ++n) {
    ivec2 cell = first + ivec2(0, n * kRows);
    if (cell.x > last.x || cell.y > last.y) continue;
    vec2 driven = (sums[n].target - sums[n].rate * speeds[n]) * approach(sums[n].rate);
    increments[cellAt(cell.x, cell.y)] = driven + sums[n].swirl * approach(sums[n].swirlRate) + wind.dt * sums[n].force;
  }
}
