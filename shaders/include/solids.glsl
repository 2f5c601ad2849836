// The map of solids: how far the nearest one is, and how high their shadows reach. Needs frame.glsl.
layout(binding = RENDER_TEXTURE_SOLIDS) uniform sampler2D solidTexture;

struct SolidsNear {
  float distanceM;     // to the nearest solid, negative inside it
  float shadowHeight;  // m over the ground up to which the sun is hidden
};

SolidsNear solidsNear(vec2 world) {
  vec2 value = textureLod(solidTexture, (world - frame.solidMap.xy) * frame.solidMap.zw, 0.0).rg;
  return SolidsNear(value.r, -value.g);
}

// 1 in the open, less where the ground lies close to a wall.
float openness(float distanceM) { return mix(0.35, 1.0, smoothstep(-0.1, 1.1, distanceM)); }
