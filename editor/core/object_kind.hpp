#pragma once
// What an id stands for.

#include <optional>
#include <span>
#include <string>

#include "engine/model/project.hpp"

namespace windloom::editor {

enum class ObjectKind { Point, Arrow, Obstacle, Species, Collider, Surface, Rotor, Probe, Camera };

/// Nothing where the project has no such id.
std::optional<ObjectKind> kindOf(const Project& project, Id id);
const char* kindLabel(ObjectKind kind);  ///< "Point", "Arrow", ...
/// "1 arrow", "3 arrows", "2 species"
std::string countOf(std::size_t count, ObjectKind kind);

/// The record with this id, or null.
const Obstacle* findObstacle(const Project& project, Id id);
const Species* findSpecies(const Project& project, Id id);
const Collider* findCollider(const Project& project, Id id);
const Surface* findSurface(const Project& project, Id id);
const Rotor* findRotor(const Project& project, Id id);
const Probe* findProbe(const Project& project, Id id);
const Camera* findCamera(const Project& project, Id id);

/// The name an artist gave it, or "".
std::string nameOf(const Project& project, Id id);

/// Points carry no flags of their own: a point is hidden (locked) where it has arrows and all of them are.
bool isHidden(const Project& project, Id id);
bool isLocked(const Project& project, Id id);

/// Ground bounds of the ids (arrows: both ends; obstacles: their extent; colliders: theirs along their whole way;
/// surfaces and rotors: theirs; species, which have no place, don't count). Nothing for no ids.
struct GroundBounds {
  glm::vec2 low{0.0f}, high{0.0f};
};
std::optional<GroundBounds> boundsOf(const Project& project, std::span<const Id> ids);

}  // namespace windloom::editor
