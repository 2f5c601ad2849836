#include "engine/model/validate.hpp"

#include <cmath>
#include <unordered_map>

#include "engine/core/text.hpp"
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

template <class Record>
void checkRecords(Problems& problems, const std::vector<Record>& records, const char* list, std::size_t limit) {
  if (records.size() > limit) {
    add(problems, list, "holds " + std::to_string(records.size()) + ", expected at most " + std::to_string(limit));
    return;
  }
  for (std::size_t i = 0; i < records.size(); ++i) {
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

using Places = std::unordered_map<Id, const Point*>;

std::string pointProblem(const Places& points, Id id) {
  return points.contains(id) ? std::string() : "there is no point " + std::to_string(id);
}

void checkArrows(Problems& problems, const std::vector<Arrow>& arrows, const Places& points) {
  std::unordered_map<std::uint64_t, std::size_t> byEnds;
  byEnds.reserve(arrows.size());
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    const Arrow& arrow = arrows[i];
    const auto from = points.find(arrow.from);
    const auto to = points.find(arrow.to);
    if (from == points.end()) add(problems, at("/graph/arrows", i, "from"), pointProblem(points, arrow.from));
    if (to == points.end()) add(problems, at("/graph/arrows", i, "to"), pointProblem(points, arrow.to));
    if (from == points.end() || to == points.end()) continue;
    if (arrow.from == arrow.to) {
      add(problems, at("/graph/arrows", i, "to"), "is the point the arrow begins at, expected another one");
      continue;
    }
    if (glm::distance(from->second->position, to->second->position) < kMinArrowLengthM) {
      add(problems, at("/graph/arrows", i),
          "has no length: points " + std::to_string(arrow.from) + " and " + std::to_string(arrow.to) +
              " lie at the same place, expected at least " + shortest(kMinArrowLengthM) + " m between them");
    }
    const auto [other, fresh] = byEnds.emplace(std::uint64_t{arrow.from} << 32 | arrow.to, i);
    if (!fresh) {
      add(problems, at("/graph/arrows", i),
          "leads from " + std::to_string(arrow.from) + " to " + std::to_string(arrow.to) + " as arrow " +
              std::to_string(arrows[other->second].id) + " already does");
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

void checkSignals(Problems& problems, const std::vector<Signal>& signals, const Places& points) {
  std::unordered_map<Id, std::size_t> byRoot;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const std::string missing = pointProblem(points, signals[i].root);
    if (!missing.empty()) add(problems, at("/graph/signals", i, "root"), missing);
    const auto [other, fresh] = byRoot.emplace(signals[i].root, i);
    if (!fresh) {
      add(problems, at("/graph/signals", i, "root"),
          "point " + std::to_string(signals[i].root) + " has a signal already, at " +
              at("/graph/signals", other->second));
    }
    checkKeys(problems, signals[i], i);
  }
}

void checkGraph(Problems& problems, const WindGraph& graph) {
  checkRecords(problems, graph.points, "/graph/points", kMaxPoints);
  checkRecords(problems, graph.arrows, "/graph/arrows", kMaxArrows);
  checkRecords(problems, graph.signals, "/graph/signals", kMaxPoints);
  if (graph.points.size() > kMaxPoints || graph.arrows.size() > kMaxArrows) return;
  Places points;
  points.reserve(graph.points.size());
  for (const Point& point : graph.points) points.emplace(point.id, &point);
  checkArrows(problems, graph.arrows, points);
  checkSignals(problems, graph.signals, points);
}

void checkCameras(Problems& problems, const std::vector<Camera>& cameras) {
  checkRecords(problems, cameras, "/cameras", kMaxCameras);
  for (std::size_t i = 0; i < cameras.size() && i < kMaxCameras; ++i) {
    if (glm::distance(cameras[i].position, cameras[i].target) < 1e-3f) {
      add(problems, at("/cameras", i, "target"), "is the place of the camera itself, expected a place to look at");
    }
  }
}

/// Ids are unique over all kinds of records.
class UsedIds {
 public:
  explicit UsedIds(const Project& project) {
    m_used.reserve(project.graph->points.size() + project.graph->arrows.size() + project.obstacles->size() +
                   project.probes->size() + project.cameras->size());
  }

  template <class Record>
  void take(Problems& problems, const std::vector<Record>& records, const char* list) {
    for (std::size_t i = 0; i < records.size(); ++i) {
      const auto [first, fresh] = m_used.emplace(records[i].id, Place{list, i});
      if (fresh || records[i].id == 0) continue;
      add(problems, at(list, i, "id"),
          "id " + std::to_string(records[i].id) + " is used already, at " +
              at(first->second.list, first->second.index));
    }
  }

 private:
  struct Place {
    const char* list;
    std::size_t index;
  };
  std::unordered_map<Id, Place> m_used;
};

void checkIds(Problems& problems, const Project& project) {
  UsedIds used(project);
  used.take(problems, project.graph->points, "/graph/points");
  used.take(problems, project.graph->arrows, "/graph/arrows");
  used.take(problems, *project.obstacles, "/obstacles");
  used.take(problems, *project.probes, "/probes");
  used.take(problems, *project.cameras, "/cameras");
}

void checkBlades(Problems& problems, const Project& project) {
  const double area = static_cast<double>(project.field->size.x) * static_cast<double>(project.field->size.y);
  const double blades = static_cast<double>(project.grass->density) * area;
  if (!(blades > kMaxBlades)) return;
  add(problems, "/grass/density",
      "makes " + fixed(blades / 1e6, 0) + " million blades on this field, expected at most " +
          fixed(kMaxBlades / 1e6, 0) + " million");
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
  if (changed(&Project::graph)) checkGraph(problems, *project.graph);
  if (changed(&Project::obstacles)) checkRecords(problems, *project.obstacles, "/obstacles", kMaxObstacles);
  if (changed(&Project::terrain)) checkPart(problems, *project.terrain, "/terrain");
  if (changed(&Project::grass)) checkPart(problems, *project.grass, "/grass");
  if (changed(&Project::probes)) checkRecords(problems, *project.probes, "/probes", kMaxProbes);
  if (changed(&Project::cameras)) checkCameras(problems, *project.cameras);
  if (changed(&Project::field) || changed(&Project::grass)) checkBlades(problems, project);
  if (changed(&Project::graph) || changed(&Project::obstacles) || changed(&Project::probes) ||
      changed(&Project::cameras)) {
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

std::vector<Problem> validate(const Project& project) {
  return validateParts(project, nullptr);
}

std::vector<Problem> validateChange(const Project& project, const Project& valid) {
  return validateParts(project, &valid);
}

}  // namespace windloom
