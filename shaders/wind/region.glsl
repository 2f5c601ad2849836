// A region of one level of the pressure solve in shared memory and registers, and Jacobi's sweeps on it. Invocation (x,
// s) holds the cells (x, s WIND_STRIP + n). Each sweep makes the outermost ring that is still right one cell narrower.
// LEVEL0: the grid itself, whose conductances follow from the cells' flags; otherwise they come from a buffer.
// DOWN: the region of a pass that restricts. docs/solver.md section 6.
#ifdef LEVEL0
#define REGION WIND_FINE_REGION
#else
#define REGION WIND_COARSE_REGION
#endif
#include "shaders/wind/block.glsl"
#include "shaders/wind/level_faces.glsl"

layout(local_size_x = REGION, local_size_y = REGION / WIND_STRIP) in;
layout(std140, binding = WIND_UBO_LEVEL) uniform LevelBlock { WindLevel level; };
#ifndef LEVEL0
layout(std430, binding = WIND_SSBO_FACES) readonly buffer Faces { uint faces[]; };
#endif

layout(std430, binding = WIND_SSBO_KINDS) readonly buffer Kinds { uint kinds[]; };

#define GROUP_SIZE (REGION * REGION / WIND_STRIP)
shared float scratch[REGION * REGION];

struct Cell {
  float d, b;
  float inverse;  // 1 / D, 0 where D is 0 and outside
#ifdef LEVEL0
  uint flags;
#else
  float xLow, xHigh, zLow, zHigh;  // conductances
#endif
};
Cell cells[WIND_STRIP];
int found[WIND_STRIP];  // the cells' places in the level's arrays; -1: outside the field

// Most regions lie inside the field and hold nothing but air: their cells differ in nothing but d and b. What follows
// takes as `plain` whether that is so, always as a constant: two versions of the code without a choice in them are much
// faster than one that chooses at every cell.
bool isPlainRegion() {
#ifdef DOWN
  int first = level.downKinds;
#else
  int first = level.upKinds;
#endif
  return kinds[first + int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x)] != 0u;
}

int localX() { return int(gl_LocalInvocationID.x); }
int localZ(int n) { return int(gl_LocalInvocationID.y) * WIND_STRIP + n; }
int scratchAt(int n) { return localZ(n) * REGION + localX(); }

// Where the inner cells begin in the region, and how many there are. On the way down two rings lie around the cells
// that the ring of the next level's cells is made of: one for the residual, one for the flux.
#ifdef DOWN
ivec2 levelFactor() { return ivec2(level.factorX, level.factorZ); }
ivec2 innerBegin() { return levelFactor() + 2; }
ivec2 innerCount() { return WIND_DOWN_INNER(REGION) * levelFactor(); }
#else
ivec2 innerBegin() { return ivec2(WIND_HALO); }
ivec2 innerCount() { return ivec2(WIND_INNER(REGION)); }
#endif

// The cell of this level, not wrapped.
ivec2 placeOf(int n) {
  return ivec2(gl_WorkGroupID.xy) * innerCount() - innerBegin() + ivec2(localX(), localZ(n));
}
int wrapAxis(int c, int count, bool periodic) {
  if (!periodic) return c;
  if (count >= REGION) return c < 0 ? c + count : c < count ? c : c - count;
  return (c + REGION * count) % count;  // a small field may lie in the region more than once
}
// The cell wrapped at periodic borders; negative where there is none.
ivec2 wrappedPlace(int n) {
  ivec2 place = placeOf(n);
  place.x = wrapAxis(place.x, level.width, level.xMin == WIND_BORDER_PERIODIC);
  place.y = wrapAxis(place.y, level.height, level.zMin == WIND_BORDER_PERIODIC);
  bool there = place.x >= 0 && place.y >= 0 && place.x < level.width && place.y < level.height;
  return there ? place : ivec2(-1);
}
// Whether the work-group answers for the cell.
bool isInner(const bool plain, int n) {
  ivec2 local = ivec2(localX(), localZ(n)) - innerBegin(), count = innerCount();
  bool inner = local.x >= 0 && local.y >= 0 && local.x < count.x && local.y < count.y;
  if (plain) return inner;
  ivec2 place = placeOf(n);
  return inner && place.x < level.width && place.y < level.height;
}
int levelCell(ivec2 place) { return place.y * level.width + place.x; }

#ifdef LEVEL0
float countOf(uint flags, uint low, uint high) {
  return ((flags & low) != 0u ? 1.0 : 0.0) + ((flags & high) != 0u ? 1.0 : 0.0);
}

