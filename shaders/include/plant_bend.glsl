// What bends a plant that isn't a blade: wind, its own spring, and what touches it. Needs frame.glsl, noise.glsl,
// wind_field.glsl, meadow.glsl, virtual_wind.glsl.
#include "shaders/shared/collider.h"

layout(std430, binding = RENDER_SSBO_PLANT_TOUCHING) readonly buffer Touching { ColliderPrimitive touching[]; };
uniform int touchCount;
uniform vec4 touchBounds;  // low and high x, z of all that touches, with its reach, m

// Outwards from the nearest thing that reaches into a plant: direction times how far it must give way, 0..1. A plant
// has no memory: it follows the thing, and rises as it leaves.
vec2 pushedAside(vec3 root, float height) {
  vec2 push = vec2(0.0);
  if (any(lessThan(root.xz, touchBounds.xy)) || any(greaterThan(root.xz, touchBounds.zw))) return push;
  float most = 0.0;
  for (int i = 0; i < touchCount; ++i) {
    vec3 axis = colliderAxis(touching[i], root + vec3(0.0, 0.5 * height, 0.0));
    float radius = touching[i].a.w;
    vec2 away = root.xz - axis.xz;
    float gap = axis.y - radius - root.y;
    float near = 1.0 - smoothstep(0.7 * radius, radius + 0.4 * height, length(away));
    near *= 1.0 - smoothstep(0.2 * height, height, gap);
    if (near <= most) continue;
    most = near;
    push = near * away / max(length(away), 1e-4);
  }
  return push;
}

// Its bend: direction times angle of the tip, rad. `felt` is the wind at its root with its ripples, `factor` F over its
// own stiffness, s/m; `phase` in 0..1 is its own.
vec2 plantPose(vec3 root, float height, vec2 felt, float factor, float phase, float flutter) {
  float lean = 6.2831853 * phase;
  vec2 rest = vec2(cos(lean), sin(lean)) * (0.03 + 0.16 * fract(7.31 * phase));
  vec2 bend = arcSteadyBend(rest, felt, factor);
  if (grass.size.w == GRASS_DEFORMATION_INERTIAL) bend = rest + virtualLeans(root.xz, rest, factor).e[CHAIN_SEGMENTS - 1];
  bend += 0.6 * arcFlutter(felt, frame.viewForward.w, phase, 0.6 + 0.4 * fract(3.7 * phase), flutter);
  vec2 push = pushedAside(root, height);
  bend = mix(bend, 1.45 * push / max(length(push), 1e-4), length(push));
  return bend * min(1.0, 1.5 / max(length(bend), 1e-4));
}
