#include "engine/model/validate.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "engine/core/text.hpp"
#include "engine/model/asset_names.hpp"
#include "engine/model/id_index.hpp"
#include "engine/model/outline.hpp"
#include "engine/model/parameters.hpp"

namespace windloom {
namespace {

using Problems = std::vector<Problem>;

void add(Problems& problems, std::string pointer, std::string message) {
  problems.push_back({{}, std::move(pointer), std::move(message)});
}

std::string at(const char* list, std::size_t index, std::string_view key = {}) {
  std::string pointer = std::string(list) + "/" + std::to_string(index);
  if (!key.empty()) pointer += "/" + std::string(key);
  return pointer;
}

/// `where` makes the pointer of the owner; called only for a problem.
template <class Owner, class Where>
void checkParameters(Problems& problems, const Owner& owner, Where&& where) {
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    std::string message = parameterProblem(parameter.info, parameter.get(owner));
    if (!message.empty()) add(problems, where() + "/" + std::string(parameter.info.key), std::move(message));
  }
}

template <class Owner>
void checkPart(Problems& problems, const Owner& part, const char* pointer) {
  checkParameters(problems, part, [pointer] { return std::string(pointer); });
}

/// A record that stands in `valid` at the same place as it is needs no reading; `valid` may be null.
template <class Record>
void checkRecords(Problems& problems, const std::vector<Record>& records, const std::vector<Record>* valid,
                  const char* list, std::size_t limit) {
  if (records.size() > limit) {
    add(problems, list, "holds " + std::to_string(records.size()) + ", expected at most " + std::to_string(limit));
    return;
  }
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (valid != nullptr && i < valid->size() && records[i] == (*valid)[i]) continue;
    checkParameters(problems, records[i], [&] { return at(list, i); });
  }
}

void checkBorders(Problems& problems, const FieldSettings& field) {
  const auto pair = [&](Border low, Border high, const char* lowKey, const char* highKey) {
    if ((low == Border::Periodic) == (high == Border::Periodic)) return;
    const bool lowLacks = low != Border::Periodic;
    add(problems, std::string("/field/borders/") + (lowLacks ? lowKey : highKey),
        std::string("is not periodic, but the opposite side ") + (lowLacks ? highKey : lowKey) +
            " is: expected both or neither");
  };
  pair(field.xMin, field.xMax, "xMin", "xMax");
  pair(field.zMin, field.zMax, "zMin", "zMax");
}

std::string missingPoint(Id id) {
  return "there is no point " + std::to_string(id);
}

std::string endsOf(const Arrow& arrow) {
  return std::to_string(arrow.from) + " and " + std::to_string(arrow.to);
}

/// For each arrow the first one with the same ends; itself where there is none before it.
std::vector<std::uint32_t> firstTwins(const std::vector<Arrow>& arrows) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> byEnds(arrows.size());
  std::vector<std::uint32_t> twins(arrows.size());
  for (std::uint32_t i = 0; i < arrows.size(); ++i) {
    byEnds[i] = {std::uint64_t{arrows[i].from} << 32 | arrows[i].to, i};
    twins[i] = i;
  }
  std::ranges::sort(byEnds);
  for (std::size_t k = 1; k < byEnds.size(); ++k) {
    if (byEnds[k].first == byEnds[k - 1].first) twins[byEnds[k].second] = twins[byEnds[k - 1].second];
  }
  return twins;
}

