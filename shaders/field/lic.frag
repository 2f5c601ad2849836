#version 450 core
// Line integral convolution: noise smeared along the wind, so that streaks lie along it; a ripple in the kernel
// moves them downstream. Coloured by speed.
// Cabral, Leedom, "Imaging Vector Fields Using Line Integral Convolution", 1993 (with its periodic motion filter).
// Deviations: steps grow with the speed, so that fast air has longer, faster streaks; the noise lies in the world
// at two scales around a pixel's footprint, so that it stands still while the camera moves.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/overlay.glsl"
#include "shaders/shared/hash.h"

in vec2 mapWorld;
uniform float grain;  // pixels of the picture that one pixel here covers
layout(location = 0) out vec4 colour;

const int kSteps = 15;            // each way
// Pixels here, at the top of the speed range; longer steps pass over cells of the noise, and streaks fall to dots.
const float kLongestStep = 0.85;
const float kRate = 0.85;          // ripples a second
const float kPi = 3.14159265;

float cellNoise(vec2 world, float size) {
  ivec2 cell = ivec2(floor(world / size));
  return hashToUnit(pcgHash(uint(cell.x) * 0x9e3779b1u ^ pcgHash(uint(cell.y))));
}

// About -0.5 to 0.5.
float streakAt() {
  vec3 place = overGround(mapWorld, 0.0);
  float slant = clamp(abs(directionToCamera(place).y), 0.04, 1.0);
  float footprint = grain / (pixelsPerMetre(place) * sqrt(slant));
  float level = log2(footprint);
  float fine = exp2(floor(level)), blend = fract(level);
  float phase = fract(kRate * frame.viewForward.w);
  float sum = 0.0, weights = 0.0, squares = 0.0;
  for (int way = -1; way <= 1; way += 2) {
    vec2 at = mapWorld;
    for (int i = way < 0 ? 0 : 1; i < kSteps; ++i) {
      if (i > 0) {
        vec2 wind = fieldWind(at);
        float speed = length(wind);
        if (speed < 1e-4) break;
        float part = min(speed / frame.pixelScale.z, 1.3);
        at += wind * (float(way) * footprint * kLongestStep * (0.4 + 0.6 * part) / speed);
      }
      float x = float(way * i) / float(kSteps);
      float weight = (0.5 + 0.5 * cos(kPi * x)) * (0.54 + 0.46 * cos(2.0 * kPi * (x + phase)));
      sum += weight * mix(cellNoise(at, fine), cellNoise(at, 2.0 * fine), blend);
      weights += weight;
      squares += weight * weight;
    }
  }
  // Blended noise varies less, and so does the mean of many values: brought back to one contrast.
  float spread = 0.289 * sqrt(squares) / weights * sqrt(blend * blend + (1.0 - blend) * (1.0 - blend));
  // Near the horizon streaks are too thin to be seen apart.
  return 0.2 * (sum / weights - 0.5) / spread * smoothstep(0.04, 0.12, slant);
}

void main() {
  float part = length(fieldWind(mapWorld)) / frame.pixelScale.z;
  // Where the air rests there is nothing to see.
  float moves = smoothstep(0.004, 0.05, part);
  float streak = clamp(streakAt(), -0.5, 0.5) * moves;
  vec3 own = speedColourAt(part);
  vec3 shown = streak < 0.0 ? own * (1.0 + 1.5 * streak) : mix(own, vec3(1.0), 1.15 * streak);
  float alpha = 0.82 * moves * smoothstep(-0.05, 0.1, solidsNear(mapWorld).distanceM);
  colour = vec4(shown * alpha, alpha);
}
