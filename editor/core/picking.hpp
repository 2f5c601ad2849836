#pragma once
// What lies under the pointer, in screen space.

#include <vector>

#include "editor/core/camera_control.hpp"
#include "editor/core/object_kind.hpp"
#include "engine/model/project.hpp"

namespace windloom::editor {

inline constexpr float kHitRadiusPx = 10.0f;

struct Hit {
  ObjectKind kind = ObjectKind::Point;
  Id id = 0;
  float distancePx = 0;  ///< from the pointer to the handle; 0 inside an outline
  bool inside = false;   ///< inside an obstacle's or collider's outline, or on a surface: comes after every other hit
  float along = 0;       ///< arrows: place between start (0) and end (1)
  bool edge = false;     ///< at the outline of an obstacle, collider or surface, or a rotor's ring

  /// A point, a probe, or the middle of a collider, surface or rotor, which lie on top of lines and outlines.
  [[nodiscard]] bool isHandle() const {
    const bool middle = kind == ObjectKind::Collider || kind == ObjectKind::Surface || kind == ObjectKind::Rotor;
    return kind == ObjectKind::Point || kind == ObjectKind::Probe || (middle && !inside && !edge);
  }
};

struct PickOptions {
  float radiusPx = kHitRadiusPx;  ///< times the interface scale
  bool points = true, arrows = true, obstacles = true, colliders = true, surfaces = true, rotors = true, probes = true;
  Id ignore = 0;       ///< never hit (the point being dragged)
  double seconds = 0;  ///< of wind time: where colliders are
};

/// Options to hit nothing but points, or points and arrows.
PickOptions onlyPoints();
PickOptions onlyGraph();

/// All hits: points, probes and middles of colliders, surfaces and rotors first, then arrows, then outlines of
/// obstacles, colliders and surfaces and the rings of rotors, then insides; within a kind the nearest first, then the
/// lower id. Hidden and locked things are not hit.
std::vector<Hit> pick(const Project& project, const ViewMapping& view, const Ground& ground, glm::vec2 pixel,
                      const PickOptions& options = {});

/// The hit after `current` in the list (cycling), the first where `current` isn't in it; 0 for no hits.
Id cycleHit(const std::vector<Hit>& hits, Id current);

/// Everything with its handle (points, probes, middles of obstacles, colliders, surfaces and rotors; arrows with both
/// ends) inside the rectangle.
std::vector<Id> pickBox(const Project& project, const ViewMapping& view, const Ground& ground, glm::vec2 cornerA,
                        glm::vec2 cornerB, double seconds = 0);

}  // namespace windloom::editor
