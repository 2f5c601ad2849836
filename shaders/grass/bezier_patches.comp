#version 450 core
// Lists the patches of Bezier grass that may be seen: those near enough for large blades, which are drawn first, and the
// others. A thread looks at one.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/occluders.glsl"
#include "shaders/include/bezier_work.glsl"

layout(local_size_x = BEZIER_CULL_GROUP) in;

bool insideFrustum(vec3 centre, vec3 halfSize) {
  for (int i = 0; i < 6; ++i) {
    vec4 plane = frame.frustum[i];
    if (dot(plane.xyz, centre) + plane.w < -dot(abs(plane.xyz), halfSize)) return false;
  }
  return true;
}

void main() {
  uint at = gl_GlobalInvocationID.x;
  if (at >= uint(bezier.patches.x)) return;
  BezierPatch part = patches[at];
  vec3 centre = part.centre.xyz;
  vec3 reach = part.reach.xyz;
  uint blades = min(uint(part.centre.w), uint(bezier.patches.y));
  bool inSight = bezier.patches.w < 0.5 || insideFrustum(centre, reach);
  bool hidden = inSight && bezier.tests.w > 0.5 && isOccluded(centre, reach);
  seen[at] = inSight && !hidden ? 1u : 0u;
  if (!inSight) return;
  atomicAdd(commands.counts[BEZIER_COUNT_IN_PATCHES], blades);
  atomicAdd(commands.counts[BEZIER_COUNT_PATCHES], 1u);
  if (hidden) {
    atomicAdd(commands.counts[BEZIER_COUNT_OCCLUSION], blades);
    return;
  }
  // The nearest place of the box decides: large blades hide others, and none of them may be tested against itself.
  vec3 nearest = clamp(frame.cameraPosition.xyz, centre - reach, centre + reach);
  bool first = isOrthographic() || grass.baseColour.w * pixelsPerMetre(nearest) > bezier.levels.w;
  // Of a patch with smaller blades the first ones hide the others.
  seen[at] = first ? 2u : 1u;
  seen[patchesNear(atomicAdd(commands.groupsNear[0], 1u))] = at;
  if (!first) seen[patchesFar(atomicAdd(commands.groupsFar[0], 1u))] = at;
}
