// The ground's height, slope and own shadows, for every shader of a frame. Needs frame.glsl. Heights are the same as
// heightAt() of engine/model/height_field.hpp: bilinear, the edge's height going on outside.
layout(binding = RENDER_TEXTURE_GROUND) uniform sampler2D groundTexture;
layout(binding = RENDER_TEXTURE_GROUND_LIGHT) uniform sampler2D groundLightTexture;

bool groundIsFlat() { return frame.groundGrid.x < 0.5; }

// Between samples, kept within the rectangle.
vec2 groundPlace(vec2 xz) { return clamp((xz - frame.ground.xy) * frame.ground.zw, vec2(0.0), frame.groundGrid.xy - 1.0); }

// m over y = 0.
float groundHeight(vec2 xz) {
  if (groundIsFlat()) return 0.0;
  // By hand: a GPU's own filter has only 256 steps between samples.
  vec2 at = groundPlace(xz);
  ivec2 low = min(ivec2(at), ivec2(frame.groundGrid.xy) - 2);
  vec2 f = at - vec2(low);
  float near = mix(texelFetch(groundTexture, low, 0).r, texelFetch(groundTexture, low + ivec2(1, 0), 0).r, f.x);
  float far = mix(texelFetch(groundTexture, low + ivec2(0, 1), 0).r, texelFetch(groundTexture, low + ivec2(1, 1), 0).r, f.x);
  return frame.groundGrid.z + frame.groundGrid.w * mix(near, far, f.y);
}

struct GroundLight {
  vec3 normal;
  float shadowHeight;  // m over the ground up to which hills hide the sun
};

// `pixels`: that a metre covers there, so that distant hills don't shimmer; 0: full detail.
GroundLight groundLight(vec2 xz, float pixels) {
  if (groundIsFlat()) return GroundLight(vec3(0.0, 1.0, 0.0), -100.0);
  float level = pixels > 0.0 ? max(log2(max(frame.ground.z, frame.ground.w) / pixels), 0.0) : 0.0;
  vec3 value = textureLod(groundLightTexture, (groundPlace(xz) + 0.5) / frame.groundGrid.xy, level).xyz;
  return GroundLight(vec3(value.x, sqrt(max(1.0 - dot(value.xy, value.xy), 0.0)), value.y), value.z);
}

vec3 groundNormal(vec2 xz) { return groundLight(xz, 0.0).normal; }

// A hill's shadow has a wider edge than a stone's, as it falls from farther away.
float softened(float shadowHeight) { return 0.15 * shadowHeight; }

// Light that a slope takes over what level ground takes, 1 where it is level. Grass stands upright, so its slope counts
// less than bare ground's would.
float slopeLight(vec3 n, float sunlit) {
  const vec3 kLuma = vec3(0.2126, 0.7152, 0.0722);
  const float kPart = 0.75;
  vec3 l = frame.sunDirection.xyz;
  float sun = dot(frame.sunColour.rgb, kLuma) * sunlit;
  float sky = dot(frame.skyColour.rgb, kLuma);
  float level = sun * max(l.y, 0.0) + sky;
  float slope = sun * max(dot(n, l), 0.0) + sky * (0.5 + 0.5 * n.y);
  return mix(1.0, slope / level, kPart);
}
