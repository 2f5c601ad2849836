#version 450 core
// The farthest depth of what is drawn so far, of 2 x 2 pixels and all their samples: what lies behind is hidden.
#include "shaders/shared/render_bindings.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(r32f, binding = RENDER_IMAGE_NEAR_DEPTH) writeonly uniform image2D farthestImage;
#ifdef SAMPLES
layout(binding = RENDER_TEXTURE_MAP) uniform sampler2DMS sceneDepth;
#else
layout(binding = RENDER_TEXTURE_MAP) uniform sampler2D sceneDepth;
#endif
uniform ivec2 size;  // of the scene

float depthAt(ivec2 pixel) {
  pixel = min(pixel, size - 1);
#ifdef SAMPLES
  float farthest = 0.0;
  for (int i = 0; i < SAMPLES; ++i) farthest = max(farthest, texelFetch(sceneDepth, pixel, i).r);
  return farthest;
#else
  return texelFetch(sceneDepth, pixel, 0).r;
#endif
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(at, imageSize(farthestImage)))) return;
  float farthest = 0.0;
  for (int i = 0; i < 4; ++i) farthest = max(farthest, depthAt(2 * at + ivec2(i & 1, i >> 1)));
  imageStore(farthestImage, at, vec4(farthest));
}
