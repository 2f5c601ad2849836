#version 450 core
// Takes the pressure gradient off the velocity (CWD-Sim eq. 8, with the half of a central difference).
#include "plain.glsl"
layout(binding = 1) uniform sampler2D pressure;
layout(rg32f, binding = 0) writeonly uniform image2D result;

void main() {
  if (isOutside(cell(), imageSize(result))) return;
  ivec2 c = cell();
  vec2 gradient = 0.5 * vec2(fetch(pressure, c + ivec2(1, 0)).r - fetch(pressure, c - ivec2(1, 0)).r,
                             fetch(pressure, c + ivec2(0, 1)).r - fetch(pressure, c - ivec2(0, 1)).r);
  imageStore(result, c, vec4(fetch(velocity, c).rg - gradient, 0.0, 0.0));
}
