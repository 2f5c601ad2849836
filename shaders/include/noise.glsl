// The tiling noise texture: red coarse fractal noise, green another, blue fine, alpha streaks; means 0.5.
layout(binding = RENDER_TEXTURE_NOISE) uniform sampler2D noiseTexture;

vec4 noiseAt(vec2 world, float sizeM) { return texture(noiseTexture, world / sizeM); }
// Where there are no derivatives (compute, vertex) or the size in pixels is known.
vec4 noiseAtLevel(vec2 world, float sizeM, float level) { return textureLod(noiseTexture, world / sizeM, level); }
