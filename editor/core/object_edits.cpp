#include "editor/core/object_edits.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

#include "editor/core/id_index.hpp"
#include "editor/core/selection.hpp"
#include "engine/model/parameters.hpp"

namespace windloom::editor {
namespace {

Edit named(std::string label, std::string mergeKey = {}) {
  Edit edit;
  edit.label = std::move(label);
  edit.mergeKey = std::move(mergeKey);
  return edit;
}

std::unordered_set<Id> setOf(std::span<const Id> ids) {
  return {ids.begin(), ids.end()};
}

/// Steps of the same thing on the same ids merge.
std::string keyOf(std::string what, std::span<const Id> ids) {
  std::uint64_t hash = 14695981039346656037ull;  // FNV-1a over the ids
  for (const Id id : ids) hash = (hash ^ id) * 1099511628211ull;
  return what.append(1, ':').append(std::to_string(hash));
}

template <class Owner>
float clampTo(std::string_view key, float value) {
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    if (parameter.info.key == key) {
      return std::clamp(value, static_cast<float>(parameter.info.min), static_cast<float>(parameter.info.max));
    }
  }
  return value;
}

/// Applies `change` to a copy of each record whose id is in `ids`.
template <class T, class Change>
void putEach(Edit& edit, const std::vector<T>& records, const std::unordered_set<Id>& ids, Change change) {
  for (const T& record : records) {
    if (!ids.contains(record.id)) continue;
    T copy = record;
    change(copy);
    edit.steps.emplace_back(Put<T>{std::move(copy)});
  }
}

/// Its outline scaled along the world's axes around its centre, as well as its shape allows.
void scaleObstacle(Obstacle& obstacle, glm::vec2 scale) {
  const float mean = std::sqrt(scale.x * scale.y);
  obstacle.radius = clampTo<Obstacle>("radius", obstacle.radius * mean);
  const float angle = glm::radians(obstacle.rotation), c = std::cos(angle), s = std::sin(angle);
  const glm::vec2 along(glm::length(scale * glm::vec2(c, s)), glm::length(scale * glm::vec2(-s, c)));
  obstacle.size = {clampTo<Obstacle>("size", obstacle.size.x * along.x),
                   clampTo<Obstacle>("size", obstacle.size.y * along.y)};
  for (glm::vec2& own : obstacle.points) {
    const glm::vec2 world = scale * glm::vec2(own.x * c - own.y * s, own.x * s + own.y * c);
    own = scale.x == scale.y ? own * scale.x : glm::vec2(world.x * c + world.y * s, world.y * c - world.x * s);
  }
}

/// Its shape and its way scaled along the world's axes, then turned.
void transformCollider(Collider& collider, float degrees, glm::vec2 scale) {
  const float mean = std::sqrt(scale.x * scale.y), angle = glm::radians(degrees);
  const float c = std::cos(angle), s = std::sin(angle);
  collider.radius = clampTo<Collider>("radius", collider.radius * mean);
  collider.length = clampTo<Collider>("length", collider.length * mean);
  collider.scale = clampTo<Collider>("scale", collider.scale * mean);
  collider.rotation = std::remainder(collider.rotation + degrees, 360.0f);
  for (ColliderKey& key : collider.keys) {
    const glm::vec2 d = glm::vec2(key.offset.x, key.offset.z) * scale;
    key.offset = {d.x * c - d.y * s, key.offset.y, d.x * s + d.y * c};
  }
}

void scaleSurface(Surface& surface, float factor) {
  surface.size = clampTo<Surface>("size", surface.size * factor);
  surface.scale = clampTo<Surface>("scale", surface.scale * factor);
}

/// Whether the ids' order in one of the lists would be another one.
template <class Record>
bool movesIn(const std::vector<Record>& before, const std::vector<Record>& after) {
  return !std::equal(before.begin(), before.end(), after.begin(), after.end(),
                     [](const Record& a, const Record& b) { return a.id == b.id; });
}

template <class Record>
AddResult added(const char* label, const Project& project, Record record) {
  AddResult result{named(label), nextFreeId(project)};
  record.id = result.id;
  result.edit.steps.emplace_back(Put<Record>{std::move(record)});
  return result;
}

}  // namespace

