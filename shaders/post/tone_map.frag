#version 450 core
// The one place where the picture becomes sRGB: every sample of the scene is tone mapped, then averaged, so
// that bright edges stay smooth; the overlay, already in picture colours, goes over it.
#include "shaders/include/tone_map.glsl"
#include "shaders/include/frame.glsl"

#if SAMPLES > 1
layout(binding = RENDER_TEXTURE_SCENE) uniform sampler2DMS scene;
layout(binding = RENDER_TEXTURE_OVERLAY) uniform sampler2DMS overlay;
#else
layout(binding = RENDER_TEXTURE_SCENE) uniform sampler2D scene;
layout(binding = RENDER_TEXTURE_OVERLAY) uniform sampler2D overlay;
#endif
uniform ivec2 origin;
uniform int withOverlay;

layout(location = 0) out vec4 picture;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - origin;
  vec3 sum = vec3(0.0);
  vec4 over = vec4(0.0);
  for (int i = 0; i < SAMPLES; ++i) {
    sum += encodeSrgb(filmic(texelFetch(scene, at, i).rgb * frame.sunDirection.w));
    if (withOverlay != 0) over += texelFetch(overlay, at, i);
  }
  vec3 colour = sum / float(SAMPLES);
  over /= float(SAMPLES);
  picture = vec4(colour * (1.0 - over.a) + over.rgb, 1.0);
}
