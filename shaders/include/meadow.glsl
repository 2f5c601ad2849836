// How grass takes light. Needs frame.glsl, noise.glsl, wind_field.glsl.
// Translucency by opposite signs of N.L and N.V, and mutual shadow growing towards the base, follow
// Belyaev, Laevsky & Chukanov 2011 (Inertial grassland); mean reflection of many blades around one
// lean follows the cylinder model of Kajiya & Kay 1989.
#include "shaders/shared/canopy_shade.h"
#include "shaders/shared/grass_block.h"

layout(std140, binding = RENDER_UBO_GRASS) uniform GrassUniforms { GrassBlock grass; };

// Broad patches of the meadow, seen in blades and in the far ground alike: x dryness, y brightness.
vec2 meadowPatch(vec2 world) {
  vec4 broad = noiseAtLevel(vec2(world.x + 0.31 * world.y, world.y - 0.27 * world.x), 83.0, 1.0);
  vec4 small = noiseAtLevel(vec2(world.y - 0.4 * world.x, world.x + 0.2 * world.y), 17.0, 1.0);
  float dry = smoothstep(0.42, 0.8, 0.5 * broad.g + 0.5 * small.r);
  return vec2(dry, 0.86 + 0.28 * (0.4 * broad.r + 0.6 * small.g));
}

// Colour along a blade. `height` 0..1, `dry` 0..1, `hue` -1 bluish .. 1 yellowish.
vec3 bladeAlbedo(uint species, float height, float dry, float bright, float hue) {
  vec3 base = grass.species[species].base.rgb;
  vec3 green = mix(base, grass.species[species].tip.rgb, smoothstep(0.0, 1.0, height));
  vec3 straw = mix(base * 1.6, grass.dryColour.rgb, smoothstep(-0.1, 0.8, height));
  vec3 colour = mix(green, straw, dry);
  return colour * bright * (vec3(1.0) + hue * vec3(0.16, 0.03, -0.14));
}

// Sunlight that reaches a height (0 root .. 1 top of the canopy) through the blades above it.
float sunInCanopy(float height, float open) {
  float depth = max(1.0 - height, 0.0) * open;
  return exp(-0.85 * depth / max(frame.sunDirection.y, 0.2));
}

float skyInCanopy(float height) { return mix(0.22, 1.0, height * (2.0 - height)); }

float fourth(float x) { return x * x * (x * x); }

struct GrassLight {
  float height;    // 0 root .. 1 top of the canopy
  float dense;     // 0 bare .. 1 closed canopy
  float sunlit;    // 0 in the shadow of a solid
  float shade;     // factor of eq. 14
};

vec3 transmitted(vec3 albedo) { return albedo * vec3(1.22, 1.05, 0.38); }

// Grass laid away from the eye shows its lit sides, grass laid towards it the gaps between its tips: what
// makes the stripes of a mown lawn, and of wind. `up`: out of what it grows on.
float combed(vec3 t, vec3 v, vec3 up) { return 1.0 - 0.55 * (dot(t, v) - dot(t, up) * dot(v, up)); }

// Laid blades mirror the sky.
vec3 skySheen(float laid, float sun) { return frame.skyColour.rgb * (0.14 * laid * laid * (0.4 + 0.6 * sun)); }

// And they show their paler undersides.
vec3 laidAlbedo(vec3 albedo, float upright) {
  float laid = clamp(1.0 - upright * upright, 0.0, 1.0);
  return mix(albedo, vec3(0.95, 1.05, 0.75) * dot(albedo, vec3(0.3, 0.6, 0.1)), 0.35 * laid) * (1.0 + 1.2 * laid);
}

// Light from a point of one blade towards `v`; `n` is the blade's normal on the side seen, `up` where it grows to.
vec3 lightBlade(vec3 albedo, vec3 n, vec3 t, vec3 v, vec3 up, GrassLight at) {
  vec3 l = frame.sunDirection.xyz;
  float sun = sunInCanopy(at.height, at.dense) * at.sunlit;
  float nl = dot(n, l);
  float forward = fourth(max(dot(v, -l), 0.0));
  vec3 direct = albedo * max(nl, 0.0) + transmitted(albedo) * max(-nl, 0.0) * (0.5 + 0.7 * forward);
  vec3 sky = frame.skyColour.rgb * skyInCanopy(at.height) * (0.75 + 0.25 * n.y);
  vec3 bounce = frame.sunColour.rgb * grass.tipColour.rgb * 0.06;
  float sheen = pow(max(dot(n, normalize(v + l)), 0.0), 14.0) * (0.04 + 0.5 * fourth(1.0 - max(dot(n, v), 0.0)));
  vec3 colour = (frame.sunColour.rgb * sun * direct + albedo * (sky + bounce)) * combed(t, v, up);
  float upright = dot(t, up);
  return colour * at.shade + frame.sunColour.rgb * (sheen * sun * 0.35) + skySheen(at.height * (1.0 - upright * upright), sun);
}

