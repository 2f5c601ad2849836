#include <algorithm>
#include <array>

#include "engine/core/contract.hpp"
#include "engine/core/file.hpp"
#include "engine/core/text.hpp"
#include "engine/io/json_document.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/project_records.hpp"
#include "engine/model/parameters.hpp"
#include "engine/model/signal_curve.hpp"
#include "engine/model/validate.hpp"

namespace windloom {
namespace {

using Members = std::vector<std::string>;  // `"key": value`

constexpr std::size_t kLineWidth = 110;

std::string jsonText(std::string_view text) {
  return JsonDocument(text).dump();
}

/// -0 would be read back as the whole number 0 and so not be the same bytes again.
std::string number(float value) {
  return value == 0 ? "0" : shortest(value);
}

std::string arrayOf(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text.append(text.empty() ? "[" : ", ").append(part);
  return text.append("]");
}

std::string valueText(const ParameterInfo& info, const ParameterValue& value) {
  struct Visitor {
    const ParameterInfo& info;
    std::string operator()(float v) const { return number(v); }
    std::string operator()(int v) const {
      return info.type == ParameterType::Choice ? jsonText(info.choices[static_cast<std::size_t>(v)])
                                                : std::to_string(v);
    }
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(glm::vec2 v) const { return arrayOf({number(v.x), number(v.y)}); }
    std::string operator()(glm::vec3 v) const { return arrayOf({number(v.x), number(v.y), number(v.z)}); }
    std::string operator()(glm::ivec2 v) const { return arrayOf({std::to_string(v.x), std::to_string(v.y)}); }
    std::string operator()(const std::string& v) const { return jsonText(v); }
  };
  return std::visit(Visitor{info}, value);
}

std::string member(std::string_view key, std::string_view value) {
  return jsonText(key).append(": ").append(value);
}

/// Spaces after ',' and ':' as everywhere in the file.
std::string spaced(const JsonDocument& value) {
  if (!value.is_structured()) return value.dump();
  std::string text(value.is_array() ? "[" : "{");
  for (const auto& [key, part] : value.items()) {
    if (text.size() > 1) text += ", ";
    text += value.is_array() ? spaced(part) : member(key, spaced(part));
  }
  return text.append(value.is_array() ? "]" : "}");
}

JsonDocument parseExtra(const std::string& text) {
  if (text.empty()) return JsonDocument::object();
  JsonDocument extra = JsonDocument::parse(text, nullptr, false);
  WL_REQUIRE(extra.is_object(), "unknown keys are kept as the text of a JSON object");
  return extra;
}

std::string joined(const Members& members) {
  std::string text;
  for (const std::string& part : members) text.append(text.empty() ? "{" : ", ").append(part);
  return members.empty() ? "{}" : text.append("}");
}

// The list of a record that is in no parameter table, see kListKey.
std::vector<std::string> listParts(const Signal& signal) {
  std::vector<std::string> keys;
  for (const SignalKey& k : signal.keys) {
    std::vector<std::string> parts{number(k.time), number(k.value)};
    if (k.easing != Easing::Linear) parts.push_back(jsonText(kEasings[static_cast<std::size_t>(k.easing)]));
    keys.push_back(arrayOf(parts));
  }
  return keys;
}
std::vector<std::string> listParts(const Obstacle& obstacle) {
  std::vector<std::string> points;
  for (const glm::vec2 p : obstacle.points) points.push_back(arrayOf({number(p.x), number(p.y)}));
  return points;
}
std::vector<std::string> listParts(const Collider& collider) {
  std::vector<std::string> keys;
  for (const ColliderKey& k : collider.keys)
    keys.push_back(arrayOf({number(k.time), number(k.offset.x), number(k.offset.y), number(k.offset.z)}));
  return keys;
}

/// The parameters for which `wanted` is true, nested ones as one member with an object, then the unknown keys.
template <class Owner, class Wanted>
Members membersOf(const Owner& owner, Wanted&& wanted) {
  JsonDocument extra = parseExtra(owner.extra);
  Members members;
  const auto table = parametersOf<Owner>();
  for (std::size_t i = 0; i < table.size();) {
    const std::string_view key = table[i].info.key;
    const std::size_t slash = key.find('/');
    if (slash == key.npos) {
      const ParameterValue value = table[i].get(owner);
      if (wanted(table[i], value)) members.push_back(member(key, valueText(table[i].info, value)));
      ++i;
      continue;
    }
    const std::string_view group = key.substr(0, slash);
    Members inner;
    for (; i < table.size() && table[i].info.key.starts_with(key.substr(0, slash + 1)); ++i) {
      const ParameterValue value = table[i].get(owner);
      if (!wanted(table[i], value)) continue;
      inner.push_back(member(table[i].info.key.substr(slash + 1), valueText(table[i].info, value)));
    }
    if (const auto unknown = extra.find(group); unknown != extra.end()) {
      for (const auto& [name, value] : unknown->items()) inner.push_back(member(name, spaced(value)));
      extra.erase(unknown);
    }
    if (!inner.empty()) members.push_back(member(group, joined(inner)));
  }
  if constexpr (!kListKey<Owner>.empty()) {
    if (const std::vector<std::string> parts = listParts(owner); !parts.empty())
      members.push_back(member(kListKey<Owner>, arrayOf(parts)));
  }
  for (const auto& [name, value] : extra.items()) members.push_back(member(name, spaced(value)));
  return members;
}

/// Keys that say what a record is and are written even when they have their default.
std::vector<std::string_view> tellingKeys(const Point&) {
  return {"id", "position"};
}
std::vector<std::string_view> tellingKeys(const Arrow&) {
  return {"id", "from", "to", "drive", "strength", "radius", "where"};
}
std::vector<std::string_view> tellingKeys(const Probe&) {
  return {"id", "position"};
}
std::vector<std::string_view> tellingKeys(const Camera&) {
  return {"id", "position", "target", "fieldOfView"};
}
std::vector<std::string_view> tellingKeys(const Obstacle& obstacle) {
  switch (obstacle.shape) {
    case ObstacleShape::Circle:
      return {"id", "shape", "centre", "radius"};
    case ObstacleShape::Box:
      return {"id", "shape", "centre", "size"};
    case ObstacleShape::Polygon:
      break;
  }
  return {"id", "shape", "centre"};
}
std::vector<std::string_view> tellingKeys(const Species& species) {
  if (species.shape == PlantShape::Mesh) return {"id", "shape", "file", "weight", "height"};
  return {"id", "shape", "weight", "height"};
}
std::vector<std::string_view> tellingKeys(const Collider& collider) {
  switch (collider.shape) {
    case ColliderShape::Sphere:
      return {"id", "shape", "position", "radius"};
    case ColliderShape::Capsule:
      return {"id", "shape", "position", "radius", "length"};
    case ColliderShape::Mesh:
      break;
  }
  return {"id", "shape", "position", "file"};
}
std::vector<std::string_view> tellingKeys(const Surface& surface) {
  return {"id", "shape", "position", surface.shape == SurfaceShape::Mesh ? "file" : "size", "density", "height"};
}
std::vector<std::string_view> tellingKeys(const Rotor&) {
  return {"id", "position", "lift", "radius", "speed"};
}
std::vector<std::string_view> tellingKeys(const Signal& signal) {
  switch (signal.kind) {
    case SignalKind::Constant:
      break;
    case SignalKind::Pulse:
      return {"root", "kind", "period", "on", "attack", "release"};
    case SignalKind::Gusts:
      return {"root", "kind", "attack", "depth", "rate", "seed"};
    case SignalKind::Curve:
      return {"root", "kind", "period", "attack", "loop"};
  }
  return {"root", "kind", "attack"};
}

template <class Record>
std::string recordText(const Record& record) {
  static const Record kDefault{};
  const std::vector<std::string_view> telling = tellingKeys(record);
  return joined(membersOf(record, [&](const Parameter<Record>& parameter, const ParameterValue& value) {
    return std::ranges::find(telling, parameter.info.key) != telling.end() || value != parameter.get(kDefault);
  }));
}

template <class Record>
std::string listText(const std::vector<Record>& records, const std::string& indent) {
  if (records.empty()) return "[]";
  std::string text = "[";
  for (const Record& record : records) {
    text.append(text.size() > 1 ? ",\n" : "\n").append(indent).append("  ").append(recordText(record));
  }
  return text.append("\n").append(indent).append("]");
}

/// A settings part on one line, or on several that line up behind its brace.
template <class Part>
std::string partText(std::string_view key, const Part& part) {
  static const Part kDefault{};
  const Members members = membersOf(part, [](const Parameter<Part>& parameter, const ParameterValue& value) {
    const std::string_view name = parameter.info.key;
    const bool changed = value != parameter.get(kDefault);
    // Most of the terrain's values, and maps, mean nothing to most projects.
    if constexpr (std::is_same_v<Part, TerrainSettings>) return changed || name == "kind" || name == "colour";
    return changed || parameter.info.type != ParameterType::Text;
  });
  const std::string start = "  " + jsonText(key) + ": {";
  std::string text = "{";
  std::size_t column = start.size();
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i > 0 && column + members[i].size() + 2 > kLineWidth) {
      text.append(",\n").append(start.size(), ' ');
      column = start.size();
    } else if (i > 0) {
      text += ", ";
      column += 2;
    }
    text += members[i];
    column += members[i].size();
  }
  return text.append("}");
}

