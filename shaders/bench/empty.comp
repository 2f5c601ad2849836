#version 450 core
// Does next to nothing: what a dispatch and its barrier cost by themselves.
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Counter { uint count; };
void main() {
  count += 1u;
}
