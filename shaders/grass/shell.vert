#version 450 core
// A piece of a shell of grass: a tile of the ground's lattice, or a surface (SURFACE), moved out along the grass and along the wind.
// Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002, section 3. What light and wind are at a root is found here, once for
// all that is seen between the corners.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/colliders.glsl"
#include "shaders/include/grass_blades.glsl"
#include "shaders/include/shell_bend.glsl"
#include "shaders/include/shell_vertex.glsl"

layout(std430, binding = RENDER_SSBO_SHELL_INSTANCES) readonly buffer Instances { ShellInstance instances[]; };
uniform int firstInstance;
#ifdef SURFACE
uniform mat4 world;      // from its own metres
uniform vec4 surface;    // x height of its blades over the meadow's; y their softness over the meadow's; z part of the blades that grow; w scale of its mesh
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#else
uniform int quads;       // along a tile's side
#endif

#ifdef QUICK
struct ShellVertex { SHELL_VERTEX_MEMBERS };
ShellVertex v;
out vec4 walkAlong;  // where in the texture the ray begins, and its way to the shell below
out vec4 walkLean;   // xy of blades in still air at the tip, squares of the texture; z its level; w part of the blades that grow
out vec4 footFade;   // rgb of the picture at the foot; w how far grass has become the ground's shading
out vec4 tipAfar;    // rgb at the tip; w how far blades can't be told apart
out vec3 afarColour; // of the picture, where they can't
#else
out ShellVertex { SHELL_VERTEX_MEMBERS } v;
#endif
flat out vec3 heights;  // of the shell below, this one, the one above, 0..1
#ifdef QUICK
flat out vec2 codes;    // as the texture has them
#endif

#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/include/shell_light.glsl"

#ifdef QUICK
// For a software renderer: the ray's way and the colours of the picture are found at the corners, too.
void quicken(vec3 eye, vec2 clump, float perMetre) {
  float facing = min(-dot(eye, v.normal), -0.02);
  vec3 along = -eye * (max(dot(v.below, v.normal), 0.0) / -facing) + v.below;
  float level = clamp(log2(shell.size.z / perMetre) + kBlur, 0.0, shell.size.w);
  vec2 from = wandered(v.own.xz);
  walkAlong = vec4(from, wandered(v.own.xz + along.xz) - from) * shell.size.y;
  walkLean = vec4(clump * (v.size.x * shell.size.y), level, v.shade.y < 0.0 ? 0.0 : v.light.x);
  vec3 tint = mapColour(v.root.xz);
  footFade = vec4(toPicture(hazed(litBlade(ShellSeen(shell.mean.rgb, 1.0, 0.5, kFootAlong, kFootAlong)) * tint)), standing(v.size.x * perMetre));
  tipAfar = vec4(toPicture(hazed(litBlade(ShellSeen(shell.mean.rgb, 1.0, 0.5, 0.8, 1.0)) * tint)), farness(perMetre));
  afarColour = toPicture(hazed(v.afarLight * tint));
}
#endif

// Grass beside a collider gives way: direction and intensity, and in w the room that is left under it, m.
vec4 pressed(vec3 root, vec3 up, float height) {
  vec4 push = vec4(0.0, 0.0, 0.0, height);
  int count = int(colliderShades.high.w);
  for (int i = 0; i < count; ++i) {
    vec3 from = root - colliderShades.spheres[i].xyz;
    float radius = colliderShades.spheres[i].w;
    float above = -dot(from, up) - radius;
    vec3 aside = alongSurface(from, up);
    float away = length(aside);
    if (above > height || away > radius + height) continue;
    float under = -dot(from, up) - sqrt(max(radius * radius - away * away, 0.0));
    push.w = min(push.w, away < radius ? max(under, 0.08 * height) : height);
    push.xyz += aside / max(away, 1e-3) * (1.0 - smoothstep(0.6 * radius, radius + 0.6 * height, away)) * (1.0 - smoothstep(0.0, max(height, 1e-4), above));
  }
  return push;
}

#ifndef SURFACE
vec2 latticePlace(ShellInstance tile, float quad) {
  ivec2 at = ivec2(gl_VertexID % (quads + 1), gl_VertexID / (quads + 1));
  vec2 place = vec2(tile.x, tile.z) + vec2(at) * quad;
  vec3 ground = vec3(place.x, groundHeight(place), place.y);
  float away = isOrthographic() ? shell.look.w : distance(ground, frame.cameraPosition.xyz);
  float reach = SHELL_TILE_REACH * tile.side;
  float coarser = clamp((away / reach - SHELL_MORPH_BEGIN) / (1.0 - SHELL_MORPH_BEGIN), 0.0, 1.0);
  return place - vec2(at & 1) * (quad * coarser);
}
#endif

