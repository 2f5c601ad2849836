#version 450 core
// The streaks of lic.frag in the colours of speed.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/overlay.glsl"

in vec2 mapWorld;
layout(binding = RENDER_TEXTURE_STREAKS) uniform sampler2D streakTexture;
layout(location = 0) out vec4 colour;

void main() {
  float part = length(smoothWind(mapWorld)) / frame.pixelScale.z;
  float streak = textureLod(streakTexture, gl_FragCoord.xy * frame.viewport.zw, 0.0).r - 0.5;
  // Where the air rests there is nothing to see; near the horizon streaks are too thin.
  float moves = smoothstep(0.004, 0.05, part);
  float slant = abs(directionToCamera(overGround(mapWorld, 0.0)).y);
  streak *= moves * smoothstep(0.02, 0.12, slant);
  vec3 own = speedColourAt(part);
  vec3 shown = streak < 0.0 ? own * (1.0 + 1.5 * streak) : mix(own, vec3(1.0), 1.15 * streak);
  float alpha = 0.82 * moves * smoothstep(-0.05, 0.1, solidsNear(mapWorld).distanceM);
  colour = vec4(max(shown, vec3(0.0)) * alpha, alpha);
}
