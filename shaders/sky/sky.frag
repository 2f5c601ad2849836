#version 450 core
// The sky behind everything: the baked map and the sun's disc.
#include "shaders/include/frame.glsl"
layout(location = 0) out vec4 sceneColour;

in vec2 screenUv;
layout(binding = RENDER_TEXTURE_SKY) uniform sampler2D skyTexture;

void main() {
  vec2 clip = screenUv * 2.0 - 1.0;
  vec4 far = frame.inverseViewProjection * vec4(clip, 1.0, 1.0);
  vec3 ray = isOrthographic() ? frame.viewForward.xyz : normalize(far.xyz / far.w - frame.cameraPosition.xyz);
  vec2 at = vec2(atan(ray.z, ray.x) / 6.2831853 + 0.5, sqrt(asin(clamp(ray.y, 0.0, 1.0)) / 1.5707963));
  vec3 colour = textureLod(skyTexture, at, 0.0).rgb;
  float disc = smoothstep(0.99990, 0.99997, dot(ray, frame.sunDirection.xyz));
  sceneColour = vec4(mix(colour, vec3(1.0, 0.98, 0.93), disc), 1.0);
}
