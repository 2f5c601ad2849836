#version 450 core
// Speed as colour, laid over the grass so that both show.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/overlay.glsl"

in vec2 mapWorld;
layout(location = 0) out vec4 colour;

void main() {
  float part = length(fieldWind(mapWorld)) / frame.pixelScale.z;
  // Thin lines at every fifth of the range help to read values.
  float level = part * 5.0;
  float line = 1.0 - smoothstep(0.0, 1.3, abs(fract(level + 0.5) - 0.5) / max(fwidth(level), 1e-4));
  line *= smoothstep(0.3, 0.6, level) * 0.35;
  float alpha = 0.62 * smoothstep(-0.05, 0.1, solidsNear(mapWorld).distanceM);
  vec3 shown = mix(speedColourAt(part), vec3(1.0), line);
  colour = vec4(shown * alpha, alpha);
}
