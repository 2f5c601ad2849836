#version 450 core
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

in vec2 pointPlace;
flat in vec2 pointKind;
flat in float pointMast;
uniform float visible;
layout(location = 0) out vec4 colour;

void main() {
  vec3 own = pointKind.x == MARK_PROBE ? vec3(0.93, 0.45, 0.62) : vec3(0.96, 0.97, 0.98);
  own = markColour(own, pointKind.y);
  if (pointMast > 0.5) {
    colour = vec4(own * visible, visible);
    return;
  }
  float r = length(pointPlace);
  float pixel = fwidth(r);
  float disc = 1.0 - smoothstep(1.0 - 1.5 * pixel, 1.0, r);
  // A dark rim keeps the disc readable on light grass; roots and probes are rings around a core.
  float rim = smoothstep(0.80 - pixel, 0.80, r);
  float ring = pointKind.x == MARK_POINT ? 1.0 : max(smoothstep(0.52 - pixel, 0.52, r), 1.0 - smoothstep(0.30 - pixel, 0.30, r));
  vec3 shown = mix(mix(vec3(0.10, 0.12, 0.14), own, ring), vec3(0.06, 0.07, 0.09), rim);
  colour = vec4(shown * disc * visible, disc * visible);
}
