// Writing a face together with the ghosts that are made of it. Before the include, define GHOST_TARGET as the name of
// the buffer's array. docs/solver.md section 1.
#include "shaders/wind/block.glsl"

// Which component of a ghost's border is stored: the one across it, or the one along it.
const int kAcross = 0;
const int kAlong = 1;

// A ghost made of the entry inside, or for a periodic border of the entry of the other side. With WIND_COPY_OPEN an
// open border copies too (viscosity); with WIND_GHOSTS_OF_VELOCITY what comes in across it is what the ghosts of the
// array `velocity` say.
float ghostOf(int border, int component, int at, float inside, float ambient, float wallSpeed) {
  if (border == WIND_BORDER_PERIODIC) return inside;
  if (border == WIND_BORDER_WALL) return component == kAlong && wind.noSlip != 0 ? 2.0 * wallSpeed - inside : inside;
#ifdef WIND_COPY_OPEN
  return inside;
#elif defined(WIND_GHOSTS_OF_VELOCITY)
  return component == kAcross ? velocity[at] : ambient;
#else
  return ambient;
#endif
}

// Which ghost beyond each end of an axis entry `n` feeds, of `count` entries repeating after `period`: -2 for none.
ivec2 ghostsFedBy(int n, int count, int period, bool periodic) {
  int low = periodic ? period - 1 : 0;
  int high = periodic ? count - period : count - 1;
  return ivec2(n == low ? -1 : -2, n == high ? count : -2);
}

void storeRows(int base, int column, int k, float value, ivec2 rows, int component, float ambient) {
  int at = base + column + 1;
  GHOST_TARGET[at + (k + 1) * wind.stride] = value;
  if (rows.x != -2) GHOST_TARGET[at] = ghostOf(wind.zMin, component, at, value, ambient, wind.wallZMin);
  int last = at + (rows.y + 1) * wind.stride;
  if (rows.y != -2) GHOST_TARGET[last] = ghostOf(wind.zMax, component, last, value, ambient, wind.wallZMax);
}

// Whether face (i, k) of either component feeds no ghost.
bool feedsNoGhost(int i, int k) { return i > 1 && k > 1 && i < wind.width - 1 && k < wind.height - 1; }

void storeU(int i, int k, float value) {
  if (feedsNoGhost(i, k)) {
    GHOST_TARGET[uAt(i, k)] = value;
    return;
  }
  ivec2 columns = ghostsFedBy(i, wind.width + 1, wind.width, periodicX());
  ivec2 rows = ghostsFedBy(k, wind.height, wind.height, periodicZ());
  float a = wind.ambient.x;
  storeRows(0, i, k, value, rows, kAlong, a);
  if (columns.x != -2) storeRows(0, -1, k, ghostOf(wind.xMin, kAcross, uAt(-1, k), value, a, 0.0), rows, kAlong, a);
  if (columns.y == -2) return;
  storeRows(0, columns.y, k, ghostOf(wind.xMax, kAcross, uAt(columns.y, k), value, a, 0.0), rows, kAlong, a);
}

void storeW(int i, int k, float value) {
  if (feedsNoGhost(i, k)) {
    GHOST_TARGET[wAt(i, k)] = value;
    return;
  }
  ivec2 columns = ghostsFedBy(i, wind.width, wind.width, periodicX());
  ivec2 rows = ghostsFedBy(k, wind.height + 1, wind.height, periodicZ());
  float a = wind.ambient.y;
  int base = wind.zFaces;
  storeRows(base, i, k, value, rows, kAcross, a);
  if (columns.x != -2) storeRows(base, -1, k, ghostOf(wind.xMin, kAlong, 0, value, a, wind.wallXMin), rows, kAcross, a);
  float beyond = ghostOf(wind.xMax, kAlong, 0, value, a, wind.wallXMax);
  if (columns.y != -2) storeRows(base, columns.y, k, beyond, rows, kAcross, a);
}
