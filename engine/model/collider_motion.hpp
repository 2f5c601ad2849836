#pragma once
// Where a collider is at a time, and what of it touches the grass. Exact functions of time: nothing is remembered.

#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/collider.h"

namespace windloom {

using shared::ColliderPrimitive;

/// Its offset from its place, m: the keys joined by monotone cubics, so that it stays where two keys in a row have one
/// offset and never goes beyond its keys. Before the first key the first, after the last the last, or again from the
/// start with `loop`; where the first and the last offset are the same, the way goes on smoothly there.
glm::vec3 colliderOffset(const Collider& collider, double seconds);
/// How fast the offset changes, m/s.
glm::vec3 colliderVelocity(const Collider& collider, double seconds);

/// Where it points, rad from +X towards +Z: along its motion over the ground. While it pauses it keeps the direction it
/// came in and turns into the next one as it sets off; what has not moved yet points by `rotation`.
float colliderHeading(const Collider& collider, double seconds);

struct ColliderPose {
  glm::vec3 centre{0.0f};  ///< m; of a mesh: its origin
  /// From its own metres to the world. A sphere and a capsule have their centre at the origin, a capsule lies along x
  /// with its front at +x, a mesh is as in its file with its front at +z.
  glm::mat4 world{1.0f};
};
/// Its lowest point stands `lift` and the key's height over the ground; `ground` null: flat at 0. A sphere that rolls
/// turns without slipping.
ColliderPose colliderPose(const Collider& collider, const HeightField* ground, double seconds);

/// What touches the grass: a sphere, a capsule, or the spheres packed into a mesh (none before it is read). None where
/// it is muted.
std::vector<ColliderPrimitive> colliderPrimitives(const Collider& collider, const HeightField* ground, double seconds);
/// Of all of the project's colliders, in their order.
std::vector<ColliderPrimitive> colliderPrimitives(const Project& project, double seconds);

}  // namespace windloom
