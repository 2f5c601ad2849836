// The wind that a Bezier blade feels. Needs frame.glsl, noise.glsl, wind_field.glsl.
#include "shaders/shared/bezier_physics.h"

layout(std140, binding = RENDER_UBO_BEZIER_PHYSICS) uniform BezierPhysicsUniforms { BezierPhysicsBlock physics; };

// m/s at a root. The simulated wind is level; where `up` leans it blows along the surface.
vec3 bezierWind(vec3 root, vec3 up) {
  vec2 level = vec2(0.0);
  if (physics.wind.x > 0.5) level += rippledWind(root.xz, groupWind(root.xz), physics.wind.z);
  if (physics.wind.y > 0.5) {
    for (int i = 0; i < BEZIER_WAVES; ++i) level += bezierWave(physics.waves[i], root.xz);
  }
  vec3 wind = vec3(level.x, 0.0, level.y);
  return wind - up * dot(up, wind);
}
