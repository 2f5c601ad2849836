#version 450 core
// What an open border that the ambient wind enters by lets in: the ghosts of the normal component of the velocity, from
// the mean over a stretch of the border. docs/solver.md section 1.
#include "shaders/wind/block.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = WIND_SSBO_VELOCITY) buffer Velocity { float velocity[]; };

// The border's normal face n, and the ghost behind it.
int faceAt(bool acrossX, bool high, int n) {
  return acrossX ? uAt(high ? wind.width : 0, n) : wAt(n, high ? wind.height : 0);
}
int ghostAt(bool acrossX, bool high, int n) {
  return acrossX ? uAt(high ? wind.width + 1 : -1, n) : wAt(n, high ? wind.height + 1 : -1);
}

void main() {
  int side = int(gl_GlobalInvocationID.y);
  bool acrossX = side < 2, high = (side & 1) != 0;
  int count = acrossX ? wind.height : wind.width;
  int n = int(gl_GlobalInvocationID.x) + (acrossX ? 0 : -1);  // those across z have ghosts beyond both ends
  int border = side == 0 ? wind.xMin : side == 1 ? wind.xMax : side == 2 ? wind.zMin : wind.zMax;
  float inward = high ? -1.0 : 1.0, wanted = inward * (acrossX ? wind.ambient.x : wind.ambient.y);
  if (border != WIND_BORDER_OPEN || wanted <= 0.0 || n >= (acrossX ? count : count + 1)) return;
  bool periodic = acrossX ? periodicZ() : periodicX();
  float sum = 0.0;
  int faces = 0;
  for (int m = n - WIND_INFLOW_REACH; m <= n + WIND_INFLOW_REACH; ++m) {
    int face = periodic ? (m + WIND_INFLOW_REACH * count + count) % count : m;
    if (face < 0 || face >= count) continue;
    bool lets = acrossX ? openX(high ? wind.width : 0, face) : openZ(face, high ? wind.height : 0);
    if (!lets) continue;
    sum += velocity[faceAt(acrossX, high, face)];
    ++faces;
  }
  float mean = faces > 0 ? inward * sum / float(faces) : wanted;
  float part = clamp(mean / wanted, 0.0, 1.0);
  velocity[ghostAt(acrossX, high, n)] = inward * (mean + part * part * (wanted - mean));
}
