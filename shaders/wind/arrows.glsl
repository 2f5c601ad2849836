// What the arrows do to the air of a cell. docs/solver.md section 3. Needs block.glsl.
#include "shaders/shared/arrow_force.h"

layout(std430, binding = WIND_SSBO_ARROWS) readonly buffer Arrows { ArrowForce arrows[]; };
layout(std430, binding = WIND_SSBO_TILE_START) readonly buffer TileStart { uint tileStart[]; };
layout(std430, binding = WIND_SSBO_TILE_ARROWS) readonly buffer TileArrows { uint tileArrows[]; };

struct ArrowSums {
  float rate;       // drive speed
  vec2 target;
  vec2 force;       // drive force
  float swirlRate;  // swirl
  vec2 swirl;
};

void addDrive(ArrowForce a, float rateAtCentre, vec2 place, vec2 v, inout ArrowSums sums) {
  vec2 along = a.to - a.from;
  float square = dot(along, along);
  float t = square > 0.0 ? clamp(dot(place - a.from, along) / square, 0.0, 1.0) : 0.0;
  vec2 away = place - a.from - t * along;
  float d2 = dot(away, away);
  if (d2 >= a.radius * a.radius) return;
  float g = exp(-2.0 / (a.radius * a.radius) * d2);
  if (a.drive == ARROW_DRIVE_SPEED) {
    float s = dot(v, a.direction);
    float rate = g * rateAtCentre;
    sums.rate += rate;
    sums.target += rate * (a.strength >= 0.0 ? max(s, a.strength) : min(s, a.strength)) * a.direction;
  } else {
    sums.force += g * a.strength * a.direction;
  }
}

void addSwirl(ArrowForce a, float rateAtCentre, vec2 place, vec2 v, inout ArrowSums sums) {
  vec2 e = place - a.to;
  float d2 = dot(e, e);
  if (d2 >= a.radius * a.radius || d2 <= 0.0) return;
  float d = sqrt(d2);
  float g = exp(-2.0 * d2 / (a.radius * a.radius));
  float profile = a.swirl * (2.0 * d / a.radius) * g * 1.6487213;  // exp(1/2)
  vec2 tangent = vec2(-e.y, e.x) / d;
  float lacking = profile - dot(v, tangent);
  float m = a.swirl >= 0.0 ? max(lacking, 0.0) : min(lacking, 0.0);
  sums.swirlRate += g * rateAtCentre;
  sums.swirl += g * rateAtCentre * m * tangent;
}

// (1 - exp(-rate dt)) / rate
float approach(float rate) { return rate * wind.dt < 1e-4 ? wind.dt : (1.0 - exp(-rate * wind.dt)) / rate; }

vec2 arrowIncrement(int i, int k, vec2 place, vec2 v) {
  int tile = (k / wind.tileSide) * wind.tileColumns + i / wind.tileSide;
  uint last = tileStart[tile + 1];
  uint next = tileStart[tile];
  if (next == last) return vec2(0.0);
  ArrowSums sums = ArrowSums(0.0, vec2(0.0), vec2(0.0), 0.0, vec2(0.0));
  for (; next < last; ++next) {
    ArrowForce a = arrows[tileArrows[next]];
    float rateAtCentre = min(abs(a.factor), 1.0) / max(a.response, WIND_MIN_RESPONSE);
    if (a.strength != 0.0) addDrive(a, rateAtCentre, place, v, sums);
    if (a.swirl != 0.0) addSwirl(a, rateAtCentre, place, v, sums);
  }
  vec2 driven = (sums.target - sums.rate * v) * approach(sums.rate);
  return driven + sums.swirl * approach(sums.swirlRate) + wind.dt * sums.force;
}