std::vector<Id> movableIds(const Project& project, std::span<const Id> ids) {
  const IdIndex index(project);
  std::unordered_set<Id> locked, open;
  for (const Arrow& arrow : project.graph->arrows) (arrow.locked ? locked : open).insert({arrow.from, arrow.to});
  std::vector<Id> movable;
  std::unordered_set<Id> seen;
  const auto add = [&](Id id) {
    if (seen.insert(id).second) movable.push_back(id);
  };
  const auto addPoint = [&](Id id) {
    if (open.contains(id) || !locked.contains(id)) add(id);
  };
  for (const Id id : ids) {
    if (index.point(id)) addPoint(id);
    if (const Arrow* arrow = index.arrow(id); arrow && !arrow->locked) {
      addPoint(arrow->from);
      addPoint(arrow->to);
    }
    if (const Obstacle* obstacle = index.obstacle(id); obstacle && !obstacle->locked) add(id);
    if (const Collider* collider = index.collider(id); collider && !collider->locked) add(id);
    if (const Surface* surface = index.surface(id); surface && !surface->locked) add(id);
    if (const Rotor* rotor = index.rotor(id); rotor && !rotor->locked) add(id);
    if (const Probe* probe = index.probe(id); probe && !probe->locked) add(id);
  }
  return movable;
}

std::optional<glm::vec2> pivotOf(const Project& project, std::span<const Id> ids) {
  const IdIndex index(project);
  glm::vec2 sum(0.0f);
  const std::vector<Id> movable = movableIds(project, ids);
  for (const Id id : movable) {
    if (const Point* point = index.point(id)) sum += point->position;
    if (const Obstacle* obstacle = index.obstacle(id)) sum += obstacle->centre;
    if (const Collider* collider = index.collider(id)) sum += collider->position;
    if (const Surface* surface = index.surface(id)) sum += surface->position;
    if (const Rotor* rotor = index.rotor(id)) sum += rotor->position;
    if (const Probe* probe = index.probe(id)) sum += probe->position;
  }
  if (movable.empty()) return std::nullopt;
  return sum / static_cast<float>(movable.size());
}

Edit transformEdit(const Project& project, std::span<const Id> ids, glm::vec2 pivot, float degrees, glm::vec2 scale) {
  const float c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  const auto placed = [&](glm::vec2 at) {
    const glm::vec2 d = (at - pivot) * scale;
    return pivot + glm::vec2(d.x * c - d.y * s, d.x * s + d.y * c);
  };
  Edit edit = named(scale == glm::vec2(1.0f) ? "Rotate" : "Scale");
  const std::unordered_set<Id> moved = setOf(movableIds(project, ids));
  putEach(edit, project.graph->points, moved, [&](Point& point) { point.position = placed(point.position); });
  putEach(edit, *project.obstacles, moved, [&](Obstacle& obstacle) {
    scaleObstacle(obstacle, scale);
    obstacle.centre = placed(obstacle.centre);
    obstacle.rotation = std::remainder(obstacle.rotation + degrees, 360.0f);
  });
  putEach(edit, *project.colliders, moved, [&](Collider& collider) {
    transformCollider(collider, degrees, scale);
    collider.position = placed(collider.position);
  });
  const float mean = std::sqrt(scale.x * scale.y);
  putEach(edit, *project.surfaces, moved, [&](Surface& surface) {
    scaleSurface(surface, mean);
    surface.position = placed(surface.position);
    surface.rotation = std::remainder(surface.rotation + degrees, 360.0f);
  });
  putEach(edit, *project.rotors, moved, [&](Rotor& rotor) {
    rotor.radius = clampTo<Rotor>("radius", rotor.radius * mean);
    rotor.position = placed(rotor.position);
  });
  putEach(edit, *project.probes, moved, [&](Probe& probe) { probe.position = placed(probe.position); });
  return edit;
}

std::vector<Id> arrowsOf(const Project& project, std::span<const Id> ids) {
  const std::unordered_set<Id> chosen = setOf(ids);
  std::vector<Id> found;
  for (const Arrow& arrow : project.graph->arrows) {
    if (chosen.contains(arrow.id) || (chosen.contains(arrow.from) && chosen.contains(arrow.to))) {
      found.push_back(arrow.id);
    }
  }
  if (!found.empty()) return found;
  for (const Arrow& arrow : project.graph->arrows) {
    if (chosen.contains(arrow.from) || chosen.contains(arrow.to)) found.push_back(arrow.id);
  }
  return found;
}

Edit scaleStrengthEdit(const Project& project, std::span<const Id> ids, float factor) {
  const std::vector<Id> arrows = arrowsOf(project, ids);
  Edit edit = named("Change strength", keyOf("strength", arrows));
  putEach(edit, project.graph->arrows, setOf(arrows),
          [&](Arrow& arrow) { arrow.strength = clampTo<Arrow>("strength", arrow.strength * factor); });
  return edit;
}

