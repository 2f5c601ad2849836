#version 450 core
// The first step of a field: what one cycle found becomes the expected pressure, and the solve begins again. Taken off
// the velocity on its own it is exact; as a part of the whole solution its rounding would hide what is left to solve.
// docs/solver.md section 6.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_GROUP_X, local_size_y = WIND_GROUP_Z) in;
layout(std430, binding = WIND_SSBO_D_IN) readonly buffer D { float d[]; };
layout(std430, binding = WIND_SSBO_PHI) writeonly buffer Phi { float phi[]; };
layout(std430, binding = WIND_SSBO_PREDICTED) writeonly buffer Predicted { float predicted[]; };
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };

void main() {
  int i = int(gl_GlobalInvocationID.x), k = int(gl_GlobalInvocationID.y);
  if (i == 0 && k == 0) control.history = WIND_HISTORY_GOOD;
  if (i >= wind.width || k >= wind.height) return;
  int at = cellAt(i, k);
  float found = control.cycles > 0u ? finiteOr(control.alpha * d[at], 0.0) : 0.0;
  phi[at] = found;
  predicted[at] = found;
}
