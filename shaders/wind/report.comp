#version 450 core
// The numbers of a step, by a single work-group. docs/solver.md section 7.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_TOTAL_GROUP) in;
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#define GROUP_SIZE WIND_TOTAL_GROUP
#define SUM_COUNT 5  // flux^2, |v|^2; greatest flux, |v|^2, crossing
#define SUM_ADDED 2
shared float scratch[SUM_COUNT * GROUP_SIZE];
#include "shaders/wind/sums.glsl"
#include "shaders/wind/total.glsl"

void main() {
  float total[SUM_COUNT];
  addUp(total);
  if (gl_LocalInvocationIndex != 0u) return;
  control.fluxAfter = total[0] * wind.perAir;
  control.energy = 0.5 * total[1] * wind.perAir;
  control.maxFluxAfter = total[2];
  control.maxSpeedSquare = total[3];
  control.crossing = total[4];
  control.history = control.history == WIND_HISTORY_BAD ? WIND_HISTORY_NONE : WIND_HISTORY_GOOD;
}
