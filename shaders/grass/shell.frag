#version 450 core
// What is seen of the grass between a shell and the next one: the ray runs through the cuts of the texture from here down to the shell
// below (from below: up to the one above), so that no slices show. SLICES: the paper's, only the cut at the shell itself.
// Bakay, Lalonde & Heidrich, 2002.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/scene_output.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/shell_bend.glsl"
#include "shaders/include/shell_vertex.glsl"

layout(binding = RENDER_TEXTURE_SHELL_FORM) uniform sampler2D shellForm;
layout(binding = RENDER_TEXTURE_SHELL_COLOUR) uniform sampler2D shellColour;
#ifdef SURFACE
uniform mat3 toOwn;    // from the world to the surface's own axes
uniform vec4 surface;  // as in shell.vert
#endif

in ShellVertex { SHELL_VERTEX_MEMBERS } v;
flat in vec3 heights;

#define FRAGMENT
#include "shaders/include/shell_light.glsl"

const float kSharpness = 5.0;
// Texels of the level that is read from one look to the next.
const float kStrideTexels = 3.0;
// How far a ray is followed between two shells, over the height of the blades.
#ifdef SURFACE
const float kLongestWalk = 1.5;
#else
const float kLongestWalk = 10.0;
#endif
// How much less deep blades are seen for each level of the texture.
const float kHiddenALevel = 0.05;

// The slab between two shells where the ray meets it.
struct Slab {
  vec3 own, root;     // as ShellVertex
  vec3 below, above;
  vec3 bend;
};

#ifdef TEXEL
// With the wind at the root itself, where the corners' would be too coarse.
Slab slabHere() {
#ifdef SURFACE
  float softness = surface.y;
#else
  const float softness = 1.0;
#endif
  vec3 up = normalize(v.up);
  uvec3 ends = uvec3(heights * shell.table.x + 0.5);
  Slab slab;
  slab.bend = boundedBend(shellBend(v.root, up, softness) + v.push);
  vec3 own = shellOffset(ends.y, slab.bend, up, v.size.x);
  // The shell stays where it is: another root leans to here.
  vec3 shift = v.place - v.root - own;
  slab.root = v.root + shift;
#ifdef SURFACE
  slab.own = v.own + toOwn * shift / surface.x;
#else
  slab.own = v.own + shift;
#endif
  slab.below = own - shellOffset(ends.x, slab.bend, up, v.size.x);
  slab.above = shellOffset(ends.z, slab.bend, up, v.size.x) - own;
  return slab;
}
#else
Slab slabHere() { return Slab(v.own, v.root, v.below, v.above, v.bend); }
#endif

// Where the ray is in the texture, and how high over the root of what it meets.
struct Walk {
  vec2 from, along;      // squares of the texture
  float high, low;       // heights at its upper and its lower end, 0..1
  bool down;             // it begins at the upper end
  float pixels;          // that the slab is high on the screen
  vec2 lean, leanEnd;    // of blades in still air at the tip, where it begins and where it ends, squares of the texture
};

#ifdef SURFACE
// The texture lies on the surface from the side that it faces most.
vec2 onTexture(vec3 own, vec3 facing) {
  vec3 part = abs(facing);
  return part.y >= max(part.x, part.z) ? own.xz : part.x > part.z ? own.zy : own.xy;
}
#endif

Walk walkOf(Slab at, vec3 ray, float perMetre) {
  vec3 n = normalize(v.normal);
  float facing = dot(ray, n);
  Walk walk;
  walk.down = facing < 0.0;
  vec3 slab = walk.down ? at.below : at.above;
  walk.pixels = length(cross(slab, ray)) * pixelsPerMetre(v.place);
  // Blades that cross the slab at the root they begin with: the ray's way over the ground less the blades'.
  vec3 along = ray * (max(dot(slab, n), 0.0) / max(abs(facing), 1e-3)) + (walk.down ? slab : -slab);
#ifdef SURFACE
  vec3 side = toOwn * n;
  walk.from = onTexture(at.own, side) * shell.size.y;
  walk.along = onTexture(toOwn * along / surface.x, side) * shell.size.y;
#else
  walk.from = wandered(at.own.xz) * shell.size.y;
  walk.along = wandered(at.own.xz + along.xz) * shell.size.y - walk.from;
#endif
  walk.high = walk.down ? heights.y : heights.z;
  walk.low = walk.down ? heights.x : heights.y;
  // Along an outline the ray would run on and on over ground that in truth bends away.
  float reach = min(kLongestWalk * v.size.x / max(length(along), 1e-4), 1.0);
  walk.along *= reach;
  if (walk.down) {
    walk.low = mix(walk.high, walk.low, reach);
  } else {
    walk.high = mix(walk.low, walk.high, reach);
  }
  float tip = v.size.x * shell.size.y;
  walk.lean = clumpLean(walk.from, perMetre) * tip;
  walk.leanEnd = clumpLean(walk.from + walk.along, perMetre) * tip;
  return walk;
}

float codeOf(float height) { return 1.0 - pow(max(1.0 - height, 0.0), 1.0 / shell.table.z); }
float heightOf(float code) { return 1.0 - pow(1.0 - code, shell.table.z); }

struct Hit {
  float cover;   // 0..1
  float height;  // 0..1 of the tallest
  vec4 form;     // of the texture
  vec2 place;    // in it
};

