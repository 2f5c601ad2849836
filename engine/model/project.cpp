#include "engine/model/project.hpp"

#include <algorithm>
#include <tuple>

namespace windloom {

bool operator==(const Species& a, const Species& b) {
  const auto values = [](const Species& s) {
    return std::tie(s.id, s.name, s.shape, s.file, s.weight, s.patchiness, s.patchSize, s.height, s.heightVariation,
                    s.width, s.stiffness, s.baseColour, s.tipColour, s.hidden, s.extra);
  };
  return values(a) == values(b);
}

bool operator==(const Collider& a, const Collider& b) {
  const auto values = [](const Collider& c) {
    return std::tie(c.id, c.name, c.shape, c.position, c.lift, c.radius, c.length, c.rotation, c.file, c.scale,
                    c.spheres, c.keys, c.loop, c.roll, c.hidden, c.muted, c.locked, c.extra);
  };
  return values(a) == values(b);
}

bool operator==(const Surface& a, const Surface& b) {
  const auto values = [](const Surface& s) {
    return std::tie(s.id, s.name, s.shape, s.position, s.lift, s.size, s.rotation, s.tilt, s.file, s.scale, s.density,
                    s.height, s.width, s.stiffness, s.bothSides, s.colour, s.hidden, s.locked, s.extra);
  };
  return values(a) == values(b);
}

bool Project::sameAs(const Project& other) const {
  return name == other.name && field == other.field && solver == other.solver && ambient == other.ambient &&
         graph == other.graph && obstacles == other.obstacles && terrain == other.terrain && grass == other.grass &&
         bezier == other.bezier && shell == other.shell && species == other.species && colliders == other.colliders &&
         surfaces == other.surfaces && rotors == other.rotors && probes == other.probes && cameras == other.cameras &&
         extra == other.extra;
}

namespace {

template <class Visit>
void visitIds(const Project& project, Visit&& visit) {
  const auto visitAll = [&](const auto& records) {
    for (const auto& record : records) visit(record.id);
  };
  visitAll(project.graph->points);
  visitAll(project.graph->arrows);
  visitAll(*project.obstacles);
  visitAll(*project.species);
  visitAll(*project.colliders);
  visitAll(*project.surfaces);
  visitAll(*project.rotors);
  visitAll(*project.probes);
  visitAll(*project.cameras);
}

}  // namespace

FreeIds::FreeIds(const Project& project) : m_project(project) {
  visitIds(project, [&](Id id) { m_last = std::max(m_last, id); });
}

Id FreeIds::take() {
  if (m_used.empty() && m_last < kMaxId) return ++m_last;
  if (m_used.empty()) {
    visitIds(m_project, [&](Id id) { m_used.push_back(id); });
    std::ranges::sort(m_used);
    m_last = 0;
  }
  ++m_last;
  for (; m_place < m_used.size() && m_used[m_place] <= m_last; ++m_place) m_last += m_used[m_place] == m_last ? 1 : 0;
  return m_last;
}

Id nextFreeId(const Project& project) {
  return FreeIds(project).take();
}

}  // namespace windloom
