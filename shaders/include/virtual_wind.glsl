// The leans of drawn blades from the virtual wind (virtual_blades.comp). Needs frame.glsl, noise.glsl, wind_field.glsl.
#include "shaders/shared/segment_chain.h"

layout(std140, binding = RENDER_UBO_CHAIN) uniform ChainUniforms { ChainBlock chain; };
layout(binding = RENDER_TEXTURE_VIRTUAL_WIND) uniform sampler2DArray virtualWindTexture;

// G over k at a place, between texels; outside the field it turns into what the ambient wind and rotors hold.
ChainLeans virtualMoments(vec2 world) {
  ChainLeans moments;
  vec2 uv = worldToUv(world, frame.field.xy, frame.field.zw);
  vec4 low = textureLod(virtualWindTexture, vec3(uv, 0.0), 0.0);
  vec4 high = textureLod(virtualWindTexture, vec3(uv, 1.0), 0.0);
  moments.e = vec2[](low.xy, low.zw, high.xy, high.zw);
  float outside = outsideField(world);
  if (outside > 0.0 && frame.pixelScale.w > 0.5) {
    vec2 ambient = rippledWind(world, frame.ambientWind.xy + rotorAirOver(world, 0.0, 0.0).xz, chain.wind.z);
    ChainLeans held = chainMoments(chain, chainSteadyLeans(chain, ambient));
    for (int i = 0; i < CHAIN_SEGMENTS; ++i) moments.e[i] = mix(moments.e[i], held.e[i], outside);
  }
  return moments;
}

// The leans of a blade over its pose in still air. `rest`: lean of its tip there; `factor`: its F over stiffness, s/m.
ChainLeans virtualLeans(vec2 root, vec2 rest, float factor) {
  ChainLeans moments = virtualMoments(root);
  vec2 softness = chainSoftness(chain, moments, rest, factor / max(chain.wind.w, 1e-6));
  return chainEquilibrium(chain, moments, rest, softness);
}
