#version 450 core
// A collider in the meadow's light: a ball sewn of leather, a capsule painted as a shoe, or a mesh as it is.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/object_light.glsl"
#include "shaders/include/scene_output.glsl"

in vec3 objectWorld;
in vec3 objectNormal;
in vec3 objectOwn;
#ifdef MESH
in vec2 objectUv;
in vec4 objectColour;
layout(binding = RENDER_TEXTURE_COLLIDER) uniform sampler2D objectTexture;
uniform float cutoff;  // of alpha
#else
uniform vec2 shape;  // radius and length, m; length 0: a sphere
uniform mat4 world;
#endif

#ifndef MESH
// The panels of a football: faces of a truncated icosahedron, each scored by how far a point lies behind its plane. By
// the mirror symmetry only faces around the positive octant can win there.
struct Panel {
  float inside;   // 0 on the seam, growing inwards
  float pentagon; // 1 in one
  vec3 outwards;  // how the surface falls towards the seam
};

void offer(vec3 at, vec3 face, float pentagon, inout vec4 best, inout vec4 second, inout float kind) {
  // Distances of the planes from the middle, over the corners'.
  float score = dot(at, face) / (length(face) * (pentagon > 0.5 ? 0.93923 : 0.91496));
  if (score > best.w) {
    second = best;
    best = vec4(normalize(face), score);
    kind = pentagon;
  } else if (score > second.w) {
    second = vec4(normalize(face), score);
  }
}

Panel panelAt(vec3 direction) {
  const float kPhi = 1.6180340;
  const float kLow = 0.6180340;
  vec3 at = abs(direction);
  vec4 best = vec4(0.0), second = vec4(0.0);
  float kind = 0.0;
  offer(at, vec3(0.0, 1.0, kPhi), 1.0, best, second, kind);
  offer(at, vec3(1.0, kPhi, 0.0), 1.0, best, second, kind);
  offer(at, vec3(kPhi, 0.0, 1.0), 1.0, best, second, kind);
  offer(at, vec3(1.0, 1.0, 1.0), 0.0, best, second, kind);
  for (float side = -1.0; side < 2.0; side += 2.0) {
    offer(at, vec3(side * kLow, 0.0, kPhi), 0.0, best, second, kind);
    offer(at, vec3(0.0, kPhi, side * kLow), 0.0, best, second, kind);
    offer(at, vec3(kPhi, side * kLow, 0.0), 0.0, best, second, kind);
  }
  return Panel(best.w - second.w, kind, (second.xyz - best.xyz) * mix(vec3(-1.0), vec3(1.0), greaterThanEqual(direction, vec3(0.0))));
}

Surface ballSurface(vec3 n) {
  vec3 direction = normalize(objectOwn);
  Panel panel = panelAt(direction);
  vec4 broad = grain(direction, direction, 1.3);
  vec4 fine = grain(direction + 0.7, direction, 0.31);
  float width = fwidth(panel.inside);
  float seam = 1.0 - smoothstep(0.012 - width, 0.022 + width, panel.inside);
  vec3 cream = mix(vec3(0.60, 0.55, 0.45), vec3(0.40, 0.34, 0.24), smoothstep(0.45, 0.75, broad.r * 0.6 + fine.b * 0.4));
  vec3 red = mix(vec3(0.33, 0.045, 0.03), vec3(0.22, 0.05, 0.035), fine.r);
  Surface surface;
  surface.albedo = mix(cream, red, panel.pentagon) * (0.82 + 0.36 * fine.g);
  // Grass has left its green on the panels' middles, and earth in the seams.
  surface.albedo = mix(surface.albedo, vec3(0.10, 0.12, 0.04), 0.35 * smoothstep(0.52, 0.7, broad.g) * smoothstep(0.05, 0.2, panel.inside));
  surface.albedo *= mix(1.0, 0.22, seam);
  // Panels bulge: the surface falls towards the seams.
  float fall = 0.35 * exp(-panel.inside * 22.0) * (1.0 - smoothstep(0.0, 0.12, width));
  vec3 bulge = panel.outwards * fall + (vec3(fine.r, fine.g, fine.b) - 0.5) * 0.10;
  surface.normal = normalize(n + mat3(world) * bulge);
  surface.gloss = 0.10 * (1.0 - seam) * (0.5 + broad.b);
  return surface;
}

