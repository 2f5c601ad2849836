#include "editor/core/inspector.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <unordered_set>

#include "editor/core/id_index.hpp"
#include "editor/core/inspector_relevance.hpp"
#include "editor/core/selection.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/outline.hpp"
#include "engine/model/parameters.hpp"

namespace windloom::editor {
namespace {

// How the owners of one kind are read from a project and put back.
template <class Owner, auto Part>
struct PartAccess {
  static std::vector<Owner> read(const Project& project, const std::vector<Id>&) { return {*(project.*Part)}; }
  static EditStep write(Owner owner) { return Set<Owner>{std::move(owner)}; }
};

template <class Owner>
struct RecordAccess {
  static std::vector<Owner> read(const Project& project, const std::vector<Id>& ids) {
    const std::unordered_set<Id> wanted(ids.begin(), ids.end());
    std::vector<Owner> owners;
    for (const Owner& record : records(project)) {
      if (wanted.contains(record.id)) owners.push_back(record);
    }
    return owners;
  }
  static EditStep write(Owner owner) { return Put<Owner>{std::move(owner)}; }
  static const std::vector<Owner>& records(const Project& project) {
    if constexpr (std::is_same_v<Owner, Point>)
      return project.graph->points;
    else if constexpr (std::is_same_v<Owner, Arrow>)
      return project.graph->arrows;
    else if constexpr (std::is_same_v<Owner, Obstacle>)
      return *project.obstacles;
    else if constexpr (std::is_same_v<Owner, Species>)
      return *project.species;
    else if constexpr (std::is_same_v<Owner, Collider>)
      return *project.colliders;
    else if constexpr (std::is_same_v<Owner, Surface>)
      return *project.surfaces;
    else if constexpr (std::is_same_v<Owner, Rotor>)
      return *project.rotors;
    else if constexpr (std::is_same_v<Owner, Probe>)
      return *project.probes;
    else
      return *project.cameras;
  }
};

/// A root without a signal plays the default, so it has one to show and to change.
struct SignalAccess {
  static std::vector<Signal> read(const Project& project, const std::vector<Id>& ids) {
    std::vector<Signal> signals;
    for (const Id id : ids) {
      if (!findPoint(*project.graph, id)) continue;
      const Signal* found = findSignal(*project.graph, id);
      signals.push_back(found ? *found : Signal{});
      signals.back().root = id;
    }
    return signals;
  }
  static EditStep write(Signal signal) { return Put<Signal>{std::move(signal)}; }
};

/// Calls `work.operator()<Owner, Access>()` for the kind.
template <class Work>
auto forKind(InspectorKind kind, Work&& work) {
  switch (kind) {
    case InspectorKind::Solver:
      return work.template operator()<SolverSettings, PartAccess<SolverSettings, &Project::solver>>();
    case InspectorKind::Ambient:
      return work.template operator()<AmbientWind, PartAccess<AmbientWind, &Project::ambient>>();
    case InspectorKind::Terrain:
      return work.template operator()<TerrainSettings, PartAccess<TerrainSettings, &Project::terrain>>();
    case InspectorKind::Grass:
      return work.template operator()<GrassSettings, PartAccess<GrassSettings, &Project::grass>>();
    case InspectorKind::Bezier:
      return work.template operator()<BezierSettings, PartAccess<BezierSettings, &Project::bezier>>();
    case InspectorKind::Shell:
      return work.template operator()<ShellSettings, PartAccess<ShellSettings, &Project::shell>>();
    case InspectorKind::Point:
      return work.template operator()<Point, RecordAccess<Point>>();
    case InspectorKind::Arrow:
      return work.template operator()<Arrow, RecordAccess<Arrow>>();
    case InspectorKind::Signal:
      return work.template operator()<Signal, SignalAccess>();
    case InspectorKind::Obstacle:
      return work.template operator()<Obstacle, RecordAccess<Obstacle>>();
    case InspectorKind::Species:
      return work.template operator()<Species, RecordAccess<Species>>();
    case InspectorKind::Collider:
      return work.template operator()<Collider, RecordAccess<Collider>>();
    case InspectorKind::Surface:
      return work.template operator()<Surface, RecordAccess<Surface>>();
    case InspectorKind::Rotor:
      return work.template operator()<Rotor, RecordAccess<Rotor>>();
    case InspectorKind::Probe:
      return work.template operator()<Probe, RecordAccess<Probe>>();
    case InspectorKind::Camera:
      return work.template operator()<Camera, RecordAccess<Camera>>();
    case InspectorKind::Field:
      break;
  }
  return work.template operator()<FieldSettings, PartAccess<FieldSettings, &Project::field>>();
}

void markMixed(InspectorRow& row, const ParameterValue& other) {
  if (row.value == other) return;
  row.mixed = true;
  std::visit(
      [&](const auto& first) {
        using V = std::decay_t<decltype(first)>;
        if constexpr (std::is_same_v<V, glm::vec2> || std::is_same_v<V, glm::vec3> || std::is_same_v<V, glm::ivec2>) {
          const V& second = std::get<V>(other);
          for (int i = 0; i < V::length(); ++i) row.mixedComponent[i] = row.mixedComponent[i] || first[i] != second[i];
        }
      },
      row.value);
}

template <class Owner, class Access>
InspectorSection makeSection(const Project& project, const InspectorTarget& target) {
  InspectorSection section{target, {}, {}};
  const std::vector<Owner> owners = Access::read(project, target.ids);
  if (owners.empty()) return section;
  const Owner standard{};
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    InspectorRow row{parameter.info, parameter.get(owners.front()), parameter.get(standard)};
    row.editable = parameter.info.type != ParameterType::Id;
    row.relevant = false;
    for (const Owner& owner : owners) {
      markMixed(row, parameter.get(owner));
      row.relevant = row.relevant || isRelevant(owner, parameter.info.key);
    }
    section.rows.push_back(std::move(row));
  }
  return section;
}

std::string titleOf(const Project& project, const InspectorTarget& target) {
  switch (target.kind) {
    case InspectorKind::Field:
      return "Field";
    case InspectorKind::Solver:
      return "Solver";
    case InspectorKind::Ambient:
      return "Ambient wind";
    case InspectorKind::Terrain:
      return "Terrain";
    case InspectorKind::Grass:
      return "Grass";
    case InspectorKind::Bezier:
      return "Bezier grass";
    case InspectorKind::Shell:
      return "Shell grass";
    case InspectorKind::Signal:
      break;
    default:
      return describeIds(project, target.ids);
  }
  if (target.ids.size() != 1) return "Signals of " + std::to_string(target.ids.size()) + " roots";
  const std::string name = nameOf(project, target.ids[0]);
  return "Signal of " + (name.empty() ? "point " + std::to_string(target.ids[0]) : name);
}

std::string mergeKey(const InspectorTarget& target, std::string_view key) {
  std::uint64_t hash = 14695981039346656037ull;  // FNV-1a over the ids
  for (const Id id : target.ids) hash = (hash ^ id) * 1099511628211ull;
  return "set:" + std::to_string(static_cast<int>(target.kind)) + ":" + std::string(key) + ":" + std::to_string(hash);
}

/// An obstacle that becomes a polygon begins with the outline that it has.
void giveCorners(Obstacle& obstacle, std::string_view key, const ParameterValue& value) {
  if (key != "shape" || value != ParameterValue(static_cast<int>(ObstacleShape::Polygon))) return;
  if (!obstacle.points.empty()) return;
  constexpr int kCornersOfCircle = 16;
  for (const glm::vec2 corner : outlineOf(obstacle, kCornersOfCircle))
    obstacle.points.push_back(toOwn(obstacle, corner));
  if (obstacle.shape == ObstacleShape::Circle) obstacle.rotation = 0.0f;
}

/// `change` gives the new value of an owner's parameter; nothing is written where it is equal.
template <class Change>
Result<Edit> changeParameter(const Project& project, const InspectorTarget& target, std::string_view key,
                             Change change) {
  return forKind(target.kind, [&]<class Owner, class Access>() -> Result<Edit> {
    for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
      if (parameter.info.key != key) continue;
      std::string label(parameter.info.label);
      Edit edit;
      edit.label = "Set " + label;
      edit.label[4] = static_cast<char>(std::tolower(static_cast<unsigned char>(edit.label[4])));
      edit.mergeKey = mergeKey(target, key);
      for (Owner& owner : Access::read(project, target.ids)) {
        const ParameterValue before = parameter.get(owner);
        const ParameterValue after = change(parameter.info, before);
        if (after.index() != before.index()) {
          return makeError(ErrorKind::BadInput, label + ": expected " + parameterExpectation(parameter.info));
        }
        const std::string problem = parameterProblem(parameter.info, after);
        if (!problem.empty()) return makeError(ErrorKind::BadInput, label + ": " + problem);
        if (after == before) continue;
        if constexpr (std::is_same_v<Owner, Obstacle>) giveCorners(owner, key, after);
        parameter.set(owner, after);
        edit.steps.push_back(Access::write(std::move(owner)));
      }
      return edit;
    }
    return makeError(ErrorKind::BadInput, "there is no parameter '" + std::string(key) + "'");
  });
}

