#include "editor/core/selection.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "editor/core/id_index.hpp"

namespace windloom::editor {
namespace {

/// Points of whose arrows at least one is neither hidden nor locked, and those without arrows.
std::unordered_set<Id> openPoints(const WindGraph& graph) {
  std::unordered_set<Id> open, touched;
  for (const Arrow& arrow : graph.arrows) {
    touched.insert({arrow.from, arrow.to});
    if (!arrow.hidden && !arrow.locked) open.insert({arrow.from, arrow.to});
  }
  for (const Point& point : graph.points) {
    if (!touched.contains(point.id)) open.insert(point.id);
  }
  return open;
}

}  // namespace

void Selection::replace(std::vector<Id> ids) {
  m_set.clear();
  m_ids.clear();
  for (const Id id : ids) {
    if (id != 0 && m_set.insert(id).second) m_ids.push_back(id);
  }
}

void Selection::add(Id id) {
  if (id == 0) return;
  remove(id);
  m_ids.push_back(id);
  m_set.insert(id);
}

void Selection::toggle(Id id) {
  if (contains(id)) {
    remove(id);
  } else {
    add(id);
  }
}

void Selection::remove(Id id) {
  if (m_set.erase(id) > 0) std::erase(m_ids, id);
}

bool Selection::repair(const Project& project) {
  if (m_ids.empty()) return false;
  const IdIndex known(project);
  std::erase_if(m_set, [&](Id id) { return !known.contains(id); });
  return std::erase_if(m_ids, [&](Id id) { return !known.contains(id); }) > 0;
}

void select(Selection& selection, std::span<const Id> ids, SelectMode mode) {
  if (mode == SelectMode::Replace) {
    selection.replace({ids.begin(), ids.end()});
    return;
  }
  std::vector<Id> merged(selection.ids().begin(), selection.ids().end());
  const std::unordered_set<Id> given(ids.begin(), ids.end());
  const std::unordered_set<Id> had(merged.begin(), merged.end());
  // What is given comes last, so that the last pick becomes the active one.
  std::erase_if(merged, [&](Id id) { return given.contains(id); });
  for (const Id id : ids) {
    if (mode == SelectMode::Add || !had.contains(id)) merged.push_back(id);
  }
  selection.replace(std::move(merged));
}

std::vector<Id> selectableIds(const Project& project) {
  std::vector<Id> ids;
  const std::unordered_set<Id> open = openPoints(*project.graph);
  for (const Point& point : project.graph->points) {
    if (open.contains(point.id)) ids.push_back(point.id);
  }
  const auto append = [&](const auto& records) {
    for (const auto& record : records) {
      if (!record.hidden && !record.locked) ids.push_back(record.id);
    }
  };
  append(project.graph->arrows);
  append(*project.obstacles);
  append(*project.colliders);
  append(*project.surfaces);
  append(*project.rotors);
  append(*project.probes);
  return ids;
}

std::vector<Id> linkedIds(const Project& project, std::span<const Id> ids) {
  const WindGraph& graph = *project.graph;
  std::unordered_map<Id, std::vector<const Arrow*>> touching;
  for (const Arrow& arrow : graph.arrows) {
    touching[arrow.from].push_back(&arrow);
    touching[arrow.to].push_back(&arrow);
  }
  const IdIndex index(project);
  std::vector<Id> reached, open;
  std::unordered_set<Id> seen;
  const auto visit = [&](Id id) {
    if (seen.insert(id).second) reached.push_back(id);
  };
  const auto visitPoint = [&](Id id) {
    if (!seen.contains(id)) open.push_back(id);
    visit(id);
  };
  for (const Id id : ids) {
    if (const Arrow* arrow = index.arrow(id)) {
      visit(id);
      visitPoint(arrow->from);
    } else if (index.point(id)) {
      visitPoint(id);
    } else {
      visit(id);
    }
  }
  while (!open.empty()) {
    const Id point = open.back();
    open.pop_back();
    for (const Arrow* arrow : touching[point]) {
      visit(arrow->id);
      visitPoint(arrow->from == point ? arrow->to : arrow->from);
    }
  }
  return reached;
}

std::string describeIds(const Project& project, std::span<const Id> ids) {
  constexpr ObjectKind kinds[] = {ObjectKind::Point,   ObjectKind::Arrow,    ObjectKind::Obstacle,
                                  ObjectKind::Species, ObjectKind::Collider, ObjectKind::Surface,
                                  ObjectKind::Rotor,   ObjectKind::Probe,    ObjectKind::Camera};
  if (ids.empty()) return {};
  if (ids.size() == 1) {
    const auto kind = kindOf(project, ids[0]);
    if (!kind) return {};
    const std::string name = nameOf(project, ids[0]);
    return std::string(kindLabel(*kind)) + " " + std::to_string(ids[0]) + (name.empty() ? "" : " (" + name + ")");
  }
  const IdIndex index(project);
  std::size_t counts[std::size(kinds)] = {};
  for (const Id id : ids) {
    if (const auto place = index.find(id)) ++counts[static_cast<std::size_t>(place->kind)];
  }
  std::string text;
  for (std::size_t i = 0; i < std::size(kinds); ++i) {
    if (counts[i] == 0) continue;
    text += (text.empty() ? "" : ", ") + countOf(counts[i], kinds[i]);
  }
  return text;
}

}  // namespace windloom::editor