// Part of a pixel that a texel covers which is `code` high, cut at `cut`: an edge is about a pixel wide, however large texels are.
float covered(float code, float cut, float sharpness) { return clamp((code - cut) * sharpness + 0.5, 0.0, 1.0) * step(0.004, code); }

#ifdef SLICES
Hit walked(Walk walk, float level, float grown) {
  vec2 place = walk.from - walk.lean * (heights.y * heights.y);
  vec4 form = textureLod(shellForm, place, level);
  float a = covered(form.r, codeOf(heights.y), max(exp2(-level), 1.0) * kSharpness) * step(form.b, grown);
  return Hit(a, heights.y, form, place);
}
#else
// Looks where the paper's shells would be, one for each segment of a blade: more often where the ray runs far over the ground between
// two of them, less often where they are closer than texels.
Hit walked(Walk walk, float level, float grown) {
  float texels = length(walk.along) * shell.size.z / shell.size.y;
  float segments = (walk.high - walk.low) * shell.table.x;
  float wanted = max(texels * exp2(-max(level, 0.0)) / kStrideTexels, walk.pixels);
  float steps = shell.table.w > 0.5 ? segments : clamp(segments * exp2(ceil(log2(max(wanted, 1e-3) / segments))), 1.0, shell.look.x);
  // Where the way is too long for so many steps they cover larger texels.
  if (shell.table.w < 0.5) level = max(level, log2(max(texels / (steps * kStrideTexels), 1e-3)));
  float sharpness = max(exp2(-level), 1.0) * kSharpness;
  Hit hit = Hit(0.0, 0.0, vec4(0.5), walk.from);
  float best = 0.0;
  float clear = 1.0;
  for (float i = 0.0; i < steps; i += 1.0) {
    float part = i / steps;
    float height = walk.down ? mix(walk.high, walk.low, part) : mix(walk.low, walk.high, part);
    vec2 place = walk.from + walk.along * part - mix(walk.lean, walk.leanEnd, part) * (height * height);
    vec4 form = textureLod(shellForm, place, level);
    float a = covered(form.r, codeOf(height), sharpness) * step(form.b, grown) * clear;
    hit.height += a * height;
    if (a > best) {
      best = a;
      hit.form = form;
      hit.place = place;
    }
    clear -= a;
    if (clear < 0.05) break;
  }
  hit.cover = 1.0 - clear;
  hit.height /= max(hit.cover, 1e-4);
  return hit;
}
#endif

// Its light, with what is left of it where blades can't be told apart.
vec3 litHit(Hit hit, Slab slab, float level, float afar) {
  vec4 texel = textureLod(shellColour, hit.place, level);
  float along = clamp(hit.height / max(heightOf(hit.form.g), 1e-3), 0.0, 1.0);
  // Coarser levels keep what blades cover, but a few broad ones hide less of what is behind them than many narrow ones.
  along = 1.0 - (1.0 - along) * (1.0 - kHiddenALevel * clamp(level - kBlur, 0.0, 4.0));
#ifdef SURFACE
  along = mix(along, 1.0, 0.8 * afar);
#endif
  vec3 light = litBlade(ShellSeen(texel.rgb, texel.a, hit.form.a, hit.height, along));
#ifndef SURFACE
  if (afar > 0.0) {
    vec4 fine = noiseAt(slab.root.xz, 1.9), mid = noiseAt(slab.root.zx, 8.3);
    float grain = 1.0 + 0.35 * (mid.a + fine.b - 1.0) + 0.5 * (hit.form.a - 0.5);
    light = mix(light, v.afarLight * grain, afar);
  }
  light *= mapColour(slab.root.xz);
#endif
  return light;
}

void main() {
  vec3 eye = directionToCamera(v.place);
  float perMetre = pixelsPerMetre(v.place);
#ifdef SURFACE
  perMetre *= surface.x;  // of the texture
#endif
  float level = min(log2(shell.size.z / perMetre) + kBlur, shell.size.w);
  Slab slab = slabHere();
  Walk walk = walkOf(slab, -eye, perMetre);
  // Nothing grows in solids.
#ifndef SLICES
  if (walk.high <= walk.low) discard;
#endif
  if (v.shade.y < 0.0) discard;
  Hit hit = walked(walk, level, v.light.x);
  float afar = farness(perMetre);
#ifdef SURFACE
  const float all = 1.0;
  // Outlines stay those of blades.
  afar *= smoothstep(0.1, 0.5, abs(dot(normalize(v.normal), eye)));
#else
  float all = max(shell.root.w, 1e-3);
#endif
#ifndef SLICES
  hit.cover = mix(hit.cover, min(v.light.x / all, 1.0), afar);
#endif
#ifndef SURFACE
  hit.cover *= standing(v.size.x * perMetre);
#endif
#ifdef ONE_SAMPLE
  if (hit.cover < 0.5) discard;
#else
  float samples = shell.look.z;
  int count = int(hit.cover * samples + 0.5);
  if (count <= 0) discard;
  // Other samples for each shell, so that what two half cover is not the same half.
  uint turn = (uint(heights.y * shell.table.x + 0.5) * 5u >> 1u) % uint(samples);
  uint bits = (1u << uint(count)) - 1u;
  gl_SampleMask[0] = count >= int(samples) ? -1 : int((bits << turn | bits >> (uint(samples) - turn)) & ((1u << uint(samples)) - 1u));
#endif
  writeScene(hazed(litHit(hit, slab, level, afar)));
}
