#version 450 core
// A jet at the centre of the field.
#include "plain.glsl"
layout(rg32f, binding = 0) writeonly uniform image2D result;

void main() {
  ivec2 size = imageSize(result);
  if (isOutside(cell(), size)) return;
  vec2 away = (vec2(cell()) - 0.5 * vec2(size)) / (0.05 * float(size.x));
  vec2 v = fetch(velocity, cell()).rg + dt * vec2(20.0, 5.0) * exp(-2.0 * dot(away, away));
  imageStore(result, cell(), vec4(v, 0.0, 0.0));
}
