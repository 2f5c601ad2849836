#version 450 core
// Weathered stone: grain, lichen, damp at the foot where the grass stands against it.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/scene_output.glsl"

in vec3 stoneWorld;
in vec3 stoneNormal;
flat in float stoneHeight;

// Noise over the surface by its dominant direction.
vec4 surfaceNoise(vec3 at, vec3 n, float size) {
  vec3 a = abs(n);
  vec2 uv = a.y > max(a.x, a.z) ? at.xz : a.x > a.z ? at.zy : at.xy;
  return noiseAt(uv, size);
}

void main() {
  vec3 n = normalize(stoneNormal);
  vec4 broad = surfaceNoise(stoneWorld, n, 3.7);
  vec4 fine = surfaceNoise(stoneWorld.zyx + 1.3, n.zyx, 0.9);
  n = normalize(n + (vec3(broad.r, fine.r, broad.g) - 0.5) * 0.4 + (vec3(fine.b, fine.g, broad.b) - 0.5) * 0.25);
  vec3 albedo = mix(vec3(0.17, 0.16, 0.145), vec3(0.36, 0.335, 0.295), smoothstep(0.25, 0.75, 0.6 * broad.r + 0.4 * fine.b));
  float lichen = smoothstep(0.56, 0.66, broad.g * 0.7 + fine.r * 0.3) * (0.35 + 0.65 * max(n.y, 0.0));
  albedo = mix(albedo, vec3(0.24, 0.25, 0.13), lichen * 0.7);
  float foot = smoothstep(0.0, 0.7, stoneWorld.y - groundHeight(stoneWorld.xz));
  albedo = mix(albedo * vec3(0.45, 0.48, 0.36), albedo, 0.35 + 0.65 * foot);
  // The sun is hidden where another solid's shadow reaches higher than this point; its own outline is not.
  vec2 lit = stoneWorld.xz + normalize(frame.sunDirection.xz) * 0.25 + n.xz * 0.3;
  SolidsNear near = solidsNear(lit);
  float above = stoneWorld.y - groundHeight(lit);
  float shadow = near.distanceM > 0.1 ? smoothstep(-0.2, 0.2, above - near.shadowHeight) : 1.0;
  shadow *= smoothstep(-0.8, 0.8, above - groundLight(lit, 0.0).shadowHeight);
  vec3 light = frame.sunColour.rgb * max(dot(n, frame.sunDirection.xyz), 0.0) * shadow;
  light += frame.skyColour.rgb * (0.55 + 0.45 * n.y) * mix(0.45, 1.0, foot);
  light += frame.sunColour.rgb * vec3(0.035, 0.045, 0.015) * (0.5 - 0.5 * n.y);
  writeScene(throughAir(albedo * light, stoneWorld));
}
