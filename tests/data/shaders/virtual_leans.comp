#version 450 core
// What drawn blades read from the virtual wind, for a test: place and rest lean in, leans out.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/virtual_wind.glsl"

layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer Queries { vec4 queries[]; };  // x, z place; z, w rest lean
layout(std430, binding = 1) writeonly buffer Answers { vec4 answers[]; };
uniform float factor;

void main() {
  uint i = gl_GlobalInvocationID.x;
  ChainLeans leans = virtualLeans(queries[i].xy, queries[i].zw, factor);
  answers[2u * i] = vec4(leans.e[0], leans.e[1]);
  answers[2u * i + 1u] = vec4(leans.e[2], leans.e[3]);
}
