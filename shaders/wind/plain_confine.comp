#version 450 core
// Vorticity confinement (CWD-Sim eq. 5).
#include "plain.glsl"
layout(binding = 1) uniform sampler2D curl;
layout(rg32f, binding = 0) writeonly uniform image2D result;

void main() {
  if (isOutside(cell(), imageSize(result))) return;
  ivec2 c = cell();
  float right = abs(fetch(curl, c + ivec2(1, 0)).r), left = abs(fetch(curl, c - ivec2(1, 0)).r);
  float high = abs(fetch(curl, c + ivec2(0, 1)).r), low = abs(fetch(curl, c - ivec2(0, 1)).r);
  vec2 eta = 0.5 * vec2(right - left, high - low);
  vec2 n = eta / (length(eta) + 1e-4);
  float own = fetch(curl, c).r;
  vec2 v = fetch(velocity, c).rg + dt * 0.2 * vec2(n.y, -n.x) * own;
  imageStore(result, c, vec4(clamp(v, -100.0, 100.0), 0.0, 0.0));
}
