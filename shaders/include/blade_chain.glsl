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

// Where it points there, a unit vector.
vec3 poseTangent(vec2 bend, vec2 facing, float s) {
  if (grass.size.w == GRASS_DEFORMATION_QUADRATIC) {
    return normalize(posePoint(bend, facing, s + 0.05) - posePoint(bend, facing, s) + vec3(0.0, 1e-5, 0.0));
  }
  float angle = length(bend);
  vec2 towards = angle > 1e-5 ? bend / angle : facing;
  vec2 tangent = arcAt(min(angle, 1.54), s).tangent;
  return vec3(towards.x * tangent.x, tangent.y, towards.y * tangent.x);
}

// The lean at `s`: between the middles of segments, from none at the root.
vec2 leanAt(ChainLeans leans, float s) {
  float place = s * float(CHAIN_SEGMENTS) - 0.5;
  if (place < 0.0) return leans.e[0] * (1.0 + 2.0 * place);
  int low = min(int(place), CHAIN_SEGMENTS - 1);
  return mix(leans.e[low], leans.e[min(low + 1, CHAIN_SEGMENTS - 1)], place - float(low));
}

// posePoint and poseTangent of a blade with leans. The segments are straight, as they were bent out of what touches them;
// light sees them rounded.
void leaningPoint(vec2 bend, ChainLeans leans, vec2 facing, float s, out vec3 place, out vec3 tangent) {
  place = vec3(0.0);
  tangent = chainMatrix(chainTurn(leanAt(leans, s))) * poseTangent(bend, facing, s);
  vec3 before = vec3(0.0);
  for (int i = 0; i < CHAIN_SEGMENTS && float(i) < s * float(CHAIN_SEGMENTS); ++i) {
    vec3 next = posePoint(bend, facing, min(float(i + 1) / float(CHAIN_SEGMENTS), s));
    place += chainMatrix(chainTurn(leans.e[i])) * (next - before);
    before = next;
  }
}