// Mean light of the canopy from far: blades of every direction around the stem direction `t`. `up`: where it grows to.
vec3 lightCanopy(vec3 albedo, vec3 t, vec3 v, vec3 up, GrassLight at) {
  vec3 l = frame.sunDirection.xyz;
  float tl = dot(t, l);
  float tv = dot(t, v);
  float sinL = sqrt(max(1.0 - tl * tl, 0.0));
  float sinV = sqrt(max(1.0 - tv * tv, 0.0));
  // Share of the light that meets the side seen: the angle between sun and eye around the stem.
  // Along the stem no side is seen more than another, hence the bound on sinV.
  float around = clamp((dot(l, v) - tl * tv) / max(sinL * max(sinV, 0.6), 0.05), -1.0, 1.0);
  float front = 0.5 + 0.5 * around;
  float forward = fourth(max(dot(v, -l), 0.0));
  float sun = sunInCanopy(at.height, at.dense) * at.sunlit;
  vec3 direct = sinL * 0.46 * (albedo * front + transmitted(albedo) * (1.0 - front) * (0.5 + 0.7 * forward));
  vec3 h = normalize(v + l);
  float th = dot(t, h);
  float beside = max(1.0 - th * th, 0.0);
  float sheen = fourth(beside) * beside * beside * beside * 0.04 + 0.05 * forward * sinL;
  vec3 sky = frame.skyColour.rgb * skyInCanopy(at.height) * 0.85;
  vec3 bounce = frame.sunColour.rgb * grass.tipColour.rgb * 0.06;
  vec3 colour = (frame.sunColour.rgb * sun * direct + albedo * (sky + bounce)) * combed(t, v, up);
  return colour * at.shade + frame.sunColour.rgb * (sheen * sun * 0.35) + skySheen(1.0 - dot(t, up), sun);
}

// Contours of the meadow catch the sky's light: Ks (1 - (N_L . V))^p with the ground's normal (Belyaev and others).
vec3 contourLift(vec3 ground, vec3 v, float lit) {
  float edge = 1.0 - clamp(dot(ground, v), 0.0, 1.0);
  float edge2 = edge * edge;
  return (0.030 * frame.sunColour.rgb + 0.045 * frame.skyColour.rgb) * grass.tipColour.rgb * (edge2 * edge2 * edge2 * lit);
}

// Eq. 14 of Choi & Sung 2024: `height` of the point over its root after bending in blade lengths, `force` |F|.
float heightWindShade(float height, float force) { return canopyShade(height, force, grass.shadow); }

// |F| of eq. 14.
float shadeForce(float speed) {
  float force = grass.motion.x * speed;
  return grass.size.w != GRASS_DEFORMATION_QUADRATIC ? boundedForce(force) : force;
}

// The stem direction of grass under a wind: mean over blades.
vec3 meanStem(vec2 wind) {
  vec2 bend = arcSteadyBend(vec2(0.0), wind, grass.motion.x);
  float angle = length(bend);
  if (angle < 1e-4) return vec3(0.0, 1.0, 0.0);
  // The foot of a blade leans less than its tip.
  float mean = 0.8 * angle;
  return vec3(bend.x / angle * sin(mean), cos(mean), bend.y / angle * sin(mean));
}

// Earth and old grass between the stems. `litter` 0..1 bare to covered.
vec3 undergrowth(float litter, float bright, float sunlit, float open) {
  vec3 low = mix(frame.groundColour.rgb, bladeAlbedo(0u, 0.45, 0.1, 1.0, 0.0), 0.55 + 0.4 * litter) * bright;
  float sun = sunInCanopy(0.3, grass.levels.z) * sunlit;
  vec3 light = frame.sunColour.rgb * max(frame.sunDirection.y, 0.0) * sun + frame.skyColour.rgb * mix(0.9, 0.4, grass.levels.z) * open;
  return low * light;
}

// Part of the ground that is seen between the blades from direction `v`.
float groundSeen(vec3 v, vec3 stem) {
  float up = max(v.y, 0.02);
  float slant = sqrt(max(1.0 - up * up, 0.0)) / up;
  return exp(-grass.levels.w * (0.45 * stem.y * slant + 0.2 + 0.6 * (1.0 - stem.y)));
}

// The meadow as seen from where single blades can't be told apart.
vec3 meadowColour(vec2 world, vec2 wind, vec3 v, vec3 ground, float sunlit) {
  vec2 patchTint = meadowPatch(world);
  vec3 stem = meanStem(wind);
  // A low eye sees the tips, a high one looks down into the canopy.
  float height = mix(0.86, 0.52, sqrt(max(v.y, 0.0)));
  GrassLight at = GrassLight(height, 1.0, sunlit, heightWindShade(0.8 * mix(1.0, stem.y, 0.5), shadeForce(length(wind))));
  vec3 albedo = laidAlbedo(bladeAlbedo(0u, height, patchTint.x * grass.dryColour.w, patchTint.y, 0.0), stem.y);
  // What neighbours take from each other besides, fitted to pictures of every blade (bench picture).
  float up = max(v.y, 0.0);
  float fitted = (1.0 - 0.357 * sqrt(up) * (1.0 - 0.902 * up)) * (0.9 + 0.1 * smoothstep(0.0, 0.15, 1.0 - stem.y)) * (1.0 - 0.04 * smoothstep(0.0, 0.3, up));
  vec3 light = lightCanopy(albedo, stem, v, vec3(0.0, 1.0, 0.0), at) * fitted + contourLift(ground, v, sunlit * height);
  return mix(light, undergrowth(0.5, 1.0, sunlit, 1.0), groundSeen(v, stem));
}
