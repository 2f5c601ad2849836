// Points of a blade whose segments lean over its pose. Needs meadow.glsl.
#include "shaders/shared/segment_chain.h"

// A point of the pose at `s` of the blade without leans, from its root, in blade heights.
vec3 posePoint(vec2 bend, vec2 facing, float s) {
  if (grass.size.w == GRASS_DEFORMATION_QUADRATIC) {
    vec2 across = vec2(facing.y, -facing.x);
    vec3 at = quadraticAt(vec3(0.0, s, 0.0), vec2(dot(bend, across), dot(bend, facing)), grass.droop.x, grass.droop.y, grass.motion.w);
    return vec3(across.x * at.x + facing.x * at.z, at.y, across.y * at.x + facing.y * at.z);
  }
  float angle = length(bend);
  vec2 towards = angle > 1e-5 ? bend / angle : facing;
  ArcPoint at = arcAt(min(angle, 1.54), s);
  return vec3(towards.x * at.position.x, at.position.y, towards.y * at.position.x);
}

// The same with leans, and where it points there.
void leaningPoint(vec2 bend, ChainLeans leans, vec2 facing, float s, out vec3 place, out vec3 tangent) {
  place = vec3(0.0);
  tangent = vec3(0.0, 1.0, 0.0);
  vec3 before = vec3(0.0);
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    float end = min(float(i + 1) / float(CHAIN_SEGMENTS), s);
    if (float(i) / float(CHAIN_SEGMENTS) >= s && i > 0) break;
    vec3 next = posePoint(bend, facing, max(end, 1e-3));
    vec3 part = chainMatrix(chainTurn(leans.e[i])) * (next - before);
    place += part;
    tangent = part;
    before = next;
  }
  tangent = normalize(tangent);
  if (s <= 0.0) place = vec3(0.0);
}
