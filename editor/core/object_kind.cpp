#include "editor/core/object_kind.hpp"

#include <algorithm>
#include <cmath>

#include "editor/core/collider_shape.hpp"
#include "editor/core/id_index.hpp"
#include "editor/core/surface_shape.hpp"
#include "engine/model/outline.hpp"

namespace windloom::editor {
namespace {

template <class T>
const T* findIn(const std::vector<T>& records, Id id) {
  const auto found = std::find_if(records.begin(), records.end(), [&](const T& record) { return record.id == id; });
  return found == records.end() ? nullptr : &*found;
}

/// Whether the point has arrows and `flag` is set on all of them.
bool allArrowsOfPoint(const WindGraph& graph, Id point, bool Arrow::*flag) {
  bool any = false;
  for (const Arrow& arrow : graph.arrows) {
    if (arrow.from != point && arrow.to != point) continue;
    if (!(arrow.*flag)) return false;
    any = true;
  }
  return any;
}

bool flagged(const Project& project, Id id, bool Arrow::*arrowFlag, bool Obstacle::*obstacleFlag,
             bool Collider::*colliderFlag, bool Surface::*surfaceFlag, bool Rotor::*rotorFlag, bool Probe::*probeFlag) {
  if (const Arrow* arrow = findArrow(*project.graph, id)) return arrow->*arrowFlag;
  if (findPoint(*project.graph, id)) return allArrowsOfPoint(*project.graph, id, arrowFlag);
  if (const Obstacle* obstacle = findObstacle(project, id)) return obstacle->*obstacleFlag;
  if (const Collider* collider = findCollider(project, id)) return collider->*colliderFlag;
  if (const Surface* surface = findSurface(project, id)) return surface->*surfaceFlag;
  if (const Rotor* rotor = findRotor(project, id)) return rotor->*rotorFlag;
  if (const Probe* probe = findProbe(project, id)) return probe->*probeFlag;
  return false;
}

void include(std::optional<GroundBounds>& bounds, glm::vec2 low, glm::vec2 high) {
  if (!bounds) {
    bounds = GroundBounds{low, high};
  } else {
    bounds->low = glm::min(bounds->low, low);
    bounds->high = glm::max(bounds->high, high);
  }
}

void includePoint(std::optional<GroundBounds>& bounds, const IdIndex& index, Id id) {
  if (const Point* point = index.point(id)) include(bounds, point->position, point->position);
}

}  // namespace

const Obstacle* findObstacle(const Project& project, Id id) {
  return findIn(*project.obstacles, id);
}
const Species* findSpecies(const Project& project, Id id) {
  return findIn(*project.species, id);
}
const Collider* findCollider(const Project& project, Id id) {
  return findIn(*project.colliders, id);
}
const Surface* findSurface(const Project& project, Id id) {
  return findIn(*project.surfaces, id);
}
const Rotor* findRotor(const Project& project, Id id) {
  return findIn(*project.rotors, id);
}
const Probe* findProbe(const Project& project, Id id) {
  return findIn(*project.probes, id);
}
const Camera* findCamera(const Project& project, Id id) {
  return findIn(*project.cameras, id);
}

std::optional<ObjectKind> kindOf(const Project& project, Id id) {
  if (findPoint(*project.graph, id)) return ObjectKind::Point;
  if (findArrow(*project.graph, id)) return ObjectKind::Arrow;
  if (findObstacle(project, id)) return ObjectKind::Obstacle;
  if (findSpecies(project, id)) return ObjectKind::Species;
  if (findCollider(project, id)) return ObjectKind::Collider;
  if (findSurface(project, id)) return ObjectKind::Surface;
  if (findRotor(project, id)) return ObjectKind::Rotor;
  if (findProbe(project, id)) return ObjectKind::Probe;
  if (findCamera(project, id)) return ObjectKind::Camera;
  return std::nullopt;
}

const char* kindLabel(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::Point:
      return "Point";
    case ObjectKind::Arrow:
      return "Arrow";
    case ObjectKind::Obstacle:
      return "Obstacle";
    case ObjectKind::Species:
      return "Species";
    case ObjectKind::Collider:
      return "Collider";
    case ObjectKind::Surface:
      return "Surface";
    case ObjectKind::Rotor:
      return "Rotor";
    case ObjectKind::Probe:
      return "Probe";
    case ObjectKind::Camera:
      return "Camera";
  }
  return "";
}

std::string countOf(std::size_t count, ObjectKind kind) {
  std::string word = kindLabel(kind);
  word[0] = static_cast<char>(word[0] + ('a' - 'A'));
  const bool same = count == 1 || kind == ObjectKind::Species;
  return std::to_string(count).append(" ").append(word).append(same ? "" : "s");
}

std::string nameOf(const Project& project, Id id) {
  if (const Point* point = findPoint(*project.graph, id)) return point->name;
  if (const Arrow* arrow = findArrow(*project.graph, id)) return arrow->name;
  if (const Obstacle* obstacle = findObstacle(project, id)) return obstacle->name;
  if (const Species* species = findSpecies(project, id)) return species->name;
  if (const Collider* collider = findCollider(project, id)) return collider->name;
  if (const Surface* surface = findSurface(project, id)) return surface->name;
  if (const Rotor* rotor = findRotor(project, id)) return rotor->name;
  if (const Probe* probe = findProbe(project, id)) return probe->name;
  if (const Camera* camera = findCamera(project, id)) return camera->name;
  return {};
}

bool isHidden(const Project& project, Id id) {
  if (const Species* species = findSpecies(project, id)) return species->hidden;
  return flagged(project, id, &Arrow::hidden, &Obstacle::hidden, &Collider::hidden, &Surface::hidden, &Rotor::hidden,
                 &Probe::hidden);
}
bool isLocked(const Project& project, Id id) {
  return flagged(project, id, &Arrow::locked, &Obstacle::locked, &Collider::locked, &Surface::locked, &Rotor::locked,
                 &Probe::locked);
}

std::optional<GroundBounds> boundsOf(const Project& project, std::span<const Id> ids) {
  std::optional<GroundBounds> bounds;
  if (ids.empty()) return bounds;
  const IdIndex index(project);
  for (const Id id : ids) {
    includePoint(bounds, index, id);
    if (const Arrow* arrow = index.arrow(id)) {
      includePoint(bounds, index, arrow->from);
      includePoint(bounds, index, arrow->to);
    } else if (const Obstacle* obstacle = index.obstacle(id)) {
      for (const glm::vec2 corner : outlineOf(*obstacle)) include(bounds, corner, corner);
    } else if (const Collider* collider = index.collider(id)) {
      const float reach = reachOf(*collider);
      for (const glm::vec2 place : wayOf(*collider)) include(bounds, place - reach, place + reach);
    } else if (const Surface* surface = index.surface(id)) {
      for (const glm::vec2 corner : outlineOf(*surface)) include(bounds, corner, corner);
    } else if (const Rotor* rotor = index.rotor(id)) {
      include(bounds, rotor->position - rotor->radius, rotor->position + rotor->radius);
    } else if (const Probe* probe = index.probe(id)) {
      include(bounds, probe->position, probe->position);
    } else if (const Camera* camera = index.camera(id)) {
      include(bounds, {camera->target.x, camera->target.z}, {camera->target.x, camera->target.z});
    }
  }
  return bounds;
}

}  // namespace windloom::editor