std::string graphText(const WindGraph& graph) {
  Members members{member("points", listText(graph.points, "    ")), member("arrows", listText(graph.arrows, "    ")),
                  member("signals", listText(graph.signals, "    "))};
  const JsonDocument extra = parseExtra(graph.extra);
  for (const auto& [name, value] : extra.items()) members.push_back(member(name, spaced(value)));
  std::string text;
  for (const std::string& part : members) text.append(text.empty() ? "{\n    " : ",\n    ").append(part);
  return text.append("\n  }");
}

}  // namespace

std::string writeProject(const Project& project) {
  const JsonDocument extra = parseExtra(*project.extra);
  Members members{member("format", jsonText(kProjectFormat)), member("version", std::to_string(kProjectVersion)),
                  member("name", jsonText(project.name))};
  members.push_back(member("field", partText("field", *project.field)));
  members.push_back(member("solver", partText("solver", *project.solver)));
  members.push_back(member("ambient", partText("ambient", *project.ambient)));
  members.push_back(member("graph", graphText(*project.graph)));
  members.push_back(member("obstacles", listText(*project.obstacles, "  ")));
  members.push_back(member("terrain", partText("terrain", *project.terrain)));
  members.push_back(member("grass", partText("grass", *project.grass)));
  members.push_back(member("bezier", partText("bezier", *project.bezier)));
  members.push_back(member("shell", partText("shell", *project.shell)));
  members.push_back(member("species", listText(*project.species, "  ")));
  members.push_back(member("colliders", listText(*project.colliders, "  ")));
  members.push_back(member("surfaces", listText(*project.surfaces, "  ")));
  members.push_back(member("rotors", listText(*project.rotors, "  ")));
  members.push_back(member("probes", listText(*project.probes, "  ")));
  members.push_back(member("cameras", listText(*project.cameras, "  ")));
  for (const auto& [name, value] : extra.items()) members.push_back(member(name, spaced(value)));
  std::string text;
  for (const std::string& part : members) text.append(text.empty() ? "{\n  " : ",\n  ").append(part);
  return text.append("\n}\n");
}

Status saveProject(const Project& project, const std::filesystem::path& path) {
  std::vector<Problem> problems = validate(project);
  for (Problem& problem : problems) problem.file = path.string();
  if (!problems.empty()) return Error{ErrorKind::BadInput, std::move(problems)};
  return writeFileAtomically(path, writeProject(project), Backup::KeepOne);
}

}  // namespace windloom
