#version 450 core
// The end of a cycle, by a single work-group: how it joins the ones before (docs/solver.md section 6), and whether it
// was the last.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_TOTAL_GROUP) in;
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#define GROUP_SIZE WIND_TOTAL_GROUP
#define SUM_COUNT 4  // r . A z, A z . A z, A z . A p, r . r
#define SUM_ADDED 4
shared float scratch[SUM_COUNT * GROUP_SIZE];
#include "shaders/wind/sums.glsl"
#include "shaders/wind/total.glsl"
#include "shaders/wind/solve_control.glsl"

void main() {
  float total[SUM_COUNT];
  addUp(total);
  if (gl_LocalInvocationIndex != 0u) return;
  float beta = control.cycles > 0u ? total[2] / control.size : 0.0;
  float size = total[1] - (control.cycles > 0u ? beta * beta * control.size : 0.0);
  bool useful = size > 0.0;
  float alpha = useful ? total[0] / size : 0.0;
  control.beta = beta;
  control.size = size;
  control.alpha = alpha;
  // From r . r of this cycle: subtracted cycle by cycle, the first one's rounding would hide the last one's residual.
  control.flux = max(total[3] - alpha * total[0], 0.0) * wind.perAir;
  control.cycles += 1u;
  if (useful && control.flux > control.wanted) return;
  setDispatches(false, false);
}
