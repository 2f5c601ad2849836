#version 450 core
// The wind at a few places, for read-outs: bilinear between cell centres, clamped to the field.
layout(local_size_x = 64) in;
layout(binding = 0) uniform sampler2D windTexture;
layout(std430, binding = 0) buffer Places { vec4 places[]; };  // in: x, y texture coordinates; out: z, w m/s
uniform int count;

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  vec2 size = vec2(textureSize(windTexture, 0));
  vec2 at = clamp(places[i].xy * size - 0.5, vec2(0.0), size - 1.0);
  ivec2 low = ivec2(floor(at));
  ivec2 high = min(low + 1, ivec2(size) - 1);
  vec2 f = at - vec2(low);
  vec2 a = mix(texelFetch(windTexture, low, 0).xy, texelFetch(windTexture, ivec2(high.x, low.y), 0).xy, f.x);
  vec2 b = mix(texelFetch(windTexture, ivec2(low.x, high.y), 0).xy, texelFetch(windTexture, high, 0).xy, f.x);
  places[i].zw = mix(a, b, f.y);
}
