#include <algorithm>
#include <optional>

#include "engine/core/file.hpp"
#include "engine/core/out_of_memory.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/json_document.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/project_migration.hpp"
#include "engine/io/project_records.hpp"
#include "engine/io/project_values.hpp"
#include "engine/io/terrain_file.hpp"
#include "engine/model/outline.hpp"
#include "engine/model/parameters.hpp"
#include "engine/model/signal_curve.hpp"
#include "engine/model/validate.hpp"

namespace windloom {
namespace {

constexpr std::size_t kMaxProblems = 1000;

/// A place in the document; becomes a JSON pointer only when there is something to say.
struct Place {
  const Place* parent = nullptr;
  std::string_view key = {};
  std::size_t index = 0;

  [[nodiscard]] std::string pointer() const {
    if (parent == nullptr) return {};
    return parent->pointer() + "/" + (key.empty() ? std::to_string(index) : pointerPart(key));
  }
  [[nodiscard]] Place at(std::string_view member) const { return {this, member, 0}; }
  [[nodiscard]] Place at(std::size_t element) const { return {this, {}, element}; }
};

class Reader {
 public:
  Project read(const JsonDocument& document) {
    const Place root;
    Project project;
    JsonDocument extra = JsonDocument::object();
    for (const auto& [key, value] : document.items()) {
      const Place place = root.at(key);
      if (key == "format" || key == "version") continue;
      if (key == "name") {
        if (auto name = readValue(kProjectName, value, place)) project.name = std::get<std::string>(*std::move(name));
      } else if (key == "field") {
        readPart(project.field, value, place);
      } else if (key == "solver") {
        readPart(project.solver, value, place);
      } else if (key == "ambient") {
        readPart(project.ambient, value, place);
      } else if (key == "graph") {
        project.graph = std::make_shared<WindGraph>(readGraph(value, place));
      } else if (key == "obstacles") {
        project.obstacles = std::make_shared<std::vector<Obstacle>>(readList<Obstacle>(value, place, kMaxObstacles));
      } else if (key == "terrain") {
        readPart(project.terrain, value, place);
      } else if (key == "grass") {
        readPart(project.grass, value, place);
      } else if (key == "bezier") {
        readPart(project.bezier, value, place);
      } else if (key == "shell") {
        readPart(project.shell, value, place);
      } else if (key == "species") {
        project.species = std::make_shared<std::vector<Species>>(readList<Species>(value, place, kMaxSpecies));
      } else if (key == "colliders") {
        project.colliders = std::make_shared<std::vector<Collider>>(readList<Collider>(value, place, kMaxColliders));
      } else if (key == "surfaces") {
        project.surfaces = std::make_shared<std::vector<Surface>>(readList<Surface>(value, place, kMaxSurfaces));
      } else if (key == "rotors") {
        project.rotors = std::make_shared<std::vector<Rotor>>(readList<Rotor>(value, place, kMaxRotors));
      } else if (key == "probes") {
        project.probes = std::make_shared<std::vector<Probe>>(readList<Probe>(value, place, kMaxProbes));
      } else if (key == "cameras") {
        project.cameras = std::make_shared<std::vector<Camera>>(readList<Camera>(value, place, kMaxCameras));
      } else {
        keep(extra, key, value, place);
      }
    }
    project.extra = std::make_shared<std::string>(textOf(extra));
    return project;
  }

  std::vector<Problem> problems, warnings;

 private:
  void problem(const Place& place, std::string message) {
    if (problems.size() < kMaxProblems) problems.push_back({{}, place.pointer(), std::move(message)});
  }

  void keep(JsonDocument& extra, const std::string& key, const JsonDocument& value, const Place& place) {
    extra[key] = value;
    if (warnings.size() < kMaxProblems)
      warnings.push_back({{}, place.pointer(), "is no key that this version knows; kept as it is"});
  }

  static std::string textOf(const JsonDocument& extra) { return extra.empty() ? std::string() : extra.dump(); }

  std::optional<ParameterValue> readValue(const ParameterInfo& info, const JsonDocument& value, const Place& place) {
    std::optional<ParameterValue> read = valueOfType(info, value);
    if (read && parameterProblem(info, *read).empty()) return read;
    problem(place, "found " + describeJson(value) + ", expected " + parameterExpectation(info));
    return std::nullopt;
  }

