#version 450 core
// Semi-Lagrangian advection with dissipation (CWD-Sim eq. 9 and 10).
#include "plain.glsl"
layout(rg32f, binding = 0) writeonly uniform image2D result;

void main() {
  ivec2 size = imageSize(result);
  if (isOutside(cell(), size)) return;
  vec2 from = vec2(cell()) + 0.5 - dt * fetch(velocity, cell()).rg;
  vec2 v = textureLod(velocity, from / vec2(size), 0.0).rg / (1.0 + 0.1 * dt);
  imageStore(result, cell(), vec4(v, 0.0, 0.0));
}
