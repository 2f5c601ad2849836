// The map of solids: how far the nearest one is, and how high their shadows reach. Needs frame.glsl.
layout(binding = RENDER_TEXTURE_SOLID_DISTANCE) uniform sampler2D solidDistanceTexture;
layout(binding = RENDER_TEXTURE_SOLID_SHADOW) uniform sampler2D solidShadowTexture;

vec2 solidUv(vec2 world) { return (world - frame.solidMap.xy) * frame.solidMap.zw; }

// m to the nearest solid, negative inside it.
float solidDistance(vec2 world) { return textureLod(solidDistanceTexture, solidUv(world), 0.0).r; }

// m over the ground up to which the sun is hidden.
float solidShadowHeight(vec2 world) { return textureLod(solidShadowTexture, solidUv(world), 0.0).r; }

// 1 in the open, less where the ground lies close to a wall.
float openness(float distanceM) { return mix(0.35, 1.0, smoothstep(-0.1, 1.1, distanceM)); }
