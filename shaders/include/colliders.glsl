// The light that colliders and surfaces take from what is around them. Needs frame.glsl.
#include "shaders/shared/collider_shade.h"

layout(std140, binding = RENDER_UBO_COLLIDERS) uniform ColliderUniforms { ColliderShadeBlock colliderShades; };

// Parts of the sun's (x) and the sky's light (y) that reach a point, 0..1: for each sphere its shadow with an edge that
// softens with the distance, and the part of the sky that it covers (the form factor of a sphere, (r / d)^2 cos; a
// blade of grass sees beside it, too, hence the part without the cosine).
vec2 lightPast(vec3 world, int count) {
  vec2 light = vec2(1.0);
  if (any(lessThan(world, colliderShades.low.xyz)) || any(greaterThan(world, colliderShades.high.xyz))) return light;
  for (int i = 0; i < count; ++i) {
    vec3 to = colliderShades.spheres[i].xyz - world;
    float radius = colliderShades.spheres[i].w;
    float distance = max(length(to), radius);
    float covered = radius / distance;
    light.y *= 1.0 - covered * covered * (0.3 + 0.7 * max(to.y / distance, 0.0));
    float ahead = dot(to, frame.sunDirection.xyz);
    float aside = sqrt(max(dot(to, to) - ahead * ahead, 0.0));
    float soft = 0.2 * radius + 0.04 * max(ahead, 0.0);
    float shadow = 1.0 - smoothstep(-soft, soft, aside - radius);
    light.x *= 1.0 - shadow * smoothstep(-0.3 * radius, 0.3 * radius, ahead);
  }
  return max(light, vec2(0.0, 0.12));
}

vec2 colliderLight(vec3 world) { return lightPast(world, int(colliderShades.low.w)); }

float shadeOf(vec2 light) {
  const vec3 kLuma = vec3(0.2126, 0.7152, 0.0722);
  float sun = dot(frame.sunColour.rgb, kLuma) * max(frame.sunDirection.y, 0.0);
  float sky = dot(frame.skyColour.rgb, kLuma);
  return (sun * light.x + sky * light.y) / max(sun + sky, 1e-6);
}

// The same as one factor for what lies level, 1 in the open.
float colliderShade(vec3 world) { return shadeOf(colliderLight(world)); }

// For what is a part of a surface, and would take its own light: only colliders count.
float colliderShadeOnSurface(vec3 world) { return shadeOf(lightPast(world, int(colliderShades.high.w))); }
