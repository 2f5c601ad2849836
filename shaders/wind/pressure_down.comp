#version 450 core
// The way down of the pressure solve on one level, or on a level and the next: a sweep from d = 0, which needs no
// neighbours and is made again on the way up, then the residual for the next level. docs/solver.md section 6.
// FIRST: on level 0 in the first cycle.  AGAIN: there in later cycles.  Neither: on a coarser level.
#if defined(FIRST) || defined(AGAIN)
#define LEVEL0
#endif
#define DOWN
#include "shaders/wind/region.glsl"

layout(std430, binding = WIND_SSBO_COARSE) writeonly buffer Coarse { float coarse[]; };
layout(std430, binding = WIND_SSBO_COARSE_FACES) readonly buffer CoarseFaces { uint coarseFaces[]; };
layout(std430, binding = WIND_SSBO_COARSER) writeonly buffer Coarser { float coarser[]; };

#if defined(FIRST)
layout(std430, binding = WIND_SSBO_CONTROL) readonly buffer Control { WindControl control; };
#include "shaders/wind/flux.glsl"
#elif defined(AGAIN)
layout(std430, binding = WIND_SSBO_CONTROL) readonly buffer Control { WindControl control; };
#include "shaders/wind/join.glsl"
#else
layout(std430, binding = WIND_SSBO_FLUX) readonly buffer Flux { float flux[]; };

void load(const bool plain) {
  locate(plain);
  for (int n = 0; n < WIND_STRIP; ++n) cells[n].b = isThere(plain, n) ? flux[found[n]] : 0.0;
}
#endif

// The cells of the next level that the region covers: the inner ones, and a ring where the pass goes on to the level
// after that.
const int kRing = WIND_DOWN_INNER(REGION) + 2;
const int kRounds = (kRing * kRing + GROUP_SIZE - 1) / GROUP_SIZE;

// Leaves in `scratch` the residuals after the first sweep; those that aren't whole on their level are 0.
void findResiduals(const bool plain) {
  for (int n = 0; n < WIND_STRIP; ++n) cells[n].d = afterFirstSweep(n, WIND_SMOOTH_DOWN);
  publish();
  float sums[WIND_STRIP];
  gather(plain, sums);
  barrier();
  for (int n = 0; n < WIND_STRIP; ++n) {
    // b - A d with D d = -weight b.
    bool counts = plain || (cells[n].inverse > 0.0 && (level.pair != 0 || isInner(plain, n)));
    scratch[scratchAt(n)] = counts ? (1.0 - WIND_SMOOTH_DOWN) * cells[n].b - sums[n] : 0.0;
  }
  barrier();
}

// The cell of the next level, as counted in the ring; not wrapped.
ivec2 coarsePlace(ivec2 ring) { return ivec2(gl_WorkGroupID.xy) * WIND_DOWN_INNER(REGION) + ring - 1; }
bool inRing(ivec2 ring, int margin) {
  return ring.x >= margin && ring.y >= margin && ring.x < kRing - margin && ring.y < kRing - margin;
}
ivec2 ringOf(int round) {
  int m = int(gl_LocalInvocationIndex) + round * GROUP_SIZE;
  return ivec2(m % kRing, m / kRing);
}

float sumOfCell(ivec2 ring) {
  int corner = (2 + ring.y * level.factorZ) * REGION + 2 + ring.x * level.factorX;
  float sum = scratch[corner];
  if (level.factorX > 1) sum += scratch[corner + 1];
  if (level.factorZ > 1) {
    sum += scratch[corner + REGION];
    if (level.factorX > 1) sum += scratch[corner + REGION + 1];
  }
  return sum;
}

void restrictOnce() {
  for (int round = 0; round < kRounds; ++round) {
    ivec2 ring = ringOf(round), place = coarsePlace(ring);
    if (!inRing(ring, 1) || place.x >= level.coarseWidth || place.y >= level.coarseHeight) continue;
    coarse[place.y * level.coarseWidth + place.x] = sumOfCell(ring);
  }
}

