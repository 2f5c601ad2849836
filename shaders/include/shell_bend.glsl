// How far shell grass leans, and where a shell stands. Needs frame.glsl, noise.glsl, wind_field.glsl.
#include "shaders/shared/shell_block.h"
#include "shaders/shared/shell_bend.h"

layout(std140, binding = RENDER_UBO_SHELL) uniform ShellUniforms { ShellBlock shell; };
layout(binding = RENDER_TEXTURE_SHELL_OFFSETS) uniform sampler2D shellOffsets;

vec3 alongSurface(vec3 v, vec3 up) { return v - up * dot(up, v); }

vec3 boundedBend(vec3 bend) { return bend * min(1.0, shell.bend.y / max(length(bend), 1e-5)); }

// Direction times wind intensity at a root: eq. for V_w of Bakay and others 2002 with W from the field, rotors, and the paper's source.
// `softness`: over the meadow's own.
vec3 shellBend(vec3 root, vec3 up, float softness) {
  vec3 air = rotorAir(root);
  if (shell.rings.z > 0.5) air.xz = rippledWind(root.xz, air.xz + fieldWind(root.xz), shell.bend.w);
  vec3 wind = alongSurface(air, up);
  float speed = length(wind);
  vec3 bend = wind * (shellIntensity(speed * shell.bend.x * softness, shell.bend.y) / max(speed, 1e-5));
  if (shell.source.z > 0.0) {
    vec2 from = root.xz - shell.source.xy;
    vec3 away = alongSurface(vec3(from.x, 0.0, from.y), up);
    bend += away * (shellSourceIntensity(length(from), frame.viewForward.w, shell.source.z, shell.source.w, shell.rings.x, shell.rings.y) / max(length(away), 1e-4));
  }
  return boundedBend(bend);
}

// n_i - n_0 and w_i - w_0 of segment `end` in heights of the blade.
vec2 shellOffsetAt(uint end, float intensity) {
  float at = min(intensity / shell.bend.y, 1.0) * (shell.table.y - 1.0);
  int row = min(int(at), int(shell.table.y) - 2);
  return mix(texelFetch(shellOffsets, ivec2(end, row), 0).rg, texelFetch(shellOffsets, ivec2(end, row + 1), 0).rg, at - float(row));
}

// The same in the world, m from the root.
vec3 shellOffset(uint end, vec3 bend, vec3 up, float height) {
  float intensity = length(bend);
  vec2 offset = shellOffsetAt(end, intensity) * height;
  return up * offset.x + bend * (offset.y / max(intensity, 1e-5));
}

// Where a root of the ground lies in the texture, m: wandering a little, so that its repeats don't line up.
vec2 wandered(vec2 root) {
  return root + vec2(1.3 * sin(0.11 * root.y) + 0.6 * sin(0.17 * root.x + 0.23 * root.y), 1.2 * sin(0.12 * root.x + 1.0) + 0.6 * sin(0.19 * root.y - 0.21 * root.x));
}
