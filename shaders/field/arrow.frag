#version 450 core
// Colour by strength, brightness by the signal; dashes run along the flow while it blows.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

in vec3 arrowNormal;
in vec2 arrowPlace;
flat in vec4 arrowLook;
flat in vec2 arrowSizes;
uniform float visible;  // alpha of this pass

layout(location = 0) out vec4 colour;

void main() {
  float factor = clamp(arrowLook.z, 0.0, 1.0);
  float muted = arrowSizes.y;
  vec3 own = speedColourAt(0.25 + 0.75 * arrowLook.y);
  own = mix(own, vec3(0.45), 0.8 * muted);
  vec3 base = markColour(own, arrowLook.w);
  float period = max(0.12 * arrowSizes.x, 2.0);
  float dash = fract(arrowPlace.x / period - 0.55 * frame.viewForward.w * (0.5 + arrowLook.y));
  float pulse = smoothstep(0.0, 0.35, dash) * (1.0 - smoothstep(0.55, 0.95, dash));
  float light = 0.72 + 0.35 * max(dot(normalize(arrowNormal), normalize(vec3(-0.35, 0.8, -0.5))), 0.0);
  float blow = mix(0.62, 1.0, factor) * (1.0 + 0.28 * pulse * factor * (1.0 - muted));
  float alpha = visible * mix(1.0, 0.5, muted);
  colour = vec4(min(base * light * blow, vec3(1.0)) * alpha, alpha);
}
