#version 450 core
// The influence exp(-2 d^2 / r^2) as a tint that swells with the signal, and the rim where it is cut.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

in vec2 areaPlace;
in float areaLevel;
flat in vec4 areaLook;
flat in vec4 areaSizes;
layout(std430, binding = RENDER_SSBO_LEVELS) readonly buffer Levels { float levels[]; };
layout(location = 0) out vec4 colour;

void main() {
  vec2 nearest = vec2(clamp(areaPlace.x, areaSizes.x, areaSizes.y), 0.0);
  float d = length(areaPlace - nearest) / areaLook.x;
  float pixel = fwidth(d);
  float state = areaLook.w;
  float muted = areaLook.z;
  float marked = state == MARK_NORMAL ? 0.0 : state == MARK_HOVERED ? 0.6 : 1.0;
  float at = clamp(areaLevel, areaSizes.z, areaSizes.w);
  float level = clamp(mix(levels[int(at)], levels[int(at) + 1], fract(at)), 0.0, 1.0) * (1.0 - muted);
  float fill = d < 1.0 ? exp(-2.0 * d * d) * mix(0.06 + 0.12 * level, 0.26, marked) : 0.0;
  float rim = (1.0 - smoothstep(0.0, 1.6 * pixel, abs(d - 1.0 + pixel))) * mix(0.16, 0.75, marked);
  float alpha = max(fill, rim) * mix(1.0, 0.4, muted);
  vec3 own = mix(speedColourAt(abs(areaLook.y) / frame.pixelScale.z), vec3(1.0), 0.25);
  colour = vec4(markColour(mix(own, vec3(0.5), muted), state) * alpha, alpha);
}
