#version 450 core
// The sky above the horizon into a map: across the azimuth, up the square root of the elevation. Clouds
// and far ridges, which would be too dear for every frame. In picture colours, dithered against bands.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/shared/hash.h"

in vec2 screenUv;
layout(location = 0) out vec4 colour;

float cloudDensity(vec2 at) {
  float warp = noiseAtLevel(at, 7.3, 0.0).g - 0.5;
  vec2 p = at + vec2(0.9, 0.35) * warp * 2.0;
  float broad = noiseAtLevel(p, 5.2, 0.0).r;
  float fine = noiseAtLevel(p, 1.9, 0.0).r;
  float detail = noiseAtLevel(p, 0.7, 0.0).b;
  return broad * 0.6 + fine * 0.28 + detail * 0.12;
}

vec3 withClouds(vec3 sky, vec3 ray) {
  if (ray.y < 0.015) return sky;
  vec2 at = ray.xz / (ray.y + 0.12) * 1.15 + vec2(3.1, 0.4);
  float density = smoothstep(0.50, 0.72, cloudDensity(at));
  float towardsSun = cloudDensity(at + frame.sunDirection.xz * 0.16);
  float lit = exp(-2.4 * max(towardsSun - 0.38, 0.0));
  float sunward = dot(ray, frame.sunDirection.xyz);
  vec3 shadow = mix(vec3(0.42, 0.47, 0.56), sky, 0.25);
  vec3 bright = vec3(1.15, 1.0, 0.82) + kSunward * 0.9 * exp2((sunward - 1.0) * 7.0);
  vec3 cloud = mix(shadow, bright, lit);
  float fade = smoothstep(0.015, 0.16, ray.y);
  return mix(sky, cloud, density * 0.85 * fade);
}

float ridgeHeight(float azimuth, float layer) {
  float turn = azimuth / 6.2831853;
  float broad = textureLod(noiseTexture, vec2(turn * 2.0, 0.13 + 0.31 * layer), 0.0).r;
  float fine = textureLod(noiseTexture, vec2(turn * 9.0, 0.71 + 0.17 * layer), 0.0).r;
  return (broad - 0.28) * 0.10 + (fine - 0.5) * 0.022;
}

vec3 withRidges(vec3 sky, vec3 ray, float azimuth) {
  vec3 haze = hazeColour(ray);
  for (int layer = 0; layer < 3; ++layer) {
    float nearness = float(layer) / 2.0;
    float top = ridgeHeight(azimuth, float(layer)) * (1.0 - 0.45 * nearness) + 0.004;
    float edge = smoothstep(top + 0.0012, top - 0.0012, ray.y);
    vec3 land = mix(vec3(0.10, 0.17, 0.20), vec3(0.07, 0.12, 0.075), nearness);
    vec3 seen = mix(land, haze, mix(0.86, 0.62, nearness));
    // Mist gathers at the foot.
    seen = mix(haze, seen, 0.35 + 0.65 * smoothstep(0.0, 0.03, ray.y));
    sky = mix(sky, seen, edge);
  }
  return sky;
}

void main() {
  float azimuth = (screenUv.x - 0.5) * 6.2831853;
  float elevation = screenUv.y * screenUv.y * 1.5707963;
  vec3 ray = vec3(cos(azimuth) * cos(elevation), sin(elevation), sin(azimuth) * cos(elevation));
  vec3 sky = withClouds(clearSky(ray), ray);
  uvec2 at = uvec2(gl_FragCoord.xy);
  float dither = hashToUnit(hashCombine(at.x, at.y)) - 0.5;
  colour = vec4(toPicture(withRidges(sky, ray, azimuth)) + dither / 255.0, 1.0);
}