void loadStencil(int n, ivec2 place) {
  uint flags = place.x >= 0 ? flagsOf(place.x, place.y) : 0u;
  float alongX = countOf(flags, WIND_LINK_X_LOW, WIND_LINK_X_HIGH) +
                 2.0 * countOf(flags, WIND_GROUND_X_LOW, WIND_GROUND_X_HIGH);
  float alongZ = countOf(flags, WIND_LINK_Z_LOW, WIND_LINK_Z_HIGH) +
                 2.0 * countOf(flags, WIND_GROUND_Z_LOW, WIND_GROUND_Z_HIGH);
  cells[n].flags = flags;
  cells[n].inverse = inverseOf(alongX * level.scaleX + alongZ * level.scaleZ);
}
float neighbours(const bool plain, int n, float xLow, float xHigh, float zLow, float zHigh) {
  if (plain) return (xLow + xHigh) * level.scaleX + (zLow + zHigh) * level.scaleZ;
  uint flags = cells[n].flags;
  float x = ((flags & WIND_LINK_X_LOW) != 0u ? xLow : 0.0) + ((flags & WIND_LINK_X_HIGH) != 0u ? xHigh : 0.0);
  float z = ((flags & WIND_LINK_Z_LOW) != 0u ? zLow : 0.0) + ((flags & WIND_LINK_Z_HIGH) != 0u ? zHigh : 0.0);
  return x * level.scaleX + z * level.scaleZ;
}
#else
void loadStencil(int n, ivec2 place) {
  bool there = place.x >= 0;
  int node = there ? place.y * (level.width + 1) + place.x : 0;
  vec2 low = facesOf(faces[node]), scale = there ? vec2(level.scaleX, level.scaleZ) : vec2(0.0);
  cells[n].xLow = low.x * scale.x;
  cells[n].zLow = low.y * scale.y;
  cells[n].xHigh = facesOf(faces[node + 1]).x * scale.x;
  cells[n].zHigh = facesOf(faces[node + level.width + 1]).y * scale.y;
  cells[n].inverse = inverseOf((cells[n].xLow + cells[n].xHigh) + (cells[n].zLow + cells[n].zHigh));
}
float neighbours(const bool plain, int n, float xLow, float xHigh, float zLow, float zHigh) {
  if (plain) return (xLow + xHigh) * level.scaleX + (zLow + zHigh) * level.scaleZ;
  return (cells[n].xLow * xLow + cells[n].xHigh * xHigh) + (cells[n].zLow * zLow + cells[n].zHigh * zHigh);
}
#endif

float plainInverse() { return inverseOf(2.0 * (level.scaleX + level.scaleZ)); }

// Finds the strip's cells and what belongs to them but d and b.
void locate(const bool plain) {
  int first = levelCell(placeOf(0));
  for (int n = 0; n < WIND_STRIP; ++n) {
    if (plain) {
      found[n] = first + n * level.width;
      cells[n].inverse = plainInverse();
    } else {
      ivec2 place = wrappedPlace(n);
      found[n] = place.x >= 0 ? levelCell(place) : -1;
      loadStencil(n, place);
    }
  }
}
bool isThere(const bool plain, int n) { return plain || found[n] >= 0; }

// Lets the others of the work-group see the cells' d.
void publish() {
  for (int n = 0; n < WIND_STRIP; ++n) scratch[scratchAt(n)] = cells[n].d;
  barrier();
}

// The neighbours' d of each cell of the strip: x low, x high, z low, z high, from what was published.
void lookAround(out vec4 around[WIND_STRIP]) {
  int at = scratchAt(0);
  int toLow = localX() > 0 ? -1 : 0, toHigh = localX() < REGION - 1 ? 1 : 0;
  float before = localZ(0) > 0 ? scratch[at - REGION] : 0.0;
  float after = localZ(WIND_STRIP) < REGION ? scratch[at + WIND_STRIP * REGION] : 0.0;
  for (int n = 0; n < WIND_STRIP; ++n) {
    int mine = at + n * REGION;
    float zLow = n > 0 ? cells[max(n - 1, 0)].d : before;
    float zHigh = n < WIND_STRIP - 1 ? cells[min(n + 1, WIND_STRIP - 1)].d : after;
    around[n] = vec4(scratch[mine + toLow], scratch[mine + toHigh], zLow, zHigh);
  }
}

// Sum of conductance times neighbour of each cell of the strip.
void gather(const bool plain, out float sums[WIND_STRIP]) {
  vec4 around[WIND_STRIP];
  lookAround(around);
  for (int n = 0; n < WIND_STRIP; ++n) {
    sums[n] = neighbours(plain, n, around[n].x, around[n].y, around[n].z, around[n].w);
  }
}

#ifdef LEVEL0
// How far d rises from one cell to the next, or to the ground half a cell away.
float riseTo(int n, float next, uint link, uint ground) {
  float own = cells[n].d;
  return (cells[n].flags & link) != 0u ? next - own : (cells[n].flags & ground) != 0u ? -2.0 * own : 0.0;
}

// A d of each cell of the strip, from differences.
void gatherRises(const bool plain, out float sums[WIND_STRIP]) {
  vec4 around[WIND_STRIP];
  lookAround(around);
  for (int n = 0; n < WIND_STRIP; ++n) {
    float x, z;
    if (plain) {
      x = (around[n].x - cells[n].d) + (around[n].y - cells[n].d);
      z = (around[n].z - cells[n].d) + (around[n].w - cells[n].d);
    } else {
      x = riseTo(n, around[n].x, WIND_LINK_X_LOW, WIND_GROUND_X_LOW) +
          riseTo(n, around[n].y, WIND_LINK_X_HIGH, WIND_GROUND_X_HIGH);
      z = riseTo(n, around[n].z, WIND_LINK_Z_LOW, WIND_GROUND_Z_LOW) +
          riseTo(n, around[n].w, WIND_LINK_Z_HIGH, WIND_GROUND_Z_HIGH);
    }
    sums[n] = x * level.scaleX + z * level.scaleZ;
  }
}
#endif

// d += weight (D^-1 (sum - b) - d), all cells at once.
void sweep(const bool plain, float weight) {
  float sums[WIND_STRIP];
  gather(plain, sums);
  barrier();
  for (int n = 0; n < WIND_STRIP; ++n) {
    cells[n].d += weight * ((sums[n] - cells[n].b) * cells[n].inverse - cells[n].d);
  }
  publish();
}

// The first sweep from d = 0 needs no neighbours.
float afterFirstSweep(int n, float weight) { return -weight * cells[n].b * cells[n].inverse; }