void checkArrows(Problems& problems, const WindGraph& graph, const IdIndex& points) {
  const std::vector<std::uint32_t> twins = firstTwins(graph.arrows);
  for (std::size_t i = 0; i < graph.arrows.size(); ++i) {
    const Arrow& arrow = graph.arrows[i];
    const auto from = points.find(arrow.from);
    const auto to = points.find(arrow.to);
    if (!from) add(problems, at("/graph/arrows", i, "from"), missingPoint(arrow.from));
    if (!to) add(problems, at("/graph/arrows", i, "to"), missingPoint(arrow.to));
    if (!from || !to) continue;
    if (arrow.from == arrow.to) {
      add(problems, at("/graph/arrows", i, "to"), "is the point the arrow begins at, expected another one");
    } else if (glm::distance(graph.points[*from].position, graph.points[*to].position) < kMinArrowLengthM) {
      add(problems, at("/graph/arrows", i),
          "has no length: points " + endsOf(arrow) + " lie at the same place, expected at least " +
              shortest(kMinArrowLengthM) + " m between them");
    } else if (twins[i] != i) {
      add(problems, at("/graph/arrows", i),
          "joins points " + endsOf(arrow) + " as arrow " + std::to_string(graph.arrows[twins[i]].id) + " already does");
    }
  }
}

void checkKeys(Problems& problems, const Signal& signal, std::size_t index) {
  if (signal.keys.size() > kMaxSignalKeys) {
    add(problems, at("/graph/signals", index, "keys"),
        "holds " + std::to_string(signal.keys.size()) + ", expected at most " + std::to_string(kMaxSignalKeys));
    return;
  }
  const bool looped = signal.loop && signal.kind == SignalKind::Curve;
  for (std::size_t k = 0; k < signal.keys.size(); ++k) {
    const SignalKey& key = signal.keys[k];
    const auto keyProblem = [&](const std::string& message) {
      add(problems, at("/graph/signals", index, "keys") + "/" + std::to_string(k), message);
    };
    const std::string problem = signalKeyProblem(key);
    if (!problem.empty()) {
      keyProblem(problem);
    } else if (k > 0 && !(key.time > signal.keys[k - 1].time)) {
      keyProblem("is not later than the key before it");
    } else if (looped && key.time > signal.period) {
      keyProblem("is later than the period of " + shortest(signal.period) + " s after which the curve repeats");
    }
  }
  if (looped && signal.keys.size() > 1 && signal.keys.front().time <= 0 && signal.keys.back().time >= signal.period &&
      signal.keys.front().value != signal.keys.back().value) {
    add(problems, at("/graph/signals", index, "keys"),
        "jumps when it repeats: expected the same value at 0 s and at the period");
  }
}

void checkSignals(Problems& problems, const std::vector<Signal>& signals, const IdIndex& points) {
  std::unordered_map<Id, std::size_t> byRoot;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (!points.find(signals[i].root)) {
      add(problems, at("/graph/signals", i, "root"), missingPoint(signals[i].root));
    }
    const auto [other, fresh] = byRoot.emplace(signals[i].root, i);
    if (!fresh) {
      add(problems, at("/graph/signals", i, "root"),
          "point " + std::to_string(signals[i].root) + " has a signal already, at " +
              at("/graph/signals", other->second));
    }
    checkKeys(problems, signals[i], i);
  }
}

void checkGraph(Problems& problems, const WindGraph& graph, const WindGraph* valid) {
  checkRecords(problems, graph.points, valid ? &valid->points : nullptr, "/graph/points", kMaxPoints);
  checkRecords(problems, graph.arrows, valid ? &valid->arrows : nullptr, "/graph/arrows", kMaxArrows);
  checkRecords(problems, graph.signals, valid ? &valid->signals : nullptr, "/graph/signals", kMaxPoints);
  if (graph.points.size() > kMaxPoints || graph.arrows.size() > kMaxArrows) return;
  const IdIndex points(graph.points);
  checkArrows(problems, graph, points);
  checkSignals(problems, graph.signals, points);
}

/// Corners are checked where the outline is one, and wherever there are any: what is kept must be legal when the
/// shape comes back to it.
void checkObstacles(Problems& problems, const std::vector<Obstacle>& obstacles, const std::vector<Obstacle>* valid) {
  checkRecords(problems, obstacles, valid, "/obstacles", kMaxObstacles);
  for (std::size_t i = 0; i < obstacles.size() && i < kMaxObstacles; ++i) {
    if (valid != nullptr && i < valid->size() && obstacles[i] == (*valid)[i]) continue;
    if (obstacles[i].shape != ObstacleShape::Polygon && obstacles[i].points.empty()) continue;
    const auto problem = polygonProblem(obstacles[i].points);
    if (!problem) continue;
    std::string pointer = at("/obstacles", i, "points");
    if (problem->corner) pointer.append("/").append(std::to_string(*problem->corner));
    add(problems, std::move(pointer), problem->message);
  }
}

