#version 450 core
// The influence exp(-2 d^2 / r^2) as a tint, and the rim where it is cut.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

in vec2 areaPlace;
flat in vec4 areaLook;
flat in vec4 areaSizes;
layout(location = 0) out vec4 colour;

void main() {
  vec2 nearest = vec2(clamp(areaPlace.x, areaSizes.x, areaSizes.y), 0.0);
  float d = length(areaPlace - nearest) / areaLook.x;
  float pixel = fwidth(d);
  float marked = areaLook.w == MARK_NORMAL ? 0.0 : areaLook.w == MARK_HOVERED ? 0.6 : 1.0;
  float fill = d < 1.0 ? exp(-2.0 * d * d) * mix(0.07, 0.2, marked) : 0.0;
  float rim = (1.0 - smoothstep(0.0, 1.6 * pixel, abs(d - 1.0 + pixel))) * mix(0.16, 0.75, marked);
  float alpha = max(fill, rim) * mix(1.0, 0.4, areaSizes.z);
  vec3 own = markColour(speedColourAt(0.45 + 0.55 * areaLook.y), areaLook.w);
  colour = vec4(own * alpha, alpha);
}