Edit scaleRadiusEdit(const Project& project, std::span<const Id> ids, float factor) {
  const std::vector<Id> arrows = arrowsOf(project, ids);
  Edit edit = named("Change radius", keyOf("radius", ids));
  putEach(edit, project.graph->arrows, setOf(arrows),
          [&](Arrow& arrow) { arrow.radius = clampTo<Arrow>("radius", arrow.radius * factor); });
  putEach(edit, *project.obstacles, setOf(ids), [&](Obstacle& obstacle) {
    if (obstacle.shape == ObstacleShape::Polygon) return;
    obstacle.radius = clampTo<Obstacle>("radius", obstacle.radius * factor);
    obstacle.size = {clampTo<Obstacle>("size", obstacle.size.x * factor),
                     clampTo<Obstacle>("size", obstacle.size.y * factor)};
  });
  putEach(edit, *project.colliders, setOf(ids),
          [&](Collider& collider) { collider.radius = clampTo<Collider>("radius", collider.radius * factor); });
  putEach(edit, *project.surfaces, setOf(ids), [&](Surface& surface) { scaleSurface(surface, factor); });
  putEach(edit, *project.rotors, setOf(ids),
          [&](Rotor& rotor) { rotor.radius = clampTo<Rotor>("radius", rotor.radius * factor); });
  return edit;
}

Edit renameEdit(const Project& project, Id id, std::string name) {
  Edit edit = named("Rename");
  const std::unordered_set<Id> one{id};
  const auto change = [&](auto& record) { record.name = name; };
  if (nameOf(project, id) == name) return edit;
  putEach(edit, project.graph->points, one, change);
  putEach(edit, project.graph->arrows, one, change);
  putEach(edit, *project.obstacles, one, change);
  putEach(edit, *project.species, one, change);
  putEach(edit, *project.colliders, one, change);
  putEach(edit, *project.surfaces, one, change);
  putEach(edit, *project.rotors, one, change);
  putEach(edit, *project.probes, one, change);
  putEach(edit, *project.cameras, one, change);
  return edit;
}

AddResult addObstacleEdit(const Project& project, Obstacle obstacle) {
  return added("Add obstacle", project, std::move(obstacle));
}

Edit reorderEdit(const Project& project, std::span<const Id> ids, Id before) {
  Edit edit = named("Reorder");
  edit.steps.emplace_back(Reorder{{ids.begin(), ids.end()}, before});
  const Result<Project> moved = applyEdit(project, edit);
  const bool changes =
      moved &&
      (movesIn(project.graph->points, moved->graph->points) || movesIn(project.graph->arrows, moved->graph->arrows) ||
       movesIn(*project.obstacles, *moved->obstacles) || movesIn(*project.species, *moved->species) ||
       movesIn(*project.colliders, *moved->colliders) || movesIn(*project.surfaces, *moved->surfaces) ||
       movesIn(*project.rotors, *moved->rotors) || movesIn(*project.probes, *moved->probes) ||
       movesIn(*project.cameras, *moved->cameras));
  if (!changes) edit.steps.clear();
  return edit;
}

AddResult addSpeciesEdit(const Project& project, Species species) {
  return added("Add species", project, std::move(species));
}

AddResult addColliderEdit(const Project& project, Collider collider) {
  return added("Add collider", project, std::move(collider));
}

AddResult addSurfaceEdit(const Project& project, Surface surface) {
  return added("Add surface", project, std::move(surface));
}

AddResult addRotorEdit(const Project& project, Rotor rotor) {
  return added("Add rotor", project, std::move(rotor));
}

AddResult addProbeEdit(const Project& project, Probe probe) {
  return added("Add probe", project, std::move(probe));
}

Edit deleteEdit(const Project& project, std::span<const Id> ids) {
  const IdIndex index(project);
  std::vector<Id> erased;
  std::unordered_set<Id> gone;
  for (const Id id : ids) {
    if (index.contains(id) && gone.insert(id).second) erased.push_back(id);
  }
  if (erased.empty()) return named("Delete");
  std::unordered_set<Id> losing, keeping;
  for (const Arrow& arrow : project.graph->arrows) {
    const bool goes = gone.contains(arrow.id) || gone.contains(arrow.from) || gone.contains(arrow.to);
    (goes ? losing : keeping).insert({arrow.from, arrow.to});
  }
  std::string what = erased.size() == 1 ? kindLabel(index.find(erased[0])->kind) : describeIds(project, erased);
  what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
  for (const Point& point : project.graph->points) {
    if (losing.contains(point.id) && !keeping.contains(point.id) && gone.insert(point.id).second) {
      erased.push_back(point.id);
    }
  }
  Edit edit = eraseEdit(std::move(erased));
  edit.label = "Delete " + what;
  return edit;
}

}  // namespace windloom::editor
