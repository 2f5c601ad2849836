#version 450 core
// Takes faces as they are, makes blocked ones 0 and sets the ghosts: a field from the CPU, or one whose borders
// changed.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_GROUP_X, local_size_y = WIND_GROUP_Z) in;
layout(std430, binding = WIND_SSBO_CARRIED) readonly buffer Carried { float carried[]; };
layout(std430, binding = WIND_SSBO_RESULT) writeonly buffer Result { float result[]; };

#define GHOST_TARGET result
#include "shaders/wind/ghosts.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x), k = int(gl_GlobalInvocationID.y);
  if (i <= wind.width && k < wind.height) {
    storeU(i, k, openX(i, k) ? carried[uAt(periodicX() && i == wind.width ? 0 : i, k)] : 0.0);
  }
  if (i < wind.width && k <= wind.height) {
    storeW(i, k, openZ(i, k) ? carried[wAt(i, periodicZ() && k == wind.height ? 0 : k)] : 0.0);
  }
}