void checkFile(Problems& problems, const std::string& file, bool needed, const char* missing, auto&& where) {
  std::string message = assetFileProblem(file);
  if (message.empty() && file.empty() && needed) message = std::string("is missing, expected ") + missing;
  if (!message.empty()) add(problems, where(), std::move(message));
}

void checkSpecies(Problems& problems, const std::vector<Species>& species, const std::vector<Species>* valid) {
  checkRecords(problems, species, valid, "/species", kMaxSpecies);
  for (std::size_t i = 0; i < species.size() && i < kMaxSpecies; ++i) {
    checkFile(problems, species[i].file, species[i].shape == PlantShape::Mesh, "the glTF file of the plant",
              [&] { return at("/species", i, "file"); });
  }
}

void checkPath(Problems& problems, const std::vector<ColliderKey>& keys, std::size_t index) {
  const std::string list = at("/colliders", index, "keys");
  if (keys.size() > kMaxColliderKeys) {
    add(problems, list,
        "holds " + std::to_string(keys.size()) + ", expected at most " + std::to_string(kMaxColliderKeys));
    return;
  }
  for (std::size_t k = 0; k < keys.size(); ++k) {
    std::string problem = colliderKeyProblem(keys[k]);
    if (problem.empty() && k > 0 && !(keys[k].time > keys[k - 1].time)) {
      problem = "is not later than the key before it";
    }
    if (!problem.empty()) add(problems, list + "/" + std::to_string(k), std::move(problem));
  }
}

void checkColliders(Problems& problems, const std::vector<Collider>& colliders, const std::vector<Collider>* valid) {
  checkRecords(problems, colliders, valid, "/colliders", kMaxColliders);
  for (std::size_t i = 0; i < colliders.size() && i < kMaxColliders; ++i) {
    if (valid != nullptr && i < valid->size() && colliders[i] == (*valid)[i]) continue;
    checkFile(problems, colliders[i].file, colliders[i].shape == ColliderShape::Mesh, "the glTF file of the object",
              [&] { return at("/colliders", i, "file"); });
    checkPath(problems, colliders[i].keys, i);
  }
}

void checkSurfaces(Problems& problems, const std::vector<Surface>& surfaces, const std::vector<Surface>* valid) {
  checkRecords(problems, surfaces, valid, "/surfaces", kMaxSurfaces);
  for (std::size_t i = 0; i < surfaces.size() && i < kMaxSurfaces; ++i) {
    checkFile(problems, surfaces[i].file, surfaces[i].shape == SurfaceShape::Mesh, "the glTF file of the surface",
              [&] { return at("/surfaces", i, "file"); });
  }
}

/// Shorter directions have no certain way; the length itself means nothing.
constexpr float kLeastDirection = 1e-6f;

void checkBezier(Problems& problems, const BezierSettings& bezier) {
  const std::size_t before = problems.size();
  checkPart(problems, bezier, "/bezier");
  if (problems.size() == before && glm::length(bezier.gravityDirection) < kLeastDirection) {
    add(problems, "/bezier/gravity/direction", "has no length, expected a direction: [0, -1, 0] is down");
  }
}

void checkShell(Problems& problems, const ShellSettings& shell) {
  checkPart(problems, shell, "/shell");
  checkFile(problems, shell.texture, false, "", [] { return std::string("/shell/texture/file"); });
}

