#version 450 core
// A Bezier blade as a strip of ROWS rows of COLUMNS vertices. An instance is a chunk of blades, the index says which of them
// and which vertex. Jahrmann & Wimmer, 2017, eq. 21-24.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/blade_light.glsl"
#include "shaders/shared/bezier_block.h"
#include "shaders/shared/bezier_pose.h"
#include "shaders/shared/bezier_shape.h"

layout(std140, binding = RENDER_UBO_BEZIER) uniform BezierUniforms { BezierBlock bezier; };
layout(std430, binding = RENDER_SSBO_BEZIER_COMMANDS) readonly buffer Commands { BezierCommands commands; };
layout(std430, binding = RENDER_SSBO_BEZIER_LIST) readonly buffer Lists { uint lists[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_DRAWN) readonly buffer Drawn { BezierDrawn drawn[]; };

out vec3 bladeColour;  // of the picture

#ifdef DANDELION
// Rows of the stalk, then two for each spike.
float along(int row) { return row <= STALK ? BEZIER_HEAD * float(row) / float(STALK) : BEZIER_HEAD + (1.0 - BEZIER_HEAD) * float(row - STALK) / float(ROWS - 1 - STALK); }
float outlineAt(uint form, float u, float v, float width, float height) { return dandelionOutline(u, v, 0.5 * float(ROWS - 1 - STALK), height / max(width, 1e-5)); }
#else
float along(int row) { return float(row) / float(ROWS - 1); }
float outlineAt(uint form, float u, float v, float width, float height) { return bezierOutline(form, u, v, bezier.shape.x); }
#endif

void main() {
  uint code = uint(gl_VertexID);
  uint at = commands.starts[LIST] + uint(gl_InstanceID) * BEZIER_CHUNK + (code >> 6u);
  uint record = at < min(commands.ends[LIST], uint(bezier.view.y)) ? lists[LIST * uint(bezier.view.y) + at] : BEZIER_NO_RECORD;
  if (record == BEZIER_NO_RECORD) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    bladeColour = vec3(0.0);
    return;
  }
  BezierDrawn blade = drawn[record];
  int row = int(code & 63u) / COLUMNS;
  float u = float(int(code & 63u) % COLUMNS) / float(COLUMNS - 1);
  float v = along(row);
  uint form = blade.look >> 24u;
  vec2 sizes = unpackHalf2x16(blade.sizes);
  vec2 curve = unpackHalf2x16(blade.curve);
  vec3 up = octahedralVector(unpackSnorm2x16(blade.up));
  vec3 across = bezierAcross(up, float(blade.growth >> 16u) / 65535.0);
  vec3 middle = up * curve.y;
  vec3 tip = vec3(unpackHalf2x16(blade.tip), curve.x);
  vec3 root = vec3(blade.x, blade.y, blade.z);

  vec3 a = middle * v;
  vec3 b = mix(middle, tip, v);
  vec3 spine = mix(a, b, v);
  vec3 tangent = normalize(b - a + up * 1e-5);
  float perMetre = pixelsPerMetre(root + spine);
  float asQuad = form == BEZIER_FORM_DANDELION ? 0.0 : widthCorrection(sizes.y * perMetre, bezier.shape.z, bezier.shape.w);
  float t = mix(outlineAt(form, u, v, sizes.y, sizes.x), u, asQuad);
#if ROWS == 2
  // The coarsest strip ends in a point; it covers what the form does.
  if (form != BEZIER_FORM_QUAD) t = mix(0.5 + (u - 0.5) * 2.0 * bezierCover(form, bezier.shape.x) * (1.0 - v), u, asQuad);
#endif
  vec3 place = spine + across * ((t - 0.5) * sizes.y);
#if COLUMNS == 3
  vec3 normal = normalize(cross(tangent, across));
  float wide = outlineAt(form, 1.0, v, sizes.y, sizes.x) - outlineAt(form, 0.0, v, sizes.y, sizes.x);
  float tall = sizes.x * perMetre;
  place += normal * (sizes.y * bezier.shape.y * foldDepth(u, v, wide) * smoothstep(bezier.levels.x, 1.5 * bezier.levels.x, tall));
#endif
  vec3 world = root + place;
  gl_Position = frame.viewProjection * vec4(world, 1.0);

  vec3 afar = mix(unpackUnorm4x8(blade.foot).rgb, unpackUnorm4x8(blade.top).rgb, v);
#if ROWS <= 3 || defined(PLAIN)
  bladeColour = afar;
#else
  if (bezier.view.x != BEZIER_VIEW_NORMAL) {
    bladeColour = afar;
    return;
  }
  vec4 light = unpackUnorm4x8(blade.light);
  vec4 tint = unpackUnorm4x8(blade.look);
  vec2 shade = unpackHalf2x16(blade.shade);
  vec3 colour = mapColour(root.xz);
#ifdef DANDELION
  colour = dandelionColour(colour, v);
#endif
  BladeLook look = BladeLook(0u, sizes.x, 2.0 * light.b * sizes.x, light.a, shade.x, shade.y, vec4(tint.r, light.r, tint.b, light.g), up, colour);
  vec3 lit = bladeLight(look, dot(spine, up), tangent, v, across, 2.0 * u - 1.0, directionToCamera(world), up);
  float clear = smoothstep(bezier.levels.y, 2.0 * bezier.levels.y, sizes.x * perMetre);
  bladeColour = mix(afar, toPicture(throughAir(lit, world)), clear);
#endif
}
