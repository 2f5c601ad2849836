// Mute, hide, lock, isolate: the flag edits of object_edits.hpp.
#include <type_traits>
#include <unordered_set>

#include "editor/core/id_index.hpp"
#include "editor/core/object_edits.hpp"

namespace windloom::editor {
namespace {

bool* flagOf(Arrow& arrow, Flag flag) {
  return flag == Flag::Hidden ? &arrow.hidden : flag == Flag::Muted ? &arrow.muted : &arrow.locked;
}
bool* flagOf(Obstacle& obstacle, Flag flag) {
  return flag == Flag::Hidden ? &obstacle.hidden : flag == Flag::Muted ? &obstacle.muted : &obstacle.locked;
}
bool* flagOf(Species& species, Flag flag) {
  return flag == Flag::Hidden ? &species.hidden : nullptr;
}
bool* flagOf(Collider& collider, Flag flag) {
  return flag == Flag::Hidden ? &collider.hidden : flag == Flag::Muted ? &collider.muted : &collider.locked;
}
bool* flagOf(Surface& surface, Flag flag) {
  return flag == Flag::Hidden ? &surface.hidden : flag == Flag::Locked ? &surface.locked : nullptr;
}
bool* flagOf(Rotor& rotor, Flag flag) {
  return flag == Flag::Hidden ? &rotor.hidden : flag == Flag::Muted ? &rotor.muted : &rotor.locked;
}
bool* flagOf(Probe& probe, Flag flag) {
  return flag == Flag::Hidden ? &probe.hidden : flag == Flag::Locked ? &probe.locked : nullptr;
}

/// Puts each record that `wanted` gives a value other than its own.
template <class T, class Wanted>
void setWhere(Edit& edit, const std::vector<T>& records, Flag flag, Wanted wanted) {
  for (const T& record : records) {
    T copy = record;
    bool* value = flagOf(copy, flag);
    if (!value || *value == wanted(record, *value)) continue;
    *value = wanted(record, *value);
    edit.steps.emplace_back(Put<T>{std::move(copy)});
  }
}

template <class Wanted>
Edit setAll(const Project& project, Flag flag, std::string label, Wanted wanted) {
  Edit edit;
  edit.label = std::move(label);
  setWhere(edit, project.graph->arrows, flag, wanted);
  setWhere(edit, *project.obstacles, flag, wanted);
  setWhere(edit, *project.species, flag, wanted);
  setWhere(edit, *project.colliders, flag, wanted);
  setWhere(edit, *project.surfaces, flag, wanted);
  setWhere(edit, *project.rotors, flag, wanted);
  setWhere(edit, *project.probes, flag, wanted);
  return edit;
}

std::unordered_set<Id> carriers(const Project& project, std::span<const Id> ids) {
  std::unordered_set<Id> all(ids.begin(), ids.end());
  for (const Id id : arrowsOf(project, ids)) all.insert(id);
  return all;
}

const char* flagLabel(Flag flag, bool on) {
  switch (flag) {
    case Flag::Hidden:
      return on ? "Hide" : "Show";
    case Flag::Muted:
      return on ? "Mute" : "Unmute";
    case Flag::Locked:
      return on ? "Lock" : "Unlock";
  }
  return "";
}

}  // namespace

Edit flagEdit(const Project& project, std::span<const Id> ids, Flag flag, bool on) {
  const std::unordered_set<Id> chosen = carriers(project, ids);
  return setAll(project, flag, flagLabel(flag, on),
                [&](const auto& record, bool now) { return chosen.contains(record.id) ? on : now; });
}

bool allFlagged(const Project& project, std::span<const Id> ids, Flag flag) {
  const std::unordered_set<Id> chosen = carriers(project, ids);
  bool any = false, all = true;
  const auto look = [&](const auto& records) {
    for (auto record : records) {
      if (!chosen.contains(record.id)) continue;
      const bool* value = flagOf(record, flag);
      any = any || value;
      all = all && (!value || *value);
    }
  };
  look(project.graph->arrows);
  look(*project.obstacles);
  look(*project.species);
  look(*project.colliders);
  look(*project.surfaces);
  look(*project.rotors);
  look(*project.probes);
  return any && all;
}

Edit clearFlagEdit(const Project& project, Flag flag) {
  return setAll(project, flag, std::string(flagLabel(flag, false)) + " all", [](const auto&, bool) { return false; });
}

Edit isolateEdit(const Project& project, std::span<const Id> ids) {
  const std::unordered_set<Id> chosen = carriers(project, ids);
  // Species are the meadow, not things in it.
  return setAll(project, Flag::Hidden, "Isolate", [&]<class Record>(const Record& record, bool now) {
    return std::is_same_v<Record, Species> ? now : !chosen.contains(record.id);
  });
}

}  // namespace windloom::editor
