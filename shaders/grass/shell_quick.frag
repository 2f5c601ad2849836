#version 450 core
// As shell.frag, for software renderers: one sample a pixel, the nearest texels, light from the corners.
#include "shaders/include/frame.glsl"
#include "shaders/shared/shell_block.h"

layout(std140, binding = RENDER_UBO_SHELL) uniform ShellUniforms { ShellBlock shell; };
layout(binding = RENDER_TEXTURE_SHELL_FORM) uniform sampler2D shellForm;
layout(binding = RENDER_TEXTURE_SHELL_COLOUR) uniform sampler2D shellColour;

in vec4 walkAlong;
in vec4 walkLean;
in vec4 footFade;
in vec4 tipAfar;
in vec3 afarColour;
flat in vec3 heights;
flat in vec2 codes;  // of heights as the texture has them: of the shell below and of this one
layout(location = 0) out vec4 sceneColour;

const float kStrideTexels = 2.0;  // from one look to the next

void main() {
  float level = walkLean.z;
  float texels = length(walkAlong.zw) * shell.size.z / shell.size.y * exp2(-level) / kStrideTexels;
  float steps = clamp(ceil(texels), 1.0, shell.look.x);
  // Between looks larger texels would stand in, but those make bushes of blades: rather some are missed.
  level = floor(max(level, level + 0.25 * log2(max(texels / steps, 1e-3))) + 0.5);
  float part = 1.0 / steps;
  vec2 stride = walkAlong.zw * part;
  vec2 place = walkAlong.xy + 0.5 * stride;
  float drop = (heights.y - heights.x) * part;
  float low = heights.y - drop;
  float codeDrop = (codes.y - codes.x) * part;
  float cut = codes.y - codeDrop;
  vec4 form = vec4(0.0);
  bool hit = false;
  for (float i = 0.0; i < steps; i += 1.0) {
    vec2 at = place - walkLean.xy * (low * low);
    form = textureLod(shellForm, at, level);
    if (form.r > cut && form.r > 0.01 && form.b <= walkLean.w) {
      hit = true;
      place = at;
      break;
    }
    place += stride;
    low -= drop;
    cut -= codeDrop;
  }
  float afar = tipAfar.w;
  // The lowest shell shows what is between the blades as well, and from afar all of it is covered: the ground is dearer.
  bool lowest = heights.x <= 0.0;
  if ((!hit && !lowest && afar < 0.5) || walkLean.w <= 0.0) discard;
  float along = clamp((cut + codeDrop) / max(form.g, 0.05), 0.0, 1.0);
  vec3 tint = sqrt(textureLod(shellColour, place, level).rgb / max(shell.mean.rgb, 1e-3));
  vec3 near = hit ? mix(footFade.rgb, tipAfar.rgb, along * along * (3.0 - 2.0 * along)) * tint : footFade.rgb * 0.7;
  sceneColour = vec4(mix(near, afarColour * (0.9 + 0.2 * form.a), max(afar, 1.0 - footFade.w)), 1.0);
}
