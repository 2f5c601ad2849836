#include "editor/core/id_index.hpp"

namespace windloom::editor {

IdIndex::IdIndex(const Project& project) : m_project(project) {
  m_places.reserve(project.graph->points.size() + project.graph->arrows.size() + project.obstacles->size());
  const auto fill = [&](const auto& records, ObjectKind kind) {
    for (std::size_t i = 0; i < records.size(); ++i) {
      m_places.emplace(records[i].id, Place{kind, static_cast<std::uint32_t>(i)});
    }
  };
  fill(project.graph->points, ObjectKind::Point);
  fill(project.graph->arrows, ObjectKind::Arrow);
  fill(*project.obstacles, ObjectKind::Obstacle);
  fill(*project.species, ObjectKind::Species);
  fill(*project.colliders, ObjectKind::Collider);
  fill(*project.surfaces, ObjectKind::Surface);
  fill(*project.rotors, ObjectKind::Rotor);
  fill(*project.probes, ObjectKind::Probe);
  fill(*project.cameras, ObjectKind::Camera);
}

std::optional<IdIndex::Place> IdIndex::find(Id id) const {
  const auto found = m_places.find(id);
  if (found == m_places.end()) return std::nullopt;
  return found->second;
}

template <class T>
const T* IdIndex::record(Id id, ObjectKind kind, const std::vector<T>& records) const {
  const auto found = m_places.find(id);
  return found != m_places.end() && found->second.kind == kind ? &records[found->second.index] : nullptr;
}

const Point* IdIndex::point(Id id) const {
  return record(id, ObjectKind::Point, m_project.graph->points);
}
const Arrow* IdIndex::arrow(Id id) const {
  return record(id, ObjectKind::Arrow, m_project.graph->arrows);
}
const Obstacle* IdIndex::obstacle(Id id) const {
  return record(id, ObjectKind::Obstacle, *m_project.obstacles);
}
const Species* IdIndex::species(Id id) const {
  return record(id, ObjectKind::Species, *m_project.species);
}
const Collider* IdIndex::collider(Id id) const {
  return record(id, ObjectKind::Collider, *m_project.colliders);
}
const Surface* IdIndex::surface(Id id) const {
  return record(id, ObjectKind::Surface, *m_project.surfaces);
}
const Rotor* IdIndex::rotor(Id id) const {
  return record(id, ObjectKind::Rotor, *m_project.rotors);
}
const Probe* IdIndex::probe(Id id) const {
  return record(id, ObjectKind::Probe, *m_project.probes);
}
const Camera* IdIndex::camera(Id id) const {
  return record(id, ObjectKind::Camera, *m_project.cameras);
}

}  // namespace windloom::editor
