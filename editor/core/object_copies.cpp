// Duplicate, copy and paste: the copying edits of object_edits.hpp.
#include <unordered_map>
#include <unordered_set>

#include "editor/core/object_edits.hpp"

namespace windloom::editor {
namespace {

using IdMap = std::unordered_map<Id, Id>;

template <class T>
std::vector<T> picked(const std::vector<T>& records, const std::unordered_set<Id>& ids) {
  std::vector<T> result;
  for (const T& record : records) {
    if (ids.contains(record.id)) result.push_back(record);
  }
  return result;
}

/// Steps that put a copy of all records of `pieces` under new ids.
Edit copyEdit(const Project& project, const Project& pieces, glm::vec2 offset, IdMap& map) {
  Edit edit;
  FreeIds ids(project);
  const auto fresh = [&](auto record) {
    const Id id = ids.take();
    map[record.id] = id;
    record.id = id;
    return record;
  };
  for (const Point& point : pieces.graph->points) {
    Point copy = fresh(point);
    copy.position += offset;
    edit.steps.emplace_back(Put<Point>{std::move(copy)});
  }
  for (const Arrow& arrow : pieces.graph->arrows) {
    Arrow copy = fresh(arrow);
    copy.from = map[arrow.from];
    copy.to = map[arrow.to];
    edit.steps.emplace_back(Put<Arrow>{std::move(copy)});
  }
  for (const Signal& signal : pieces.graph->signals) {
    Signal copy = signal;
    copy.root = map[signal.root];
    edit.steps.emplace_back(Put<Signal>{std::move(copy)});
  }
  for (const Obstacle& obstacle : *pieces.obstacles) {
    Obstacle copy = fresh(obstacle);
    copy.centre += offset;
    edit.steps.emplace_back(Put<Obstacle>{std::move(copy)});
  }
  for (const Species& species : *pieces.species) edit.steps.emplace_back(Put<Species>{fresh(species)});
  for (const Collider& collider : *pieces.colliders) {
    Collider copy = fresh(collider);
    copy.position += offset;
    edit.steps.emplace_back(Put<Collider>{std::move(copy)});
  }
  for (const Surface& surface : *pieces.surfaces) {
    Surface copy = fresh(surface);
    copy.position += offset;
    edit.steps.emplace_back(Put<Surface>{std::move(copy)});
  }
  for (const Rotor& rotor : *pieces.rotors) {
    Rotor copy = fresh(rotor);
    copy.position += offset;
    edit.steps.emplace_back(Put<Rotor>{std::move(copy)});
  }
  for (const Probe& probe : *pieces.probes) {
    Probe copy = fresh(probe);
    copy.position += offset;
    edit.steps.emplace_back(Put<Probe>{std::move(copy)});
  }
  for (const Camera& camera : *pieces.cameras) edit.steps.emplace_back(Put<Camera>{fresh(camera)});
  return edit;
}

}  // namespace

Project extract(const Project& project, std::span<const Id> ids) {
  const std::unordered_set<Id> chosen(ids.begin(), ids.end());
  auto graph = std::make_shared<WindGraph>();
  std::unordered_set<Id> points = chosen;
  for (const Arrow& arrow : project.graph->arrows) {
    if (chosen.contains(arrow.id)) points.insert({arrow.from, arrow.to});
  }
  graph->points = picked(project.graph->points, points);
  for (const Arrow& arrow : project.graph->arrows) {
    const bool between = chosen.contains(arrow.from) && chosen.contains(arrow.to);
    if (chosen.contains(arrow.id) || between) graph->arrows.push_back(arrow);
  }
  for (const Signal& signal : project.graph->signals) {
    if (points.contains(signal.root)) graph->signals.push_back(signal);
  }
  Project pieces;
  pieces.name = project.name;
  pieces.graph = std::move(graph);
  pieces.obstacles = std::make_shared<std::vector<Obstacle>>(picked(*project.obstacles, chosen));
  pieces.species = std::make_shared<std::vector<Species>>(picked(*project.species, chosen));
  pieces.colliders = std::make_shared<std::vector<Collider>>(picked(*project.colliders, chosen));
  pieces.surfaces = std::make_shared<std::vector<Surface>>(picked(*project.surfaces, chosen));
  pieces.rotors = std::make_shared<std::vector<Rotor>>(picked(*project.rotors, chosen));
  pieces.probes = std::make_shared<std::vector<Probe>>(picked(*project.probes, chosen));
  pieces.cameras = std::make_shared<std::vector<Camera>>(picked(*project.cameras, chosen));
  return pieces;
}

DuplicateResult duplicateEdit(const Project& project, std::span<const Id> ids, glm::vec2 offset) {
  IdMap map;
  DuplicateResult result{copyEdit(project, extract(project, ids), offset, map), {}};
  result.edit.label = "Duplicate";
  for (const Id id : ids) {
    if (const auto copy = map.find(id); copy != map.end()) result.ids.push_back(copy->second);
  }
  return result;
}

DuplicateResult insertProjectEdit(const Project& project, const Project& pieces, glm::vec2 offset) {
  IdMap map;
  DuplicateResult result{copyEdit(project, pieces, offset, map), {}};
  result.edit.label = "Paste";
  const auto collect = [&](const auto& records) {
    for (const auto& record : records) result.ids.push_back(map[record.id]);
  };
  collect(pieces.graph->points);
  collect(pieces.graph->arrows);
  collect(*pieces.obstacles);
  collect(*pieces.species);
  collect(*pieces.colliders);
  collect(*pieces.surfaces);
  collect(*pieces.rotors);
  collect(*pieces.probes);
  collect(*pieces.cameras);
  return result;
}

}  // namespace windloom::editor
