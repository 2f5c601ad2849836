#version 450 core
// One level of the pyramid of farthest depths: the lowest from the drawn depths and their neighbours, each other one from
// the one below it.
#include "shaders/shared/render_bindings.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = RENDER_TEXTURE_OCCLUDERS) uniform sampler2D below;
layout(binding = 0, r32f) uniform writeonly image2D farthest;
uniform int level;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(farthest)))) return;
  int from = max(level - 1, 0);
  ivec2 last = textureSize(below, from) - 1;
  ivec2 low = level == 0 ? at - 1 : at * 2;
  ivec2 high = level == 0 ? at + 1 : at * 2 + 1;
  float depth = 0.0;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) depth = max(depth, texelFetch(below, clamp(ivec2(x, y), ivec2(0), last), from).r);
  }
  imageStore(farthest, at, vec4(depth));
}
