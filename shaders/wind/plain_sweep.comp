#version 450 core
// One Jacobi sweep of the pressure (CWD-Sim eq. 7, corrected).
#include "plain.glsl"
layout(binding = 1) uniform sampler2D divergence;
layout(r32f, binding = 0) writeonly uniform image2D result;
#define pressure velocity

void main() {
  if (isOutside(cell(), imageSize(result))) return;
  ivec2 c = cell();
  float beside = fetch(pressure, c - ivec2(1, 0)).r + fetch(pressure, c + ivec2(1, 0)).r;
  float sum = beside + fetch(pressure, c - ivec2(0, 1)).r + fetch(pressure, c + ivec2(0, 1)).r;
  imageStore(result, c, vec4(0.25 * (sum - fetch(divergence, c).r), 0.0, 0.0, 0.0));
}
