#include "editor/core/project_changes.hpp"

#include <algorithm>
#include <cctype>
#include <unordered_map>
#include <unordered_set>

#include "engine/model/parameters.hpp"

namespace windloom::editor {
namespace {

using Lines = std::vector<std::string>;
constexpr std::size_t kNamedOneByOne = 5;

Id keyOf(const Signal& signal) {
  return signal.root;
}
template <class T>
Id keyOf(const T& record) {
  return record.id;
}
std::string nameIn(const Signal&) {
  return {};
}
template <class T>
std::string nameIn(const T& record) {
  return record.name;
}

// What differs beside parameters; empty: nothing.
std::string listDifference(const Signal& before, const Signal& after) {
  return before.keys == after.keys ? "" : "curve";
}
std::string listDifference(const Obstacle& before, const Obstacle& after) {
  return before.points == after.points ? "" : "corners";
}
std::string listDifference(const Collider& before, const Collider& after) {
  return before.keys == after.keys ? "" : "way";
}
template <class T>
std::string listDifference(const T&, const T&) {
  return {};
}

/// The labels of the parameters and the names of the lists that differ, with commas.
template <class T>
std::string differences(const T& before, const T& after) {
  std::string labels;
  const auto add = [&](std::string label) {
    label[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(label[0])));
    labels.append(labels.empty() ? "" : ", ").append(label);
  };
  for (const Parameter<T>& parameter : parametersOf<T>()) {
    if (parameter.get(before) != parameter.get(after)) add(std::string(parameter.info.label));
  }
  if (std::string list = listDifference(before, after); !list.empty()) add(std::move(list));
  return labels;
}

template <class T>
void compareSettings(Lines& lines, const char* label, const Shared<T>& before, const Shared<T>& after) {
  if (before == after) return;
  const std::string changed = differences(*before, *after);
  if (!changed.empty()) lines.push_back(std::string(label).append(" changed: ").append(changed));
}

/// What makes a noun several.
const char* plural(std::string_view noun) {
  return noun.ends_with("pecies") ? " " : "s ";
}

void count(Lines& lines, std::size_t number, const char* noun, const char* what) {
  if (number == 0) return;
  lines.push_back(
      std::to_string(number).append(" ").append(noun).append(number == 1 ? " " : plural(noun)).append(what));
}

/// The ids of `records` that `others` has, too.
template <class T>
std::vector<Id> sharedIds(const std::vector<T>& records, const std::vector<T>& others) {
  std::unordered_set<Id> known;
  for (const T& record : others) known.insert(keyOf(record));
  std::vector<Id> ids;
  for (const T& record : records) {
    if (known.contains(keyOf(record))) ids.push_back(keyOf(record));
  }
  return ids;
}

template <class T>
void compareRecords(Lines& lines, const char* label, const std::vector<T>& before, const std::vector<T>& after) {
  std::string noun = label;
  noun[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(noun[0])));
  std::unordered_map<Id, const T*> old;
  for (const T& record : before) old.emplace(keyOf(record), &record);
  std::size_t added = 0, kept = 0;
  Lines changed;
  for (const T& record : after) {
    const auto found = old.find(keyOf(record));
    if (found == old.end()) {
      ++added;
      continue;
    }
    ++kept;
    const std::string what = differences(*found->second, record);
    if (what.empty()) continue;
    const std::string name = nameIn(record);
    changed.push_back(std::string(label)
                          .append(" ")
                          .append(std::to_string(keyOf(record)))
                          .append(name.empty() ? "" : " (" + name + ")")
                          .append(" changed: ")
                          .append(what));
  }
  count(lines, added, noun.c_str(), "added");
  count(lines, before.size() - kept, noun.c_str(), "deleted");
  if (changed.size() > kNamedOneByOne) {
    count(lines, changed.size(), noun.c_str(), "changed");
  } else {
    lines.insert(lines.end(), changed.begin(), changed.end());
  }
  if (sharedIds(before, after) != sharedIds(after, before))
    lines.push_back(std::string(label) + plural(label) + "in another order");
}

}  // namespace

Lines describeChanges(const Project& before, const Project& after) {
  Lines lines;
  if (before.name != after.name) lines.push_back("Name changed: " + after.name);
  compareSettings(lines, "Field", before.field, after.field);
  compareSettings(lines, "Solver", before.solver, after.solver);
  compareSettings(lines, "Ambient wind", before.ambient, after.ambient);
  compareRecords(lines, "Point", before.graph->points, after.graph->points);
  compareRecords(lines, "Arrow", before.graph->arrows, after.graph->arrows);
  compareRecords(lines, "Signal", before.graph->signals, after.graph->signals);
  compareRecords(lines, "Obstacle", *before.obstacles, *after.obstacles);
  compareSettings(lines, "Terrain", before.terrain, after.terrain);
  compareSettings(lines, "Grass", before.grass, after.grass);
  compareSettings(lines, "Bezier grass", before.bezier, after.bezier);
  compareSettings(lines, "Shell grass", before.shell, after.shell);
  compareRecords(lines, "Species", *before.species, *after.species);
  compareRecords(lines, "Collider", *before.colliders, *after.colliders);
  compareRecords(lines, "Surface", *before.surfaces, *after.surfaces);
  compareRecords(lines, "Rotor", *before.rotors, *after.rotors);
  compareRecords(lines, "Probe", *before.probes, *after.probes);
  compareRecords(lines, "Camera", *before.cameras, *after.cameras);
  return lines;
}

}  // namespace windloom::editor