  bool expectObject(const JsonDocument& value, const Place& place) {
    if (!value.is_object()) problem(place, "found " + describeJson(value) + ", expected an object");
    return value.is_object();
  }

  /// Reads the members of an object that has passed expectObject. `group` is the leading part of nested
  /// keys, "gusts/". Gives the unknown members; `special` is read by the caller.
  template <class Owner>
  JsonDocument readMembers(const JsonDocument& object, Owner& owner, const Place& place, const std::string& group,
                           std::string_view special = {}) {
    const auto table = parametersOf<Owner>();
    JsonDocument extra = JsonDocument::object();
    for (const auto& [key, value] : object.items()) {
      const Place member = place.at(key);
      const std::string full = group + key;
      const bool plain = key.find('/') == std::string::npos && !key.empty();
      const auto parameter = std::ranges::find(table, full, [](const Parameter<Owner>& p) { return p.info.key; });
      if (plain && parameter != table.end()) {
        if (auto read = readValue(parameter->info, value, member)) parameter->set(owner, *read);
      } else if (plain && group.empty() && isGroup(table, full + "/")) {
        if (!expectObject(value, member)) continue;
        JsonDocument inner = readMembers(value, owner, member, full + "/");
        if (!inner.empty()) extra[key] = std::move(inner);
      } else if (key != special || special.empty()) {
        keep(extra, key, value, member);
      }
    }
    return extra;
  }

  template <class Owner>
  static bool isGroup(std::span<const Parameter<Owner>> table, const std::string& prefix) {
    return std::ranges::any_of(table, [&](const Parameter<Owner>& p) { return p.info.key.starts_with(prefix); });
  }

  template <class Part>
  void readPart(Shared<Part>& part, const JsonDocument& value, const Place& place) {
    if (!expectObject(value, place)) return;
    auto read = std::make_shared<Part>();
    read->extra = textOf(readMembers(value, *read, place, {}));
    part = std::move(read);
  }

  template <class Record>
  std::vector<Record> readList(const JsonDocument& value, const Place& place, std::size_t limit) {
    std::vector<Record> records;
    if (!value.is_array()) {
      problem(place, "found " + describeJson(value) + ", expected an array of objects");
    } else if (value.size() > limit) {
      problem(place, "holds " + std::to_string(value.size()) + " objects, expected at most " + std::to_string(limit));
    } else {
      records.reserve(value.size());
      for (std::size_t i = 0; i < value.size(); ++i) records.push_back(readRecord<Record>(value[i], place.at(i)));
    }
    return records;
  }

  template <class Record>
  Record readRecord(const JsonDocument& value, const Place& place) {
    Record record;
    if (!expectObject(value, place)) return record;
    record.extra = textOf(readMembers(value, record, place, {}, kListKey<Record>));
    for (const std::string_view key : kRequiredKeys<Record>) {
      if (value.contains(key)) continue;
      const auto table = parametersOf<Record>();
      const auto parameter = std::ranges::find(table, key, [](const Parameter<Record>& p) { return p.info.key; });
      problem(place.at(key), "is missing, expected " + parameterExpectation(parameter->info));
    }
    if constexpr (!kListKey<Record>.empty()) {
      if (const auto list = value.find(kListKey<Record>); list != value.end())
        readInto(record, *list, place.at(kListKey<Record>));
    }
    return record;
  }

  void readInto(Signal& signal, const JsonDocument& value, const Place& place) {
    signal.keys = readKeys<SignalKey>(value, place, kMaxSignalKeys, "[time, value] or [time, value, easing]",
                                      [&](const JsonDocument& key, const Place& at) { return readSignalKey(key, at); });
  }
  void readInto(Collider& collider, const JsonDocument& value, const Place& place) {
    collider.keys =
        readKeys<ColliderKey>(value, place, kMaxColliderKeys, "[time, x, height, z]",
                              [&](const JsonDocument& key, const Place& at) { return readColliderKey(key, at); });
  }
  void readInto(Obstacle& obstacle, const JsonDocument& value, const Place& place) {
    obstacle.points = readCorners(value, place);
  }

