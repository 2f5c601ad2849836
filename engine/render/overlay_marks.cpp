#include "engine/render/overlay_marks.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "engine/model/outline.hpp"
#include "engine/render/solids.hpp"

namespace windloom {
namespace {

constexpr float kVectorsAcross = 40.0f;

class States {
 public:
  explicit States(const Highlight& highlight) : m_selected(highlight.selected.begin(), highlight.selected.end()), m_hovered(highlight.hovered) {}
  float operator()(Id id) const {
    if (m_selected.contains(id)) return MARK_SELECTED;
    return id != 0 && id == m_hovered ? MARK_HOVERED : MARK_NORMAL;
  }

 private:
  std::unordered_set<Id> m_selected;
  Id m_hovered;
};

/// Where a ray through the picture meets the ground, or the field's height far away along it.
glm::vec2 onGround(const glm::mat4& inverse, glm::vec2 clip, float reach) {
  const glm::vec4 a = inverse * glm::vec4(clip, -1.0f, 1.0f), b = inverse * glm::vec4(clip, 1.0f, 1.0f);
  const glm::vec3 from = glm::vec3(a) / a.w, to = glm::vec3(b) / b.w;
  const glm::vec3 ray = glm::normalize(to - from);
  const float distance = ray.y < -1e-4f ? std::min(-from.y / ray.y, reach) : reach;
  return {from.x + ray.x * distance, from.z + ray.z * distance};
}

}  // namespace

OverlayMarks makeOverlayMarks(const Project& project, const GraphEvaluator* graph, double time, float speedRange,
                              const Highlight& highlight) {
  const States state(highlight);
  OverlayMarks marks;
  std::unordered_map<Id, glm::vec2> places;
  for (const Point& point : project.graph->points) places.emplace(point.id, point.position);
  const float range = std::max(speedRange, 1e-3f);
  std::unordered_set<Id> shown;
  for (std::size_t i = 0; i < project.graph->arrows.size(); ++i) {
    const Arrow& arrow = project.graph->arrows[i];
    const auto from = places.find(arrow.from), to = places.find(arrow.to);
    if (arrow.hidden || from == places.end() || to == places.end()) continue;
    shown.insert(arrow.from);
    shown.insert(arrow.to);
    const float factor = graph != nullptr ? graph->factorAt(i, time) : 1.0f;
    const float end = arrow.where == Where::End ? 1.0f : 0.0f;
    marks.arrows.push_back({{from->second, to->second},
                            {arrow.radius, std::min(std::abs(arrow.strength) / range, 1.0f), factor, state(arrow.id)},
                            {end, arrow.muted ? 1.0f : 0.0f, 0.0f, 0.0f}});
  }
  const std::vector<Id> roots = findRoots(*project.graph);
  const bool anyHidden = std::ranges::any_of(project.graph->arrows, &Arrow::hidden);
  for (const Point& point : project.graph->points) {
    // A point all of whose arrows are hidden is hidden with them.
    if (anyHidden && !shown.contains(point.id)) continue;
    const float kind = std::ranges::binary_search(roots, point.id) ? MARK_ROOT : MARK_POINT;
    marks.points.push_back({{point.position, 0.0f, kind}, {0.0f, 0.0f, 0.0f, state(point.id)}, glm::vec4(0.0f)});
  }
  for (const Probe& probe : *project.probes) {
    if (probe.hidden) continue;
    marks.points.push_back({{probe.position, 0.0f, MARK_PROBE}, {0.0f, 0.0f, 0.0f, state(probe.id)}, glm::vec4(0.0f)});
  }
  for (const Obstacle& obstacle : *project.obstacles) {
    if (obstacle.hidden) continue;
    if (obstacle.shape == ObstacleShape::Polygon) {
      const std::vector<glm::vec2> corners = outlineOf(obstacle);
      for (std::size_t i = 0; i < corners.size(); ++i)
        marks.outlines.push_back({{corners[i], corners[(i + 1) % corners.size()]},
                                  {1.0f, 0.0f, obstacle.height, state(obstacle.id)},
                                  {SOLID_POLYGON, 0.0f, 0.0f, 0.0f}});
      continue;
    }
    const Solid solid = makeSolids({obstacle}).front();
    marks.outlines.push_back({solid.place, {solid.shape.x, solid.shape.y, solid.shape.z, state(obstacle.id)}, {solid.shape.w, 0.0f, 0.0f, 0.0f}});
  }
  return marks;
}

VectorLattice makeVectorLattice(const ViewCamera& camera, glm::ivec2 size, const FieldSettings& field) {
  const glm::mat4 inverse = glm::inverse(camera.projection(static_cast<float>(size.x) / static_cast<float>(size.y)) * camera.view());
  const glm::vec2 fieldLow = field.centre - 0.5f * field.size, fieldHigh = field.centre + 0.5f * field.size;
  const float reach = glm::length(field.size) + glm::length(camera.position - glm::vec3(field.centre.x, 0.0f, field.centre.y));
  glm::vec2 low(1e30f), high(-1e30f);
  for (const float x : {-1.0f, 0.0f, 1.0f}) {
    for (const float y : {-1.0f, 0.0f, 1.0f}) {
      const glm::vec2 at = onGround(inverse, {x, y}, reach);
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
  }
  low = glm::max(low, fieldLow);
  high = glm::min(high, fieldHigh);
  VectorLattice lattice;
  if (low.x >= high.x || low.y >= high.y) return lattice;
  const float wanted = std::max(high.x - low.x, high.y - low.y) / kVectorsAcross;
  lattice.spacing = std::exp2(std::ceil(std::log2(wanted) - 0.5f));
  const glm::vec2 start = glm::ceil(low / lattice.spacing), end = glm::floor(high / lattice.spacing);
  lattice.first = start * lattice.spacing;
  lattice.nodes = glm::max(glm::ivec2(end - start) + 1, glm::ivec2(0));
  return lattice;
}

}  // namespace windloom
