// How a blade is bent out of things that touch it, from the root up, the same in C++ (tests) and GLSL: the contact of
// Belyaev, Laevsky & Chukanov, 2011. All in the blade's own frame: root at the origin, y along what it is planted on.
#ifndef WINDLOOM_SHARED_CHAIN_CONTACT_H
#define WINDLOOM_SHARED_CHAIN_CONTACT_H
#include "shaders/shared/collider.h"
#include "shaders/shared/segment_chain.h"
WL_SHARED_BEGIN

// m that blades keep from what touches them.
#define CONTACT_MARGIN 0.005f
// Turns of one segment until it is clear of one capsule, whose nearest place moves along as the segment turns.
#define CONTACT_TURNS 8
// Times that a blade goes through all that touches it.
#define CONTACT_PASSES 6

/// A blade as its pose has it, and how far each segment is turned from there.
struct ContactChain {
  vec3 part[CHAIN_SEGMENTS];  // unit vectors along the segments of the pose
  float size[CHAIN_SEGMENTS];  // their lengths, m
  vec2 lean[CHAIN_SEGMENTS];  // cumulative
  uint bent;                  // bit i: segment i was bent
};

WL_FUNCTION vec3 contactDirection(ContactChain chain, int i) { return chainMatrix(chainTurn(chain.lean[i])) * chain.part[i]; }

/// The lean that turns one unit vector into another.
WL_FUNCTION vec2 leanBetween(vec3 from, vec3 to) {
  vec3 way = to - from;
  if (dot(way, way) < 1e-12f) return vec2(0.0f, 0.0f);
  // The axis lies level and at right angles to the way.
  vec2 level = vec2(way.x, way.z);
  if (lengthOf(level) < 1e-5f) level = vec2(from.x, from.z);
  if (lengthOf(level) < 1e-5f) level = vec2(1.0f, 0.0f);
  level = level / lengthOf(level);
  vec3 axis = chainTurn(level);
  vec3 a = from - axis * dot(axis, from);
  vec3 b = to - axis * dot(axis, to);
  return level * chainAngle(dot(axis, cross(a, b)), dot(a, b));
}

/// The direction nearest to `along` in which a segment of length `size` from `start` is clear of a ball. `start` itself
/// must be outside.
WL_FUNCTION vec3 clearOfBall(vec3 start, vec3 along, float size, vec3 centre, float radius) {
  vec3 away = centre - start;
  float distance2 = dot(away, away);
  float distance = sqrt(max(distance2, 1e-12f));
  vec3 to = away / distance;
  float tangent2 = max(distance2 - radius * radius, 0.0f);
  // Either the line touches the ball or, if it is too short for that, its end does.
  float most = size * size >= tangent2 ? sqrt(tangent2) / distance
                                       : (tangent2 + size * size) / (2.0f * distance * size);
  float cosine = dot(along, to);
  if (cosine <= most) return along;
  vec3 aside = along - to * cosine;
  // Straight at it: away from its middle, else anywhere level.
  if (dot(aside, aside) < 1e-8f) aside = vec3(-to.x, 0.0f, -to.z) - to * (-to.x * to.x - to.z * to.z);
  if (dot(aside, aside) < 1e-8f) aside = vec3(1.0f, 0.0f, 0.0f) - to * to.x;
  float within = min(most - 1e-4f, 1.0f);
  return to * within + aside * (sqrt(max(1.0f - within * within, 0.0f)) / sqrt(dot(aside, aside)));
}