void checkGrass(Problems& problems, const GrassSettings& grass) {
  checkPart(problems, grass, "/grass");
  const auto map = [&](const std::string& file, const char* place) {
    checkFile(problems, file, false, "", [place] { return std::string(place); });
  };
  map(grass.densityMap, "/grass/maps/density");
  map(grass.heightMap, "/grass/maps/height");
  map(grass.colourMap, "/grass/maps/colour");
}

void checkCameras(Problems& problems, const std::vector<Camera>& cameras) {
  checkRecords<Camera>(problems, cameras, nullptr, "/cameras", kMaxCameras);
  for (std::size_t i = 0; i < cameras.size() && i < kMaxCameras; ++i) {
    if (glm::distance(cameras[i].position, cameras[i].target) < 1e-3f) {
      add(problems, at("/cameras", i, "target"), "is the place of the camera itself, expected a place to look at");
    }
  }
}

struct IdPlace {
  Id id;
  const char* list;
  std::size_t index;
};

std::vector<IdPlace> idPlaces(const Project& project) {
  std::vector<IdPlace> places;
  places.reserve(project.graph->points.size() + project.graph->arrows.size() + project.obstacles->size() +
                 project.species->size() + project.colliders->size() + project.surfaces->size() +
                 project.rotors->size() + project.probes->size() + project.cameras->size());
  const auto take = [&](const auto& records, const char* list) {
    for (std::size_t i = 0; i < records.size(); ++i) places.push_back({records[i].id, list, i});
  };
  take(project.graph->points, "/graph/points");
  take(project.graph->arrows, "/graph/arrows");
  take(*project.obstacles, "/obstacles");
  take(*project.species, "/species");
  take(*project.colliders, "/colliders");
  take(*project.surfaces, "/surfaces");
  take(*project.rotors, "/rotors");
  take(*project.probes, "/probes");
  take(*project.cameras, "/cameras");
  return places;
}

/// Ids are unique over all kinds of records.
void checkIds(Problems& problems, const Project& project) {
  const std::vector<IdPlace> places = idPlaces(project);
  const IdIndex firsts(places);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t first = firsts.find(places[i].id).value_or(static_cast<std::uint32_t>(i));
    if (first == i || places[i].id == 0) continue;
    add(problems, at(places[i].list, places[i].index, "id"),
        "id " + std::to_string(places[i].id) + " is used already, at " + at(places[first].list, places[first].index));
  }
}

void checkBlades(Problems& problems, const Project& project) {
  const double area = static_cast<double>(project.field->size.x) * static_cast<double>(project.field->size.y);
  const double blades = static_cast<double>(project.grass->density) * area;
  if (!(blades > kMaxBlades)) return;
  add(problems, "/grass/density",
      "makes " + fixed(blades / 1e6, 0) + " million blades on this field, expected at most " +
          fixed(kMaxBlades / 1e6, 0) + " million");
}

void checkTerrain(Problems& problems, const TerrainSettings& terrain) {
  checkPart(problems, terrain, "/terrain");
  checkFile(problems, terrain.file, terrain.kind != TerrainKind::Flat,
            "the picture or mesh that this kind of ground is made from", [] { return std::string("/terrain/file"); });
}

/// A file may say what it likes, since nothing outside is read before the user allows it; edits and what is pasted
/// bring no new names of this kind in.
void checkNewFiles(Problems& problems, const Project& project, const Project& valid) {
  const std::vector<AssetName> old = assetNames(valid);
  for (const AssetName& name : assetNames(project)) {
    const std::string_view reason = outsideReason(name.file);
    if (reason.empty() || std::ranges::find(old, name.file, &AssetName::file) != old.end()) continue;
    add(problems, name.pointer,
        "found '" + name.file + "', " + std::string(reason) + ": expected a path below the project's folder");
  }
}

