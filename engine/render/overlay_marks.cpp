#include "engine/render/overlay_marks.hpp"

#include <algorithm>
#include <cmath>

#include "engine/model/id_index.hpp"
#include "engine/model/outline.hpp"
#include "engine/render/solids.hpp"

namespace windloom {
namespace {

constexpr float kLeastHub = 0.42f;  // m
constexpr float kHubShare = 1.3f;   // of half the width of the widest arrow at a point

class States {
 public:
  explicit States(const Highlight& highlight)
      : m_any(!highlight.selected.empty()),
        m_selected(highlight.selected, [](Id id) { return id; }),
        m_hovered(highlight.hovered) {}
  float operator()(Id id) const {
    if (m_any && m_selected.find(id)) return MARK_SELECTED;
    return id != 0 && id == m_hovered ? MARK_HOVERED : MARK_NORMAL;
  }

 private:
  bool m_any;
  IdIndex m_selected;
  Id m_hovered;
};

/// What a point needs to know of its arrows.
struct Hub {
  float radius = kLeastHub;
  bool joined = false, shown = false;  // has arrows; has arrows that are not hidden
};

std::vector<Hub> makeHubs(const WindGraph& graph, const GraphLinks& links) {
  std::vector<Hub> hubs(graph.points.size());
  for (std::size_t a = 0; a < graph.arrows.size(); ++a) {
    if (links.from[a] == GraphLinks::kNone) continue;
    const Arrow& arrow = graph.arrows[a];
    const float radius = kHubShare * shared::arrowHalfWidth(arrow.radius);
    for (const std::uint32_t end : {links.from[a], links.to[a]}) {
      hubs[end].joined = true;
      if (arrow.hidden) continue;
      hubs[end].shown = true;
      hubs[end].radius = std::max(hubs[end].radius, radius);
    }
  }
  return hubs;
}

void addArrows(OverlayMarks& marks, const WindGraph& graph, const GraphLinks& links, const std::vector<Hub>& hubs,
               const OverlaySignals& signals, const States& state) {
  marks.arrows.reserve(graph.arrows.size());
  for (std::size_t a = 0; a < graph.arrows.size(); ++a) {
    const Arrow& arrow = graph.arrows[a];
    if (arrow.hidden || links.from[a] == GraphLinks::kNone) continue;
    const std::uint32_t from = links.from[a], to = links.to[a];
    const OverlaySignals::Stretch stretch = signals.stretch(a);
    marks.arrows.push_back(
        {{graph.points[from].position, graph.points[to].position},
         {arrow.radius, arrow.strength, arrow.muted ? 1.0f : 0.0f, state(arrow.id)},
         {arrow.where == Where::End ? 1.0f : 0.0f, hubs[from].radius, hubs[to].radius, arrow.travelSpeed},
         {stretch.first, stretch.span, 0.0f, 0.0f}});
  }
}

void addPoints(OverlayMarks& marks, const WindGraph& graph, const GraphLinks& links, const std::vector<Hub>& hubs,
               const States& state) {
  std::vector<char> isRoot(graph.points.size(), 0);
  for (const std::uint32_t root : rootIndices(graph, links)) isRoot[root] = 1;
  marks.points.reserve(graph.points.size());
  for (std::size_t i = 0; i < graph.points.size(); ++i) {
    // A point all of whose arrows are hidden is hidden with them.
    if (hubs[i].joined && !hubs[i].shown) continue;
    const Point& point = graph.points[i];
    const float kind = isRoot[i] != 0 ? MARK_ROOT : MARK_POINT;
    marks.points.push_back({{point.position, hubs[i].radius, kind}, {0.0f, 0.0f, 0.0f, state(point.id)}, {}, {}});
  }
}

}  // namespace

OverlayMarks makeOverlayMarks(const Project& project, const GraphLinks& links, const OverlaySignals& signals,
                              const Highlight& highlight) {
  const States state(highlight);
  const WindGraph& graph = *project.graph;
  const std::vector<Hub> hubs = makeHubs(graph, links);
  OverlayMarks marks;
  addArrows(marks, graph, links, hubs, signals, state);
  addPoints(marks, graph, links, hubs, state);
  for (const Probe& probe : *project.probes) {
    if (probe.hidden) continue;
    marks.points.push_back({{probe.position, kLeastHub, MARK_PROBE}, {0.0f, 0.0f, 0.0f, state(probe.id)}, {}, {}});
  }
  for (const Obstacle& obstacle : *project.obstacles) {
    if (obstacle.hidden) continue;
    if (obstacle.shape == ObstacleShape::Polygon) {
      const std::vector<glm::vec2> corners = outlineOf(obstacle);
      for (std::size_t i = 0; i < corners.size(); ++i)
        marks.outlines.push_back({{corners[i], corners[(i + 1) % corners.size()]},
                                  {1.0f, 0.0f, obstacle.height, state(obstacle.id)},
                                  {SOLID_POLYGON, obstacle.centre.x, obstacle.centre.y, 0.0f},
                                  {}});
      continue;
    }
    const Solid solid = makeSolids({obstacle}).front();
    marks.outlines.push_back(
        {solid.place, {solid.shape.x, solid.shape.y, solid.shape.z, state(obstacle.id)}, {solid.shape.w, 0, 0, 0}, {}});
  }
  return marks;
}

bool MarkCache::fresh(const FrameInput& input) const {
  const Project& project = *input.project;
  return m_graph == project.graph && m_obstacles == project.obstacles && m_probes == project.probes &&
         m_evaluated == (input.graph != nullptr) && m_hovered == input.highlight.hovered &&
         std::ranges::equal(m_selected, input.highlight.selected);
}

MarkCache::Change MarkCache::update(const FrameInput& input) {
  Change change;
  if (!fresh(input)) {
    const Project& project = *input.project;
    const GraphLinks links(*project.graph);
    if (m_graph != project.graph || m_evaluated != (input.graph != nullptr)) {
      m_signals.build(*project.graph, links, input.graph);
    }
    m_marks = makeOverlayMarks(project, links, m_signals, input.highlight);
    m_graph = project.graph;
    m_obstacles = project.obstacles;
    m_probes = project.probes;
    m_evaluated = input.graph != nullptr;
    m_selected.assign(input.highlight.selected.begin(), input.highlight.selected.end());
    m_hovered = input.highlight.hovered;
    change.marks = true;
  }
  change.levels = m_signals.refresh(input.time);
  return change;
}

}  // namespace windloom