const ParameterInfo* infoOf(InspectorKind kind, std::string_view key) {
  return forKind(kind, [&]<class Owner, class Access>() -> const ParameterInfo* {
    for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
      if (parameter.info.key == key) return &parameter.info;
    }
    return nullptr;
  });
}

template <class V>
ParameterValue withComponent(V vector, int component, double value) {
  using Scalar = typename V::value_type;
  if constexpr (std::is_integral_v<Scalar>) value = std::clamp(std::round(value), -2147483648.0, 2147483647.0);
  if (component >= 0 && component < V::length()) vector[component] = static_cast<Scalar>(value);
  return vector;
}

}  // namespace

InspectorSection inspect(const Project& project, const InspectorTarget& target) {
  InspectorSection section =
      forKind(target.kind, [&]<class Owner, class Access>() { return makeSection<Owner, Access>(project, target); });
  section.title = titleOf(project, target);
  return section;
}

std::vector<InspectorSection> inspectSelection(const Project& project, std::span<const Id> ids) {
  InspectorTarget points{InspectorKind::Point}, arrows{InspectorKind::Arrow}, obstacles{InspectorKind::Obstacle},
      species{InspectorKind::Species}, colliders{InspectorKind::Collider}, surfaces{InspectorKind::Surface},
      rotors{InspectorKind::Rotor}, probes{InspectorKind::Probe}, cameras{InspectorKind::Camera},
      signals{InspectorKind::Signal};
  const IdIndex index(project);
  for (const Id id : ids) {
    const auto place = index.find(id);
    if (!place) continue;
    InspectorTarget& target = place->kind == ObjectKind::Point      ? points
                              : place->kind == ObjectKind::Arrow    ? arrows
                              : place->kind == ObjectKind::Obstacle ? obstacles
                              : place->kind == ObjectKind::Species  ? species
                              : place->kind == ObjectKind::Collider ? colliders
                              : place->kind == ObjectKind::Surface  ? surfaces
                              : place->kind == ObjectKind::Rotor    ? rotors
                              : place->kind == ObjectKind::Probe    ? probes
                                                                    : cameras;
    target.ids.push_back(id);
  }
  if (!points.ids.empty() || !arrows.ids.empty()) {
    const std::vector<Arrival> arrivals = GraphEvaluator(*project.graph).arrivals();
    std::unordered_set<Id> seen;
    const auto add = [&](Id root) {
      if (root != 0 && seen.insert(root).second) signals.ids.push_back(root);
    };
    const std::vector<Id> roots = findRoots(*project.graph);
    for (const Id id : points.ids) {
      if (std::binary_search(roots.begin(), roots.end(), id)) add(id);
    }
    for (const Id id : arrows.ids) add(arrivals[index.find(index.arrow(id)->from)->index].root);
  }
  std::vector<InspectorSection> sections;
  for (const InspectorTarget* target :
       {&points, &arrows, &signals, &obstacles, &species, &colliders, &surfaces, &rotors, &probes, &cameras}) {
    if (!target->ids.empty()) sections.push_back(inspect(project, *target));
  }
  return sections;
}