// The same on the next level, in the place of this one's residuals.
void restrictTwice() {
  ivec2 size = ivec2(level.coarseWidth, level.coarseHeight);
  float b[kRounds], inverse[kRounds];
  vec4 links[kRounds];
  for (int round = 0; round < kRounds; ++round) {
    ivec2 ring = ringOf(round), place = coarsePlace(ring);
    place.x = wrapAxis(place.x, size.x, level.xMin == WIND_BORDER_PERIODIC);
    place.y = wrapAxis(place.y, size.y, level.zMin == WIND_BORDER_PERIODIC);
    bool there = inRing(ring, 0) && place.x >= 0 && place.y >= 0 && place.x < size.x && place.y < size.y;
    b[round] = there ? sumOfCell(ring) : 0.0;
    int node = place.y * (size.x + 1) + place.x;
    vec2 low = there ? facesOf(coarseFaces[node]) : vec2(0.0);
    float xHigh = there ? facesOf(coarseFaces[node + 1]).x : 0.0;
    float zHigh = there ? facesOf(coarseFaces[node + size.x + 1]).y : 0.0;
    links[round] = vec4(low.x, xHigh, low.y, zHigh);
    links[round] *= vec4(level.coarseScaleX, level.coarseScaleX, level.coarseScaleZ, level.coarseScaleZ);
    inverse[round] = inverseOf((links[round].x + links[round].y) + (links[round].z + links[round].w));
    place = coarsePlace(ring);
    if (inRing(ring, 1) && place.x < size.x && place.y < size.y) coarse[place.y * size.x + place.x] = b[round];
  }
  barrier();
  for (int round = 0; round < kRounds; ++round) {
    ivec2 ring = ringOf(round);
    if (inRing(ring, 0)) scratch[ring.y * REGION + ring.x] = -WIND_SMOOTH_DOWN * b[round] * inverse[round];
  }
  barrier();
  float left[kRounds];
  for (int round = 0; round < kRounds; ++round) {
    ivec2 ring = ringOf(round), place = coarsePlace(ring);
    int at = ring.y * REGION + ring.x;
    bool counts = inRing(ring, 1) && place.x < size.x && place.y < size.y && inverse[round] > 0.0;
    left[round] = 0.0;
    if (!counts) continue;
    vec4 around = vec4(scratch[at - 1], scratch[at + 1], scratch[at - REGION], scratch[at + REGION]);
    vec4 flows = links[round] * around;
    left[round] = (1.0 - WIND_SMOOTH_DOWN) * b[round] - ((flows.x + flows.y) + (flows.z + flows.w));
  }
  barrier();
  for (int round = 0; round < kRounds; ++round) {
    ivec2 ring = ringOf(round);
    if (inRing(ring, 0)) scratch[ring.y * REGION + ring.x] = left[round];
  }
  barrier();
  ivec2 factor = ivec2(level.coarseFactorX, level.coarseFactorZ);
  ivec2 count = ivec2(WIND_DOWN_INNER(REGION)) / factor, coarserSize = (size + factor - 1) / factor;
  for (int m = int(gl_LocalInvocationIndex); m < count.x * count.y; m += GROUP_SIZE) {
    ivec2 local = ivec2(m % count.x, m / count.x), place = ivec2(gl_WorkGroupID.xy) * count + local;
    if (place.x >= coarserSize.x || place.y >= coarserSize.y) continue;
    int corner = (1 + local.y * factor.y) * REGION + 1 + local.x * factor.x;
    float sum = scratch[corner];
    if (factor.x > 1) sum += scratch[corner + 1];
    if (factor.y > 1) {
      sum += scratch[corner + REGION];
      if (factor.x > 1) sum += scratch[corner + REGION + 1];
    }
    coarser[place.y * coarserSize.x + place.x] = sum;
  }
}

#ifdef FIRST
float sums[SUM_COUNT] = float[](0.0, 0.0, 0.0, 0.0);
#endif

void run(const bool plain) {
#if defined(FIRST)
  loadFlux(plain, sums);
#elif defined(AGAIN)
  loadJoined(plain);
#else
  load(plain);
#endif
  findResiduals(plain);
}

void main() {
  if (isPlainRegion()) {
    run(true);
  } else {
    run(false);
  }
  if (level.pair != 0) {
    restrictTwice();
  } else {
    restrictOnce();
  }
#ifdef FIRST
  deliver(sums);
#endif
}
