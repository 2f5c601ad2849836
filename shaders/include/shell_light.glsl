// How shell grass takes light. Needs frame.glsl, noise.glsl, ground.glsl, wind_field.glsl, meadow.glsl, solids.glsl, grass_maps.glsl,
// shell_bend.glsl and the vertex `v` (shell_vertex.glsl).

// Light at the foot of upright blades is that of leaning ones so high up: fewer of them stand in its way.
const float kThinned = 0.76;
// Levels of the texture that are left out, so that no blade is narrower than a pixel or two.
const float kBlur = 0.7;
// Where along a blade the light of its foot is found.
const float kFootAlong = 0.15;
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
const vec2 kFar = vec2(0.2, 0.7);  // its coarse texels would show
#else
const vec2 kFar = vec2(0.08, 0.35);
#endif
float farness(float perMetre) { return 1.0 - smoothstep(kFar.x, kFar.y, grass.size.x * perMetre); }

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

vec3 albedoOf(ShellSeen seen) {
  vec3 foot = seen.upper * shell.root.rgb * seen.rootLight;
  vec3 green = mix(foot, seen.upper, smoothstep(-0.2, 1.0, seen.along));
  vec3 straw = mix(foot * 1.6, grass.dryColour.rgb, smoothstep(-0.1, 0.8, seen.along));
  return mix(green, straw, clamp(0.15 * v.light.y, 0.0, 1.0)) * (v.light.z * (0.85 + 0.3 * seen.number));
}

#ifndef FRAGMENT
// Light over the albedo. `bend` as ShellVertex, `clump` of clumpLean.
vec3 litOver(ShellSeen seen, vec3 bend, vec2 clump, vec3 eye) {
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
  vec3 own = max(albedoOf(seen), 1e-4);
  vec3 light = lightCanopy(laidAlbedo(own, dot(stem, up)), stem, eye, up, at) + contourLift(v.normal, eye, at.sunlit * at.height);
  return light / own;
}

// The canopy where its blades can't be told apart: as the ground far away has it, so that no seam shows.
vec3 litAfar(vec2 root, vec3 eye) {
  float sunlit = smoothstep(-0.15, 0.15, v.size.y - v.shade.x);
  vec3 light = meadowColour(root, v.shade.zw, eye, normalize(v.normal), sunlit) * mix(openHere(), 1.0, 0.5);
  return light * (v.light.z / max(meadowPatch(root).y, 0.1));
}

// Light changes slowly over the ground: it is found at the corners, at the foot and at the top of blades.
void shine(vec3 eye, vec2 clump) {
  ShellSeen seen = ShellSeen(shell.mean.rgb, 1.0, 0.5, kFootAlong, kFootAlong);
  v.footLight = litOver(seen, v.bend, clump, eye);
  seen.height = 0.8;
  seen.along = 1.0;
  v.topLight = litOver(seen, v.bend, clump, eye);
  v.afarLight = litAfar(v.root.xz, eye);
  vec3 ray = v.place - frame.cameraPosition.xyz;
  v.haze = vec4(hazeColour(normalize(ray)), hazeAmount(length(ray)));
}
#endif

// Of a blade seen.
vec3 litBlade(ShellSeen seen) { return albedoOf(seen) * mix(v.footLight, v.topLight, clamp((seen.along - kFootAlong) / (1.0 - kFootAlong), 0.0, 1.0)); }
vec3 hazed(vec3 light) { return mix(light, v.haze.rgb, v.haze.a); }
