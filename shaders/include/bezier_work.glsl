// What the culling passes of Bezier grass share. Needs frame.glsl.
#include "shaders/shared/bezier_blade.h"
#include "shaders/shared/bezier_block.h"

layout(std140, binding = RENDER_UBO_BEZIER) uniform BezierUniforms { BezierBlock bezier; };
layout(std430, binding = RENDER_SSBO_BEZIER_COMMANDS) buffer Commands { BezierCommands commands; };
layout(std430, binding = RENDER_SSBO_BEZIER_PATCHES) readonly buffer Patches { BezierPatch patches[]; };
// 0, or how each patch is seen; then the patches of the first round, then those of the second.
layout(std430, binding = RENDER_SSBO_BEZIER_SEEN) buffer Seen { uint seen[]; };

// Blades of a patch that are shown: its first ones.
uint shownBlades(BezierPatch part) { return uint(ceil(part.centre.w * bezier.patches.y / float(BEZIER_PATCH))); }

const uint BEZIER_SEEN_SMALL = 1u, BEZIER_SEEN_LARGE = 2u;

// A step of the distance from the camera, four to each doubling.
uint bucketOf(BezierPatch part) {
  float away = isOrthographic() ? 0.0 : length(part.centre.xyz - frame.cameraPosition.xyz);
  return uint(clamp(4.0 * log2(max(away, 1.0)), 0.0, float(BEZIER_BUCKETS - 1u)));
}

uint patchesNear(uint i) { return uint(bezier.patches.x) + i; }
uint patchesFar(uint i) { return 2u * uint(bezier.patches.x) + i; }
