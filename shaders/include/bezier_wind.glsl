// The wind that a Bezier blade feels. Needs frame.glsl, noise.glsl, wind_field.glsl.
#include "shaders/shared/bezier_physics.h"

layout(std140, binding = RENDER_UBO_BEZIER_PHYSICS) uniform BezierPhysicsUniforms { BezierPhysicsBlock physics; };

// m/s at a root. The simulated wind, with its ripples, and the waves are level; where `up` leans they blow along the surface.
// Rotors are felt whichever of them blows.
vec3 bezierWind(vec3 root, vec3 up) {
  vec3 air = rotorAir(root);
  vec2 level = air.xz;
  if (physics.wind.x > 0.5) level += groupFieldWind(root.xz);
  if (physics.wind.z > 0.0) level = rippledWind(root.xz, level, physics.wind.z);
  if (physics.wind.y > 0.5) {
    for (int i = 0; i < BEZIER_WAVES; ++i) level += bezierWave(physics.waves[i], root.xz);
  }
  vec3 wind = vec3(level.x, 0.0, level.y);
  return wind - up * dot(up, wind) + vec3(0.0, air.y, 0.0);
}
