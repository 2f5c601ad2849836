#version 450 core
// The end of the flux pass, by a single work-group.
#include "shaders/wind/block.glsl"

layout(local_size_x = WIND_TOTAL_GROUP) in;
layout(std430, binding = WIND_SSBO_CONTROL) buffer Control { WindControl control; };
#define GROUP_SIZE WIND_TOTAL_GROUP
shared float scratch[4 * GROUP_SIZE];
#include "shaders/wind/start_solve.glsl"

void main() { startSolve(); }