  template <class Key, class ReadKey>
  std::vector<Key> readKeys(const JsonDocument& value, const Place& place, std::size_t limit, const char* form,
                            ReadKey&& read) {
    std::vector<Key> keys;
    if (!value.is_array() || value.size() > limit) {
      problem(place, "found " + describeJson(value) + ", expected an array of at most " + std::to_string(limit) +
                         " keys " + form);
      return keys;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (auto key = read(value[i], place.at(i))) keys.push_back(*key);
    }
    return keys;
  }

  std::optional<ColliderKey> readColliderKey(const JsonDocument& value, const Place& place) {
    if (isNumberArray(value, 4)) {
      const auto part = [&](std::size_t i) { return value[i].get<float>(); };
      return ColliderKey{part(0), {part(1), part(2), part(3)}};
    }
    problem(place, "found " + describeJson(value) + ", expected four numbers [time, x, height, z]");
    return std::nullopt;
  }

  std::optional<SignalKey> readSignalKey(const JsonDocument& value, const Place& place) {
    const bool shaped =
        value.is_array() && (value.size() == 2 || value.size() == 3) && value[0].is_number() && value[1].is_number();
    if (!shaped) {
      problem(place, "found " + describeJson(value) +
                         ", expected two numbers [time, value], and an easing after them where it isn't linear");
      return std::nullopt;
    }
    SignalKey key{value[0].get<float>(), value[1].get<float>()};
    if (value.size() == 2) return key;
    const auto easing =
        value[2].is_string() ? std::ranges::find(kEasings, value[2].get_ref<const std::string&>()) : kEasings.end();
    if (easing == kEasings.end()) {
      problem(place.at(2), "found " + describeJson(value[2]) + ", expected one of linear, smooth, hold");
      return std::nullopt;
    }
    key.easing = static_cast<Easing>(easing - kEasings.begin());
    return key;
  }

  std::vector<glm::vec2> readCorners(const JsonDocument& value, const Place& place) {
    std::vector<glm::vec2> corners;
    if (!value.is_array() || value.size() < kMinCorners || value.size() > kMaxCorners) {
      problem(place, "found " + describeJson(value) + ", expected an array of " + std::to_string(kMinCorners) + " to " +
                         std::to_string(kMaxCorners) + " corners [x, z]");
      return corners;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (isNumberArray(value[i], 2)) {
        corners.emplace_back(value[i][0].get<float>(), value[i][1].get<float>());
      } else {
        problem(place.at(i), "found " + describeJson(value[i]) + ", expected two numbers [x, z]");
      }
    }
    return corners;
  }