/// The place on the line of a primitive that is nearest to the segment from `start` (Ericson, "Real-Time Collision
/// Detection", 2005, 5.1.9).
WL_FUNCTION vec3 nearestToSegment(ColliderPrimitive primitive, vec3 start, vec3 along, float size) {
  vec3 a = vec3(primitive.a);
  vec3 axis = vec3(primitive.b) - a;
  float axis2 = dot(axis, axis);
  if (axis2 < 1e-12f) return a;
  vec3 between = start - a;
  float onAxis = dot(axis, along);
  float bulk = axis2 - onAxis * onAxis;  // axis2 sin^2 of the angle between the two
  float s = 0.0f;
  if (bulk > 1e-9f * axis2) s = (onAxis * dot(axis, between) - dot(along, between) * axis2) / bulk;
  s = min(max(s, 0.0f), size);
  float t = min(max(dot(axis, between + along * s) / axis2, 0.0f), 1.0f);
  // The nearest place of the segment to a clamped one may lie elsewhere.
  s = min(max(dot(along, a + axis * t - start), 0.0f), size);
  t = min(max(dot(axis, between + along * s) / axis2, 0.0f), 1.0f);
  return a + axis * t;
}

/// m between a segment and the surface of a primitive; negative inside.
WL_FUNCTION float segmentDistance(ColliderPrimitive primitive, vec3 start, vec3 along, float size) {
  vec3 axis = nearestToSegment(primitive, start, along, size);
  float s = min(max(dot(along, axis - start), 0.0f), size);
  vec3 between = start + along * s - axis;
  return sqrt(dot(between, between)) - primitive.a.w;
}

/// Whether a primitive can touch a blade of this length at all.
WL_FUNCTION bool mayTouch(ColliderPrimitive primitive, float size) {
  return colliderDistance(primitive, vec3(0.0f)) < size + 2.0f * CONTACT_MARGIN;
}

/// Whether the root is in it: such a blade can't be bent out.
WL_FUNCTION bool rootInside(ColliderPrimitive primitive) {
  return colliderDistance(primitive, vec3(0.0f)) < CONTACT_MARGIN;
}

/// A direction that doesn't lead from `start` into the ground.
WL_FUNCTION vec3 overGround(vec3 start, vec3 along, float size) {
  float least = min(max((0.5f * CONTACT_MARGIN - start.y) / size, -0.9f), 0.9f);
  if (along.y >= least) return along;
  vec2 level = vec2(along.x, along.z);
  float reach = lengthOf(level);
  level = reach > 1e-5f ? level * (sqrt(1.0f - least * least) / reach) : vec2(sqrt(1.0f - least * least), 0.0f);
  return vec3(level.x, least, level.y);
}

/// Bends a blade out of one primitive, segment by segment; the upper ones are carried along.
WL_FUNCTION ContactChain bentOut(ContactChain chain, ColliderPrimitive primitive) {
  vec3 start = vec3(0.0f);
  float radius = primitive.a.w + CONTACT_MARGIN;
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec3 before = contactDirection(chain, i);
    vec3 along = before;
    for (int turn = 0; turn < CONTACT_TURNS; ++turn) {
      if (segmentDistance(primitive, start, along, chain.size[i]) >= 0.98f * CONTACT_MARGIN) break;
      vec3 centre = nearestToSegment(primitive, start, along, chain.size[i]);
      along = overGround(start, clearOfBall(start, along, chain.size[i], centre, radius), chain.size[i]);
    }
    vec3 moved = along - before;
    if (dot(moved, moved) > 0.0f) {
      vec2 change = leanBetween(chain.part[i], along) - chain.lean[i];
      for (int above = i; above < CHAIN_SEGMENTS; ++above) chain.lean[above] = chain.lean[above] + change;
      chain.bent = chain.bent | (1u << uint(i));
    }
    start = start + contactDirection(chain, i) * chain.size[i];
  }
  return chain;
}

/// m by which a blade lies nearest to a primitive; negative: in it.
WL_FUNCTION float chainDistance(ContactChain chain, ColliderPrimitive primitive) {
  vec3 start = vec3(0.0f);
  float least = 1e9f;
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    vec3 along = contactDirection(chain, i);
    least = min(least, segmentDistance(primitive, start, along, chain.size[i]));
    start = start + along * chain.size[i];
  }
  return least;
}

WL_SHARED_END
#endif