void main() {
  ShellInstance instance = instances[firstInstance + gl_InstanceID];
  uint lower = instance.ends & 255u, end = instance.ends >> 8u & 255u, upper = instance.ends >> 16u & 255u;
  float height = shell.size.x;
  float margin = 0.0;
#ifdef SURFACE
  v.root = (world * vec4(position, 1.0)).xyz;
  v.own = position * surface.w / surface.x;
  v.normal = normalize(mat3(world) * normal) * instance.x;
  v.up = v.normal;
  height *= surface.x;
  float softness = surface.y;
  float grown = surface.z;
  vec2 broad = vec2(0.0, 1.0);
  float sunwards = dot(v.normal, frame.sunDirection.xyz);
  v.shade.xy = vec2(mix(2.0, -2.0, smoothstep(-0.12, 0.2, sunwards)) * height, 1e3);
  float shaded = colliderShadeOnSurface(v.root + 0.5 * height * v.up);
  float share = 1.0;
#else
  const float softness = 1.0;
  vec2 place = latticePlace(instance, instance.side / float(quads));
  v.root = vec3(place.x, groundHeight(place), place.y);
  v.own = v.root;
  GroundLight ground = groundLight(place, 0.0);
  v.normal = ground.normal;
  v.up = normalize(mix(vec3(0.0, 1.0, 0.0), v.normal, grass.ground.x));
  // Blades in the margin get fewer and lower.
  margin = inMargin(place);
  float share = mapHeight(place) * mix(1.0, 0.3, smoothstep(0.0, 0.8, beyondField(place) / grass.tileCentre.z));
  float tufts = noiseAtLevel(place, 11.0, 1.0).b + noiseAtLevel(place.yx, 4.3, 1.0).r - 1.0;
  height *= share * (1.0 + 0.3 * grass.size.z * tufts);
  float grown = mapDensity(place) * slopeDensity(v.normal) * clamp(1.0 - margin, 0.0, 1.0) * shell.root.w;
  vec2 broad = meadowPatch(place);
  SolidsNear solids = solidsNear(place);
  v.shade.xy = vec2(max(solids.shadowHeight, softened(ground.shadowHeight)), solids.distanceM);
  float shaded = colliderShade(v.root + vec3(0.0, 0.5 * height, 0.0));
#endif
  v.bend = shellBend(v.root, v.up, softness);
  vec4 push = pressed(v.root, v.up, height);
  height = min(height, push.w);
  v.push = push.xyz;
  v.bend = boundedBend(v.bend + v.push);
  vec3 own = shellOffset(end, v.bend, v.up, height);
  v.below = own - shellOffset(lower, v.bend, v.up, height);
  v.above = shellOffset(upper, v.bend, v.up, height) - own;
  v.place = v.root + own;
  v.size = vec3(height, dot(own, v.up), share);
  float sunlit = smoothstep(-0.15, 0.15, 0.3 * height - v.shade.x);
  v.shade.zw = smoothWind(v.root.xz);
  v.light = vec4(grown, broad.x, broad.y * slopeLight(v.normal, sunlit) * shaded, shadeForce(length(v.shade.zw)));
  heights = vec3(float(lower), float(end), float(upper)) / shell.table.x;
  vec3 eye = directionToCamera(v.place);
  float perMetre = pixelsPerMetre(v.place);
#ifdef SURFACE
  vec2 clump = clumpLean(v.own.xz * shell.size.y, perMetre * surface.x);
#else
  vec2 clump = clumpLean(wandered(v.own.xz) * shell.size.y, perMetre);
#endif
  shine(eye, clump);
#ifdef QUICK
  codes = vec2(shellAlphaOf(heights.x, shell.table.z), shellAlphaOf(heights.y, shell.table.z));
  quicken(eye, clump, perMetre);
#endif
  gl_Position = frame.viewProjection * vec4(v.place, 1.0);
  // Blades that lie flat bring shells together: the upper one is seen.
  gl_Position.z -= 4e-6 * heights.y * gl_Position.w;
}
