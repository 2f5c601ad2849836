#version 450 core
// Reads and writes every byte once: the memory bandwidth that a pass over the field can reach.
layout(local_size_x = 256) in;
layout(std430, binding = 0) readonly buffer Source { vec4 source[]; };
layout(std430, binding = 1) writeonly buffer Target { vec4 target[]; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < uint(source.length())) target[i] = source[i];
}
