#version 450 core
// Curl by central differences (CWD-Sim eq. 4, corrected).
#include "plain.glsl"
layout(r32f, binding = 0) writeonly uniform image2D result;

void main() {
  if (isOutside(cell(), imageSize(result))) return;
  ivec2 c = cell();
  float along = fetch(velocity, c + ivec2(1, 0)).g - fetch(velocity, c - ivec2(1, 0)).g;
  float across = fetch(velocity, c + ivec2(0, 1)).r - fetch(velocity, c - ivec2(0, 1)).r;
  imageStore(result, c, vec4(0.5 * (along - across), 0.0, 0.0, 0.0));
}
