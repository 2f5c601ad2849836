// The plain scheme's common part: one texel a cell, cells of one metre, zero outside.

layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D velocity;
uniform float dt;  // s

ivec2 cell() { return ivec2(gl_GlobalInvocationID.xy); }
bool isOutside(ivec2 c, ivec2 size) { return c.x < 0 || c.y < 0 || c.x >= size.x || c.y >= size.y; }
vec4 fetch(sampler2D field, ivec2 c) {
  return isOutside(c, textureSize(field, 0)) ? vec4(0.0) : texelFetch(field, c, 0);
}
