#version 450 core
// Colour by speed in a dark seam, so that the line reads on light and dark grass; brightest at the head.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

in vec2 linePlace;
in vec2 lineLook;
layout(location = 0) out vec4 colour;

void main() {
  float across = abs(linePlace.y);
  float core = 1.0 - smoothstep(0.35, 0.75, across);
  float head = linePlace.x * linePlace.x;
  vec3 own = mix(speedColourAt(lineLook.x), vec3(1.0), 0.28 + 0.16 * (1.0 - min(lineLook.x, 1.0)) + 0.4 * head * head * head);
  float fade = lineLook.y * smoothstep(0.0, 0.5, linePlace.x) * (1.0 - smoothstep(0.97, 1.0, linePlace.x));
  float alpha = fade * (1.0 - smoothstep(0.8, 1.0, across)) * mix(0.4, 1.0, core);
  colour = vec4(mix(vec3(0.03, 0.05, 0.06), own, core) * alpha, alpha);
}
