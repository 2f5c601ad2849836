// What the culling passes of Bezier grass share. Needs frame.glsl.
#include "shaders/shared/bezier_blade.h"
#include "shaders/shared/bezier_block.h"

layout(std140, binding = RENDER_UBO_BEZIER) uniform BezierUniforms { BezierBlock bezier; };
layout(std430, binding = RENDER_SSBO_BEZIER_COMMANDS) buffer Commands { BezierCommands commands; };
layout(std430, binding = RENDER_SSBO_BEZIER_PATCHES) readonly buffer Patches { BezierPatch patches[]; };
// Whether each patch is seen, then the patches that are drawn first, then the others.
layout(std430, binding = RENDER_SSBO_BEZIER_SEEN) buffer Seen { uint seen[]; };

uint patchesNear(uint i) { return uint(bezier.patches.x) + i; }
uint patchesFar(uint i) { return 2u * uint(bezier.patches.x) + i; }
