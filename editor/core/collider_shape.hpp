#pragma once
// Where colliders stand on the ground as tools see them: outlines, extents, ways. 2D positions are (x, z) in metres.
// One that moves is seen as shownAt gives it.

#include <vector>

#include "engine/model/project.hpp"

namespace windloom::editor {

/// From a collider's own axes to the world; a sphere doesn't turn.
glm::vec2 toWorld(const Collider& collider, glm::vec2 own);
/// World corners around its extent seen from above: a circle, a capsule's, or the rectangle around a mesh (before the
/// mesh is read a square of 1 m).
std::vector<glm::vec2> outlineOf(const Collider& collider);
bool isInside(const Collider& collider, glm::vec2 world);
/// No part of it is farther from its position, m.
float reachOf(const Collider& collider);

/// A stand-in without keys that rests where the collider is at a time, and points as it does there.
Collider shownAt(const Collider& collider, double seconds);

/// The places of its keys, or its position where it rests.
std::vector<glm::vec2> wayOf(const Collider& collider);

}  // namespace windloom::editor
