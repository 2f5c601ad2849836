#version 450 core
// Finds the patches of Bezier grass that may be seen, and counts them by distance. A thread looks at one.
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
  uint blades = shownBlades(part);
  bool inSight = bezier.patches.w < 0.5 || insideFrustum(centre, reach);
  bool hidden = inSight && bezier.tests.w > 0.5 && isOccluded(centre, reach);
  seen[at] = 0u;
  if (!inSight) return;
  atomicAdd(commands.counts[BEZIER_COUNT_IN_PATCHES], blades);
  atomicAdd(commands.counts[BEZIER_COUNT_PATCHES], 1u);
  if (hidden) {
    atomicAdd(commands.counts[BEZIER_COUNT_OCCLUSION], blades);
    return;
  }
  // The nearest place of the box decides, and the mean height on the ground.
  vec3 nearest = clamp(frame.cameraPosition.xyz, centre - reach, centre + reach);
  bool large = isOrthographic() || grass.baseColour.w * pixelsPerMetre(nearest) > bezier.levels.w;
  seen[at] = large ? BEZIER_SEEN_LARGE : BEZIER_SEEN_SMALL;
  uint bucket = bucketOf(part);
  if (large || bezier.view.z > 0.0) atomicAdd(commands.buckets[bucket], 1u);
  if (!large) atomicAdd(commands.buckets[BEZIER_BUCKETS + bucket], 1u);
}
