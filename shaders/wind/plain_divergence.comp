#version 450 core
// Divergence by central differences (CWD-Sim eq. 6, corrected).
#include "plain.glsl"
layout(r32f, binding = 0) writeonly uniform image2D result;

void main() {
  if (isOutside(cell(), imageSize(result))) return;
  ivec2 c = cell();
  float x = fetch(velocity, c + ivec2(1, 0)).r - fetch(velocity, c - ivec2(1, 0)).r;
  float z = fetch(velocity, c + ivec2(0, 1)).g - fetch(velocity, c - ivec2(0, 1)).g;
  imageStore(result, c, vec4(0.5 * (x + z), 0.0, 0.0, 0.0));
}