Problems validateParts(const Project& project, const Project* valid) {
  Problems problems;
  const auto changed = [&](auto part) { return valid == nullptr || project.*part != valid->*part; };
  if (changed(&Project::name)) {
    std::string message = parameterProblem(kProjectName, project.name);
    if (!message.empty()) add(problems, "/name", std::move(message));
  }
  if (changed(&Project::field)) {
    checkPart(problems, *project.field, "/field");
    checkBorders(problems, *project.field);
  }
  if (changed(&Project::solver)) checkPart(problems, *project.solver, "/solver");
  if (changed(&Project::ambient)) checkPart(problems, *project.ambient, "/ambient");
  if (changed(&Project::graph)) checkGraph(problems, *project.graph, valid ? valid->graph.get() : nullptr);
  if (changed(&Project::obstacles))
    checkObstacles(problems, *project.obstacles, valid ? valid->obstacles.get() : nullptr);
  if (changed(&Project::terrain)) checkTerrain(problems, *project.terrain);
  if (changed(&Project::grass)) checkGrass(problems, *project.grass);
  if (changed(&Project::bezier)) checkBezier(problems, *project.bezier);
  if (changed(&Project::shell)) checkShell(problems, *project.shell);
  if (changed(&Project::species)) checkSpecies(problems, *project.species, valid ? valid->species.get() : nullptr);
  if (changed(&Project::colliders))
    checkColliders(problems, *project.colliders, valid ? valid->colliders.get() : nullptr);
  if (changed(&Project::surfaces)) checkSurfaces(problems, *project.surfaces, valid ? valid->surfaces.get() : nullptr);
  if (changed(&Project::rotors))
    checkRecords(problems, *project.rotors, valid ? valid->rotors.get() : nullptr, "/rotors", kMaxRotors);
  if (changed(&Project::probes))
    checkRecords(problems, *project.probes, valid ? valid->probes.get() : nullptr, "/probes", kMaxProbes);
  if (changed(&Project::cameras)) checkCameras(problems, *project.cameras);
  const bool files = changed(&Project::terrain) || changed(&Project::grass) || changed(&Project::shell) ||
                     changed(&Project::species) || changed(&Project::colliders) || changed(&Project::surfaces);
  if (valid != nullptr && files) checkNewFiles(problems, project, *valid);
  if (changed(&Project::field) || changed(&Project::grass)) checkBlades(problems, project);
  if (changed(&Project::graph) || changed(&Project::obstacles) || changed(&Project::species) ||
      changed(&Project::colliders) || changed(&Project::surfaces) || changed(&Project::rotors) ||
      changed(&Project::probes) || changed(&Project::cameras)) {
    checkIds(problems, project);
  }
  return problems;
}

}  // namespace

std::string signalKeyProblem(const SignalKey& key) {
  const bool time = std::isfinite(key.time) && key.time >= 0 && key.time <= kMaxSignalKeyTimeS;
  const bool value = std::isfinite(key.value) && key.value >= 0 && key.value <= kMaxSignalKeyValue;
  if (time && value) return {};
  return std::string(time ? "its value" : "its time") +
         " is out of range: expected [time, value] with a time from 0 to " + shortest(kMaxSignalKeyTimeS) +
         " (s) and a value from 0 to " + shortest(kMaxSignalKeyValue);
}

std::string colliderKeyProblem(const ColliderKey& key) {
  const auto near = [](float value) { return std::isfinite(value) && std::abs(value) <= kMaxColliderOffsetM; };
  const bool time = std::isfinite(key.time) && key.time >= 0 && key.time <= kMaxColliderKeyTimeS;
  if (time && near(key.offset.x) && near(key.offset.y) && near(key.offset.z)) return {};
  return std::string(time ? "its offset" : "its time") +
         " is out of range: expected [time, x, height, z] with a time from 0 to " + shortest(kMaxColliderKeyTimeS) +
         " (s) and an offset from " + shortest(-kMaxColliderOffsetM) + " to " + shortest(kMaxColliderOffsetM) + " (m)";
}

std::vector<Problem> validate(const Project& project) {
  return validateParts(project, nullptr);
}

std::vector<Problem> validateChange(const Project& project, const Project& valid) {
  return validateParts(project, &valid);
}

}  // namespace windloom
