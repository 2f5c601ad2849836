#version 450 core
// A plant's surface. Without a texture its colour comes ready from its vertices. With one, edges of the texture become
// coverage of the samples; discarding costs the early depth test, so only then.
#include "shaders/include/frame.glsl"
#include "shaders/include/tone_map.glsl"

layout(location = 0) out vec4 sceneColour;

#ifdef TEXTURED
layout(binding = RENDER_TEXTURE_PLANT) uniform sampler2D plantTexture;
uniform float alphaCutoff;
in vec2 plantUv;
in vec4 plantAlbedo;
in vec3 plantLight;
in vec3 plantGloss;
in vec4 plantHaze;

void main() {
  vec4 albedo = plantAlbedo * texture(plantTexture, plantUv);
  // Alpha crosses the cutoff within one pixel (Golus, "Anti-aliased Alpha Test", 2017).
  float coverage = clamp((albedo.a - alphaCutoff) / max(fwidth(albedo.a), 1e-4) + 0.5, 0.0, 1.0);
  if (coverage <= (gl_NumSamples > 1 ? 0.0 : 0.5)) discard;
  vec3 light = albedo.rgb * plantLight + plantGloss;
  sceneColour = vec4(toPicture(mix(light, plantHaze.rgb, plantHaze.a)), coverage);
}
#else
in vec3 plantPicture;

void main() { sceneColour = vec4(plantPicture, 1.0); }
#endif