  WindGraph readGraph(const JsonDocument& value, const Place& place) {
    WindGraph graph;
    if (!expectObject(value, place)) return graph;
    JsonDocument extra = JsonDocument::object();
    for (const auto& [key, part] : value.items()) {
      if (key == "points") {
        graph.points = readList<Point>(part, place.at(key), kMaxPoints);
      } else if (key == "arrows") {
        graph.arrows = readList<Arrow>(part, place.at(key), kMaxArrows);
      } else if (key == "signals") {
        graph.signals = readList<Signal>(part, place.at(key), kMaxPoints);
      } else {
        keep(extra, key, part, place.at(key));
      }
    }
    graph.extra = textOf(extra);
    return graph;
  }
};

/// Checks that the document is a project that this version can read, and brings it up to date.
Status prepare(JsonDocument& document, const std::string& file, std::vector<Problem>& warnings) {
  const auto refuse = [&](std::string pointer, std::string message) {
    return makeError(ErrorKind::BadInput, file, std::move(pointer), std::move(message));
  };
  if (!document.is_object())
    return refuse({}, "holds " + describeJson(document) + ", expected a Windloom project (an object)");
  const std::string expected = "expected \"" + std::string(kProjectFormat) + "\"";
  const auto format = document.find("format");
  if (format == document.end()) return refuse("/format", "is missing, so this is no Windloom project: " + expected);
  if (*format != JsonDocument(kProjectFormat))
    return refuse("/format", "found " + describeJson(*format) + ", " + expected);
  const auto versionValue = document.find("version");
  const std::string range = "expected a whole number from 1 to " + std::to_string(kProjectVersion);
  if (versionValue == document.end()) return refuse("/version", "is missing, " + range);
  const std::optional<int> version = wholeNumber(*versionValue);
  if (!version || *version < 1) return refuse("/version", "found " + describeJson(*versionValue) + ", " + range);
  if (*version > kProjectVersion) {
    return refuse("/version", "the project is of version " + std::to_string(*version) +
                                  ", this program reads up to version " + std::to_string(kProjectVersion) +
                                  ": a newer Windloom is needed");
  }
  Status migrated = migrateProject(document, *version, kProjectVersion, projectMigrations());
  if (!migrated) {
    Error error = migrated.error();
    for (Problem& problem : error.problems) problem.file = file;
    return error;
  }
  if (*version < kProjectVersion) {
    warnings.push_back(
        {{}, "/version", "was " + std::to_string(*version) + ", brought up to " + std::to_string(kProjectVersion)});
  }
  return Done{};
}

/// What validate says beyond what reading found. A point that couldn't be read makes its arrows and
/// signals look wrong too; those are not reported.
void addSemanticProblems(const Project& project, std::vector<Problem>& problems) {
  std::vector<std::string> known;
  for (const Problem& problem : problems) known.push_back(problem.pointer);
  std::ranges::sort(known);
  const bool pointsBroken = std::ranges::any_of(known, [](const std::string& p) { return p.starts_with("/graph"); });
  for (Problem& problem : validate(project)) {
    if (problems.size() >= kMaxProblems) break;
    if (std::ranges::binary_search(known, problem.pointer)) continue;
    // Corners or keys that couldn't be read make the others look wrong, too.
    const auto blames = [&](const std::string& list) {
      const auto below = std::ranges::lower_bound(known, list);
      return below != known.end() && below->starts_with(list);
    };
    if (problem.pointer.ends_with("/points") && blames(problem.pointer + "/")) continue;
    const std::size_t keys = problem.pointer.find("/keys/");
    if (keys != std::string::npos && blames(problem.pointer.substr(0, keys + 6))) continue;
    const bool depends = problem.pointer.starts_with("/graph/arrows") || problem.pointer.starts_with("/graph/signals");
    if (pointsBroken && depends) continue;
    problems.push_back(std::move(problem));
  }
}

}  // namespace

Result<LoadedProject> parseProject(std::string_view text, const std::string& fileName) {
  if (text.find_first_not_of(" \t\r\n") == text.npos) {
    return makeError(ErrorKind::BadInput, fileName, {}, "is empty, expected a Windloom project");
  }
  if (text.size() > kMaxProjectBytes) {
    return makeError(ErrorKind::BadInput, fileName, {},
                     "is larger than " + std::to_string(kMaxProjectBytes >> 20) + " MB");
  }
  Result<JsonDocument> document = parseJsonDocument(text, fileName);
  if (!document) return document.error();
  Reader reader;
  if (Status prepared = prepare(*document, fileName, reader.warnings); !prepared) return prepared.error();
  LoadedProject loaded{reader.read(*document), {}, {}, false};
  addSemanticProblems(loaded.project, reader.problems);
  for (auto* list : {&reader.problems, &reader.warnings}) {
    for (Problem& problem : *list) problem.file = fileName;
  }
  if (!reader.problems.empty()) return Error{ErrorKind::BadInput, std::move(reader.problems)};
  loaded.warnings = std::move(reader.warnings);
  return loaded;
}

Result<LoadedProject> loadProject(const std::filesystem::path& path, OutsideFiles outside) {
  return orOutOfMemory(path.string(), [&]() -> Result<LoadedProject> {
    Result<std::string> text = readFile(path, kMaxProjectBytes);
    if (!text) return text.error();
    Result<LoadedProject> loaded = parseProject(*text, path.string());
    if (!loaded) return loaded;
    Project& project = loaded->project;
    if (Status terrain = loadTerrain(project, path, outside); !terrain) loaded->missing = terrain.error().problems;
    if (Status assets = loadAssets(project, path, outside); !assets) {
      for (Problem& problem : Error(assets.error()).problems) loaded->missing.push_back(std::move(problem));
    }
    loaded->outsideRefused =
        outside == OutsideFiles::Refuse && !loaded->missing.empty() && namesFilesOutside(project, path);
    return loaded;
  });
}

}  // namespace windloom
