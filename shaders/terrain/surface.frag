#version 450 core
// Earth or skin between the blades of a surface, in the meadow's light. Seen from both sides.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/object_light.glsl"
#include "shaders/include/scene_output.glsl"
#include "shaders/include/colliders.glsl"

in vec3 surfaceWorld;
in vec3 surfaceNormal;
uniform vec3 surfaceColour;  // linear

void main() {
  vec3 n = normalize(surfaceNormal);
  if (!gl_FrontFacing) n = -n;
  vec4 broad = grain(surfaceWorld, n, 3.1);
  vec4 fine = grain(surfaceWorld + 0.7, n, 0.43);
  Surface surface;
  surface.albedo = surfaceColour * (0.55 + 0.5 * broad.r + 0.4 * fine.b);
  surface.normal = normalize(n + (vec3(fine.r, fine.g, broad.g) - 0.5) * 0.3);
  surface.gloss = 0.0;
  vec3 light = objectLight(surface, surfaceWorld, directionToCamera(surfaceWorld));
  writeScene(throughAir(light * colliderShadeOnSurface(surfaceWorld), surfaceWorld));
}