// Rubber sole, pale welt and leather above, with a cap at the toe, laces, and the opening over the heel.
Surface shoeSurface(vec3 n) {
  vec3 at = objectOwn / shape.x;  // in radii
  float halfLength = 0.5 * shape.y / shape.x;
  vec3 side = transpose(mat3(world)) * n;
  vec4 fine = grain(at, side, 0.9);
  vec4 broad = grain(at + 0.7, side, 2.7);
  float width = fwidth(at.y) + 0.02;
  Surface surface;
  vec3 leather = mix(vec3(0.17, 0.075, 0.03), vec3(0.09, 0.04, 0.018), 0.6 * smoothstep(0.35, 0.7, broad.r)) * (0.85 + 0.3 * fine.g);
  float toe = at.x - halfLength;
  float cap = smoothstep(-width, width, toe - 0.12 + 0.25 * at.z * at.z);
  leather *= mix(1.0, 0.72, cap) * (1.0 - 0.55 * (1.0 - smoothstep(0.0, 0.05 + width, abs(toe - 0.12 + 0.25 * at.z * at.z))));
  // Laces over the tongue.
  float tongue = smoothstep(0.0, 0.15, at.y - 0.55) * (1.0 - smoothstep(0.30, 0.36, abs(at.z))) * step(-0.2 * halfLength, at.x) * (1.0 - cap);
  float lace = smoothstep(0.25, 0.45, abs(fract(at.x * 2.6 + 0.45 * abs(at.z)) - 0.5));
  leather = mix(leather, mix(vec3(0.035, 0.02, 0.012), vec3(0.42, 0.38, 0.30), lace), tongue);
  float opening = length(vec2(at.x + halfLength * 0.9, at.z));
  leather = mix(leather, vec3(0.012, 0.010, 0.009), (1.0 - smoothstep(0.55, 0.62, opening)) * step(0.0, at.y));
  leather *= 1.0 + 0.9 * (1.0 - smoothstep(0.0, 0.06, abs(opening - 0.62))) * step(0.0, at.y);
  vec3 rubber = vec3(0.022, 0.021, 0.020) * (0.7 + 0.6 * step(0.5, fract(at.x * 4.0)) + 0.4 * fine.r);
  vec3 welt = vec3(0.33, 0.27, 0.18) * (0.7 + 0.4 * fine.b);
  float line = at.y + 0.42;
  surface.albedo = mix(rubber, mix(welt, leather, smoothstep(-width, width, line - 0.13)), smoothstep(-width, width, line));
  surface.albedo = mix(surface.albedo, vec3(0.10, 0.085, 0.05), 0.5 * smoothstep(0.45, 0.7, broad.g) * smoothstep(0.3, -0.6, at.y));
  surface.normal = normalize(n + mat3(world) * ((vec3(fine.r, fine.g, fine.b) - 0.5) * 0.18));
  surface.gloss = 0.12 * smoothstep(-0.2, 0.1, line) * (0.4 + fine.g);
  return surface;
}
#endif

Surface surfaceHere(vec3 n) {
#ifdef MESH
  vec4 colour = texture(objectTexture, objectUv) * objectColour;
  if (colour.a < cutoff) discard;
  return Surface(colour.rgb, n, 0.03);
#else
  if (shape.y > 0.0) return shoeSurface(n);
  return ballSurface(n);
#endif
}

void main() {
  vec3 v = directionToCamera(objectWorld);
  vec3 n = normalize(objectNormal);
#ifdef MESH
  if (!gl_FrontFacing) n = -n;
#endif
  writeScene(throughAir(objectLight(surfaceHere(n), objectWorld, v), objectWorld));
}
