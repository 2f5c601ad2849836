#version 450 core
// Colour by strength, as in the legend of speed. The root's signal runs along it: bright where it has come to blow,
// dim before and after, and chevrons run with it.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

in vec3 arrowNormal;
in vec2 arrowPlace;
in float arrowLevel;
flat in vec4 arrowLook;
flat in vec4 arrowSizes;
layout(std430, binding = RENDER_SSBO_LEVELS) readonly buffer Levels { float levels[]; };
uniform float visible;  // alpha of this pass
uniform float seam;
uniform float onMap;    // 1 where a map lies under the arrows

layout(location = 0) out vec4 colour;

float signalLevel() {
  float at = clamp(arrowLevel, arrowSizes.z, arrowSizes.w);
  int low = int(at);
  return clamp(mix(levels[low], levels[low + 1], at - float(low)), 0.0, 1.0);
}

// Bands that point and run along the arrow at its travel speed.
float chevrons() {
  float period = 5.0 * arrowSizes.x;
  float s = arrowPlace.x + 0.9 * abs(arrowPlace.y) * arrowSizes.x;
  float width = fwidth(s) / period;
  float wave = fract((s - arrowSizes.y * frame.viewForward.w) / period);
  float band = smoothstep(0.0, 0.12 + width, wave) * (1.0 - smoothstep(0.42, 0.54 + width, wave));
  return mix(band, 0.45, smoothstep(0.2, 0.6, width));
}

void main() {
  float state = arrowLook.w;
  float muted = arrowLook.z;
  float part = abs(arrowLook.y) / frame.pixelScale.z;
  vec3 own = mix(speedColourAt(part), vec3(0.45), 0.85 * muted);
  float alpha = visible * mix(1.0, 0.55, muted);
  if (seam > 0.0) {
    // Dark colours get a light seam, so that they don't drown on dark ground, and so do all on a map of like colours.
    float dark = smoothstep(0.20, 0.32, dot(own, vec3(0.3, 0.6, 0.1))) * (1.0 - onMap);
    vec3 plain = mix(vec3(0.95), vec3(0.04, 0.05, 0.06), dark);
    vec3 shown = state == MARK_SELECTED ? vec3(1.0) : state == MARK_HOVERED ? kHoverColour : plain;
    alpha *= state == MARK_NORMAL ? 0.8 : 1.0;
    colour = vec4(shown * alpha, alpha);
    return;
  }
  vec3 base = markColour(own, state);
  float level = signalLevel() * (1.0 - muted);
  float light = 0.74 + 0.32 * max(dot(normalize(arrowNormal), normalize(vec3(-0.35, 0.8, -0.5))), 0.0);
  // Where the signal is out the colour pales to a shadow of itself but keeps its hue.
  vec3 calm = mix(base, vec3(dot(base, vec3(0.3, 0.6, 0.1))), 0.35) * mix(0.62, 0.88, onMap);
  vec3 shown = mix(calm, base, level) * light;
  shown = mix(shown, vec3(1.0), chevrons() * (0.10 + 0.38 * level) * (1.0 - muted));
  colour = vec4(min(shown, vec3(1.0)) * alpha, alpha);
}
