#version 450 core
// A plant's mesh: turned, grown, bent by the wind, lit at its vertices.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/colliders.glsl"
#include "shaders/include/plant_pose.glsl"
#include "shaders/shared/plant_block.h"

layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec2 meshUv;
layout(location = 3) in vec4 meshColour;
layout(location = 4) in vec3 root;
layout(location = 5) in uint sizes;
layout(location = 6) in uvec4 stance;  // bend, turn, tilt, shade
layout(location = 7) in uvec3 look;    // tint, felt, canopy

layout(std430, binding = RENDER_SSBO_PLANT_KINDS) readonly buffer Kinds { PlantKind kinds[]; };
uniform int species;

#ifdef TEXTURED
out vec2 plantUv;
out vec4 plantAlbedo;
out vec3 plantLight;
out vec3 plantGloss;
out vec4 plantHaze;  // its colour and part
#else
out vec3 plantPicture;
#endif

// The rotation that brings +y to `up`.
vec3 tilted(vec3 at, vec3 up) {
  vec3 axis = vec3(up.z, 0.0, -up.x);
  return at * up.y + cross(axis, at) + axis * (dot(axis, at) / (1.0 + up.y));
}

// Leaves and petals are thin: light on their far side shines through, in their own colour.
vec3 thinLight(vec3 n, vec3 v, float petal, float sun, float sky, float canopy) {
  vec3 l = frame.sunDirection.xyz;
  float nl = dot(n, l);
  vec3 through = mix(vec3(1.05, 0.95, 0.36), vec3(0.80, 0.74, 0.68), petal);
  float forward = pow(max(dot(v, -l), 0.0), 4.0);
  float wrap = mix(0.12, 0.28, petal);
  vec3 direct = vec3(max((nl + wrap) / (1.0 + wrap), 0.0)) + through * max(-nl, 0.0) * (0.6 + 0.7 * forward);
  vec3 open = frame.skyColour.rgb * sky * skyInCanopy(canopy) * (0.75 + 0.25 * n.y);
  vec3 bounce = frame.sunColour.rgb * grass.tipColour.rgb * 0.08 * (1.0 - 0.5 * n.y);
  return frame.sunColour.rgb * sun * direct + open + bounce;
}

void main() {
  PlantKind kind = kinds[species];
  bool flower = kind.tint.w > 0.5;
  float petal = flower ? meshUv.x : 0.0;
  vec2 size = unpackHalf2x16(sizes);
  vec2 turn = unpackSnorm2x16(stance.y);
  vec4 tint = unpackUnorm4x8(look.x);
  vec2 felt = unpackHalf2x16(look.y);
  vec2 canopySlope = unpackHalf2x16(look.z);
  vec2 shade = unpackHalf2x16(stance.w);
  float scale = kind.size.z * size.x;
  float height = kind.size.x * size.x;

  vec3 local = meshPosition * scale;
  vec3 normal = meshNormal;
  local.xz *= size.y;
  local.xz = vec2(turn.x * local.x - turn.y * local.z, turn.y * local.x + turn.x * local.z);
  normal.xz = vec2(turn.x * normal.x - turn.y * normal.z, turn.y * normal.x + turn.x * normal.z);

  // Petals and leaf tips tremble; a mesh's outer parts do a little.
  float free = flower ? meshUv.y : 0.25 * clamp(meshPosition.y * scale / height, 0.0, 1.0);
  float speed = length(felt);
  float tremble = free * kind.motion.z * height * 0.022 * speed / (speed + 4.0);
  float beat = frame.viewForward.w * 14.0 + 6.2831853 * tint.a + dot(meshPosition, vec3(31.0, 17.0, 23.0));
  local += tremble * vec3(sin(beat), sin(1.31 * beat + 1.0), cos(0.87 * beat));

  PlantPoint point = posed(local, normal, height, unpackHalf2x16(stance.x));
  vec2 lean = unpackSnorm2x16(stance.z);
  vec3 up = vec3(lean.x, sqrt(max(1.0 - dot(lean, lean), 0.01)), lean.y);
  vec3 world = root + tilted(point.position, up);
  vec3 n = normalize(tilted(point.normal, up));
  vec3 v = directionToCamera(world);
  if (dot(n, v) < 0.0) n = -n;

  float canopy = clamp(point.position.y / max(canopySlope.x, 0.05), 0.0, 1.0);
  float sunlit = smoothstep(-0.15, 0.15, point.position.y - shade.x);
  vec2 shaded = colliderLight(world);
  float sun = sunInCanopy(canopy, grass.levels.z) * sunlit * shaded.x;
  float low = heightWindShade(point.position.y / max(canopySlope.x, 0.05), shade.y) * mix(tint.b, 1.0, 0.5 * canopy);
  vec3 light = thinLight(n, v, petal, sun, shaded.y, canopy) * mix(low, 1.0, petal) * canopySlope.y;
  vec3 h = normalize(v + frame.sunDirection.xyz);
  vec3 gloss = frame.sunColour.rgb * (mix(0.018, 0.03, petal) * pow(max(dot(n, h), 0.0), 12.0) * sun);

  float hue = 2.0 * tint.g - 1.0;
  vec3 vary = vec3(1.0) + hue * mix(vec3(0.14, 0.03, -0.12), vec3(0.05, -0.02, -0.05), petal);
  vec3 albedo = meshColour.rgb * kind.tint.rgb * vary * mix(2.0 * tint.r, 1.0, 0.6 * petal);
  albedo = mix(albedo * mapColour(root.xz), albedo, petal);
  vec3 ray = world - frame.cameraPosition.xyz;
  vec4 haze = vec4(hazeColour(normalize(ray)), hazeAmount(length(ray)));
#ifdef TEXTURED
  plantAlbedo = vec4(albedo, meshColour.a);
  plantUv = meshUv;
  plantLight = light;
  plantGloss = gloss;
  plantHaze = haze;
#else
  plantPicture = toPicture(mix(albedo * light + gloss, haze.rgb, haze.a));
#endif
  gl_Position = frame.viewProjection * vec4(world, 1.0);
}
