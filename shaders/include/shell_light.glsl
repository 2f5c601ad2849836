// How shell grass takes light. Needs frame.glsl, noise.glsl, ground.glsl, wind_field.glsl, meadow.glsl, solids.glsl, grass_maps.glsl,
// shell_bend.glsl and the vertex `v` (shell_vertex.glsl).

// Light at the foot of upright blades is that of leaning ones so high up: fewer of them stand in its way.
const float kThinned = 0.76;
// Levels of the texture that are left out, so that no blade is narrower than a pixel or two.
const float kBlur = 0.7;
// Size of the noise that blades in still air lean by, and its finest detail: the texture must not be torn.
const float kClumpLeanM = 9.0, kClumpDetailM = 0.7;

// Of the clump at a place of the texture, over the blades' height.
vec2 clumpLean(vec2 place, float perMetre) {
  float level = log2(256.0 / kClumpLeanM * max(1.0 / perMetre, kClumpDetailM));
#ifdef SURFACE
  const float kStrength = 6.0;  // seen from above, as on a body, upright blades are mere dots
#else
  const float kStrength = 4.0;
#endif
  return (noiseAtLevel(place / shell.size.y, kClumpLeanM, level).rg - 0.5) * (kStrength * shell.bend.z);
}

// How far blades are narrower than a pixel, so that more and more the canopy as a whole is seen. `perMetre` of the texture.
#ifdef QUICK
const vec2 kFar = vec2(0.7, 0.2);  // its coarse texels would show
#else
const vec2 kFar = vec2(0.35, 0.08);
#endif
float farness(float perMetre) { return smoothstep(kFar.x, kFar.y, grass.size.x * perMetre); }

// 0 where grass is too low to be seen and left to the ground .. 1.
float standing(float pixels) { return shell.look.y > 0.0 ? smoothstep(shell.look.y, 1.6 * shell.look.y, pixels) : 1.0; }

// Beside solids, and on the underside of surfaces, less of the sky is seen.
float openHere() {
#ifdef SURFACE
  return 0.6 + 0.4 * v.normal.y;
#else
  return openness(v.shade.y);
#endif
}

// What of a blade is seen.
struct ShellSeen {
  vec3 upper;       // colour of its upper part
  float rootLight;  // its root's over that
  float number;     // the blade's own, 0..1
  float height;     // 0..1 of the tallest
  float along;      // 0..1 of the blade
};

// `bend` as ShellVertex, `clump` of clumpLean, `root` m.
vec3 litBlade(ShellSeen seen, vec3 bend, vec2 clump, vec2 root, vec3 eye) {
  vec3 foot = seen.upper * shell.root.rgb * seen.rootLight;
  vec3 green = mix(foot, seen.upper, smoothstep(-0.2, 1.0, seen.along));
  vec3 straw = mix(foot * 1.6, grass.dryColour.rgb, smoothstep(-0.1, 0.8, seen.along));
  vec3 albedo = mix(green, straw, clamp(0.15 * v.light.y, 0.0, 1.0)) * v.light.z;
#ifndef SURFACE
  albedo *= mapColour(root);
#endif
  float intensity = length(bend);
  float lean = pow(seen.height, shell.rings.w) * SHELL_HALF_PI * intensity;
  vec3 up = normalize(v.up);
  vec3 stem = up * cos(lean) + bend * (sin(lean) / max(intensity, 1e-4));
  stem = normalize(stem + 2.0 * seen.height * alongSurface(vec3(clump.x, 0.0, clump.y), up));
  float canopy = grass.baseColour.w * v.size.z;
#ifdef SURFACE
  canopy *= surface.x;
#endif
  float inCanopy = clamp(seen.height * v.size.x / max(canopy, 1e-3), 0.0, 1.0);
  GrassLight at;
  at.height = mix(1.0, mix(kThinned, 1.0, inCanopy), smoothstep(0.25, 0.7, v.size.z));
  at.dense = grass.levels.z;
  at.sunlit = smoothstep(-0.15, 0.15, v.size.y - v.shade.x);
  at.shade = heightWindShade(seen.along * mix(1.0, stem.y, 0.5), v.light.w) * mix(openHere(), 1.0, 0.5 * at.height);
  albedo = laidAlbedo(albedo * (0.85 + 0.3 * seen.number), dot(stem, up));
  return lightCanopy(albedo, stem, eye, up, at) + contourLift(v.normal, eye, at.sunlit * at.height);
}

// The canopy where its blades can't be told apart: as the ground far away has it, so that no seam shows.
vec3 litAfar(vec2 root, vec3 eye) {
  float sunlit = smoothstep(-0.15, 0.15, v.size.y - v.shade.x);
  vec3 light = meadowColour(root, v.shade.zw, eye, normalize(v.normal), sunlit) * mix(openHere(), 1.0, 0.5);
#ifndef SURFACE
  light *= mapColour(root);
#endif
  return light * (v.light.z / max(meadowPatch(root).y, 0.1));
}
