// The solver's constants and the layout of its velocity buffers: u, then w, each with one ghost on every side.
#include "shaders/shared/wind_block.h"

layout(std140, binding = WIND_UBO_BLOCK) uniform Wind { WindBlock wind; };
layout(std430, binding = WIND_SSBO_FLAGS) readonly buffer CellFlags { uint cellFlags[]; };  // two cells in each

int uAt(int i, int k) { return (k + 1) * wind.stride + i + 1; }
int wAt(int i, int k) { return wind.zFaces + (k + 1) * wind.stride + i + 1; }
int cellAt(int i, int k) { return k * wind.width + i; }

bool periodicX() { return wind.xMin == WIND_BORDER_PERIODIC; }
bool periodicZ() { return wind.zMin == WIND_BORDER_PERIODIC; }

uint flagsOf(int i, int k) {
  int cell = cellAt(i, k);
  return (cellFlags[cell >> 1] >> (16 * (cell & 1))) & 0xffffu;
}

// Whether x-face (i, k) lets air through; i in [0, W].
bool openX(int i, int k) {
  return i < wind.width ? (flagsOf(i, k) & (WIND_LINK_X_LOW | WIND_GROUND_X_LOW)) != 0u
                        : (flagsOf(i - 1, k) & (WIND_LINK_X_HIGH | WIND_GROUND_X_HIGH)) != 0u;
}
bool openZ(int i, int k) {
  return k < wind.height ? (flagsOf(i, k) & (WIND_LINK_Z_LOW | WIND_GROUND_Z_LOW)) != 0u
                         : (flagsOf(i, k - 1) & (WIND_LINK_Z_HIGH | WIND_GROUND_Z_HIGH)) != 0u;
}

bool isFinite(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }
float finiteOr(float x, float otherwise) { return isFinite(x) ? x : otherwise; }
