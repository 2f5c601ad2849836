// The wind as grass and ground feel it: the simulated field, and the air of rotors, which is no part of it.
#include "shaders/include/ground.glsl"
#include "shaders/shared/blade_deformation.h"
#include "shaders/shared/grid_mapping.h"
#include "shaders/shared/rotor_wind.h"

layout(std140, binding = RENDER_UBO_ROTORS) uniform RotorUniforms { RotorBlock rotorBlock; };
layout(binding = RENDER_TEXTURE_WIND) uniform sampler2D windTexture;

// Cells larger than this are interpolated, so that the grid doesn't show in the grass.
const float kCoarseCellM = 0.3;

// Outside the field the wind turns into the ambient one over this distance.
const float kOutsideM = 15.0;

// 0 in the field .. 1 where only the ambient wind blows.
float outsideField(vec2 world) {
  vec2 high = frame.field.xy + frame.field.zw;
  vec2 beyond = max(max(frame.field.xy - world, world - high), vec2(0.0));
  return smoothstep(0.0, kOutsideM, length(beyond));
}

vec2 blendOutside(vec2 wind, vec2 world) { return mix(wind, frame.ambientWind.xy, outsideField(world)); }

// The simulated wind alone, as overlays show it.
vec2 fieldWind(vec2 world) {
  if (frame.pixelScale.w < 0.5) return vec2(0.0);
  return blendOutside(textureLod(windTexture, worldToUv(world, frame.field.xy, frame.field.zw), 0.0).xy, world);
}

// The rotors' air `above` m over the ground, `later` s after the frame's time, m/s.
vec3 rotorAirOver(vec2 world, float above, float later) {
  vec3 air = vec3(0.0);
  int count = int(rotorBlock.count.x);
  for (int i = 0; i < count; ++i) air += rotorWind(rotorBlock.rotors[i], world, above, later);
  return air;
}

// The same at a place in the world.
vec3 rotorAir(vec3 place) {
  if (rotorBlock.count.x < 0.5) return vec3(0.0);
  return rotorAirOver(place.xz, max(place.y - groundHeight(place.xz), 0.0), 0.0);
}

vec2 smoothWind(vec2 world) { return fieldWind(world) + rotorAirOver(world, 0.0, 0.0).xz; }

// The simulated wind of the blade group that a root belongs to (Choi & Sung 2024, eq. 1): one value for all of it.
vec2 groupFieldWind(vec2 world) {
  if (frame.pixelScale.w < 0.5) return vec2(0.0);
  if (frame.fieldCells.z > kCoarseCellM) return fieldWind(world);
  vec2 uv = worldToUv(world, frame.field.xy, frame.field.zw);
  ivec2 group = clamp(ivec2(floor(uv * frame.fieldCells.xy)), ivec2(0), ivec2(frame.fieldCells.xy) - 1);
  return blendOutside(texelFetch(windTexture, group, 0).xy, world);
}

vec2 groupWind(vec2 world) { return groupFieldWind(world) + rotorAirOver(world, 0.0, 0.0).xz; }

// Ripples that run with the wind: noise carried along it for a short while, two copies in turn so that no
// restart shows. About -1 .. 1, mean 0.
float windRipple(vec2 world, vec2 wind) {
  const float kPeriod = 2.4;   // s
  const float kSizeM = 38.0;   // of the noise tile
  float t = frame.viewForward.w / kPeriod;
  float sum = 0.0;
  for (int i = 0; i < 2; ++i) {
    float turn = t + 0.5 * float(i);
    float age = fract(turn);
    vec2 jump = vec2(0.37, 0.71) * floor(turn) + vec2(0.5, 0.2) * float(i);
    vec2 at = (world - wind * (0.8 * kPeriod * (age - 0.5))) / kSizeM + jump;
    sum += (textureLod(noiseTexture, at, 0.0).r - 0.5) * (1.0 - abs(2.0 * age - 1.0));
  }
  return sum * 4.0;
}

// The wind with its ripples, as strong as the grass flutters.
vec2 rippledWind(vec2 world, vec2 wind, float flutter) {
  return wind * (1.0 + flutter * clamp(windRipple(world, wind), -1.0, 1.0));
}
