#version 450 core
// A plant's surface. Edges of its texture become coverage of the samples.
#include "shaders/include/frame.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/shared/plant_block.h"

layout(binding = RENDER_TEXTURE_PLANT) uniform sampler2D plantTexture;
uniform float textured;
uniform float alphaCutoff;

in vec2 plantUv;
in vec4 plantAlbedo;
in vec3 plantLight;
in vec3 plantGloss;
in vec4 plantHaze;
layout(location = 0) out vec4 sceneColour;

void main() {
  vec4 albedo = plantAlbedo;
  float coverage = 1.0;
  if (textured > 0.5) {
    albedo *= texture(plantTexture, plantUv);
    // Alpha crosses the cutoff within one pixel (Golus, "Anti-aliased Alpha Test", 2017).
    coverage = clamp((albedo.a - alphaCutoff) / max(fwidth(albedo.a), 1e-4) + 0.5, 0.0, 1.0);
    if (coverage <= (gl_NumSamples > 1 ? 0.0 : 0.5)) discard;
  }
  vec3 light = albedo.rgb * plantLight + plantGloss;
  sceneColour = vec4(toPicture(mix(light, plantHaze.rgb, plantHaze.a)), coverage);
}
