#version 450 core
// The rotors' air and the wind that grass feels, for a test: xyz place in, w s after the frame's time.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"

layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer Queries { vec4 queries[]; };
layout(std430, binding = 1) writeonly buffer Answers { vec4 answers[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  vec4 query = queries[i];
  answers[3u * i] = vec4(rotorAir(query.xyz), 0.0);
  answers[3u * i + 1u] = vec4(rotorAirOver(query.xz, query.y, query.w), 0.0);
  answers[3u * i + 2u] = vec4(smoothWind(query.xz), groupWind(query.xz));
}