Result<Edit> setParameter(const Project& project, const InspectorTarget& target, std::string_view key,
                          const ParameterValue& value) {
  return changeParameter(project, target, key, [&](const ParameterInfo&, const ParameterValue&) { return value; });
}

Result<Edit> setComponent(const Project& project, const InspectorTarget& target, std::string_view key, int component,
                          double value) {
  return changeParameter(project, target, key, [&](const ParameterInfo&, ParameterValue old) -> ParameterValue {
    if (const auto* v = std::get_if<glm::vec2>(&old)) return withComponent(*v, component, value);
    if (const auto* v = std::get_if<glm::vec3>(&old)) return withComponent(*v, component, value);
    if (const auto* v = std::get_if<glm::ivec2>(&old)) return withComponent(*v, component, value);
    return old;
  });
}

Result<Edit> resetParameter(const Project& project, const InspectorTarget& target, std::string_view key) {
  std::optional<ParameterValue> standard = forKind(target.kind, [&]<class Owner, class Access>() {
    std::optional<ParameterValue> found;
    for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
      if (parameter.info.key == key) found = parameter.get(Owner{});
    }
    return found;
  });
  if (!standard) return makeError(ErrorKind::BadInput, "there is no parameter '" + std::string(key) + "'");
  return setParameter(project, target, key, *standard);
}

Result<Edit> setFromText(const Project& project, const InspectorTarget& target, std::string_view key,
                         std::string_view text, int component) {
  const ParameterInfo* info = infoOf(target.kind, key);
  if (!info) return makeError(ErrorKind::BadInput, "there is no parameter '" + std::string(key) + "'");
  const bool vector =
      info->type == ParameterType::Real2 || info->type == ParameterType::Real3 || info->type == ParameterType::Integer2;
  if (vector && component >= 0) {
    const Result<double> number = numberFromText(*info, text);
    if (!number) return number.error();
    return setComponent(project, target, key, component, *number);
  }
  const Result<ParameterValue> value = valueFromText(*info, text);
  if (!value) return value.error();
  return setParameter(project, target, key, *value);
}

}  // namespace windloom::editor
