#include "editor/core/picking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <unordered_set>

#include "editor/core/collider_shape.hpp"
#include "editor/core/id_index.hpp"
#include "editor/core/selection.hpp"
#include "editor/core/surface_shape.hpp"
#include "engine/model/outline.hpp"

namespace windloom::editor {
namespace {

constexpr int kGroundPieces = 12;  // an arrow or a side on uneven ground

struct Nearest {
  float distance = std::numeric_limits<float>::infinity();
  float along = 0.0f;
};

Nearest nearestOnSegment(glm::vec2 pixel, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 ab = b - a;
  const float length2 = glm::dot(ab, ab);
  const float t = length2 > 1e-12f ? std::clamp(glm::dot(pixel - a, ab) / length2, 0.0f, 1.0f) : 0.0f;
  return {glm::distance(pixel, a + t * ab), t};
}

/// One query: a pixel against a view of the ground.
class Picker {
 public:
  Picker(const ViewMapping& view, const Ground& ground, glm::vec2 pixel)
      : m_view(view), m_ground(ground), m_pixel(pixel), m_place(view.toGround(pixel, ground)) {}

  [[nodiscard]] float toPlace(glm::vec2 world) const {
    const auto screen = m_view.groundToScreen(world, m_ground);
    return screen ? glm::distance(*screen, m_pixel) : std::numeric_limits<float>::infinity();
  }

  /// Distance to a line on the ground. Parts behind the camera don't count.
  [[nodiscard]] Nearest toLine(glm::vec2 a, glm::vec2 b) const {
    const int pieces = m_ground.height ? kGroundPieces : needsPieces(a, b) ? 4 * kGroundPieces : 1;
    Nearest best;
    auto before = m_view.groundToScreen(a, m_ground);
    for (int i = 1; i <= pieces; ++i) {
      const float t = static_cast<float>(i) / static_cast<float>(pieces);
      const auto here = m_view.groundToScreen(glm::mix(a, b, t), m_ground);
      if (before && here) {
        Nearest piece = nearestOnSegment(m_pixel, *before, *here);
        piece.along = (static_cast<float>(i - 1) + piece.along) / static_cast<float>(pieces);
        if (piece.distance < best.distance) best = piece;
      }
      before = here;
    }
    // In perspective the middle on the screen is not the middle on the ground.
    if (m_place && best.distance < std::numeric_limits<float>::infinity()) {
      best.along = nearestOnSegment(*m_place, a, b).along;
    }
    return best;
  }

  [[nodiscard]] float toOutline(const std::vector<glm::vec2>& outline) const {
    float best = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      best = std::min(best, toLine(outline[i], outline[(i + 1) % outline.size()]).distance);
    }
    return best;
  }

  template <class Thing>
  [[nodiscard]] bool inside(const Thing& thing) const {
    return m_place && isInside(thing, *m_place);
  }

  /// False where an outline that reaches so far from its centre is surely away from the pixel: saves the outline.
  [[nodiscard]] bool couldReach(glm::vec2 centre, float reachM, float radiusPx) const {
    if (!m_place) return true;
    const float reach = 4.0f * radiusPx * m_view.metresPerPixel(m_ground.lift(centre));
    const float grazing = std::max(0.05f, -m_view.camera().forward().y);  // a pixel covers more ground edge-on
    return glm::distance(*m_place, centre) <= reachM + reach / grazing;
  }

 private:
  /// Whether an end lies behind the camera, so that the line has to be cut.
  [[nodiscard]] bool needsPieces(glm::vec2 a, glm::vec2 b) const {
    return !m_view.groundToScreen(a, m_ground) || !m_view.groundToScreen(b, m_ground);
  }

  const ViewMapping& m_view;
  const Ground& m_ground;
  glm::vec2 m_pixel;
  std::optional<glm::vec2> m_place;
};

int rank(const Hit& hit) {
  if (hit.isHandle()) return 0;
  if (hit.kind == ObjectKind::Arrow) return 1;
  return hit.inside ? 3 : 2;
}

/// The outline of an obstacle or collider, or its inside.
template <class Thing>
void pickOutline(std::vector<Hit>& hits, const Picker& picker, const Thing& thing, glm::vec2 centre, ObjectKind kind,
                 float radiusPx) {
  const bool inside = picker.inside(thing);
  if (!inside && !picker.couldReach(centre, reachOf(thing), radiusPx)) return;
  const float distance = picker.toOutline(outlineOf(thing));
  if (distance <= radiusPx) {
    hits.push_back({kind, thing.id, distance, false, 0.0f, true});
  } else if (inside) {
    hits.push_back({kind, thing.id, 0.0f, true});
  }
}

void pickGraph(std::vector<Hit>& hits, const Project& project, const Picker& picker, const PickOptions& options) {
  const WindGraph& graph = *project.graph;
  if (options.points) {
    for (const Point& point : graph.points) {
      const float distance = picker.toPlace(point.position);
      if (distance > options.radiusPx || point.id == options.ignore) continue;
      if (isHidden(project, point.id) || isLocked(project, point.id)) continue;
      hits.push_back({ObjectKind::Point, point.id, distance});
    }
  }
  if (options.arrows && !graph.arrows.empty()) {
    const IdIndex index(project);
    for (const Arrow& arrow : graph.arrows) {
      if (arrow.hidden || arrow.locked || arrow.id == options.ignore) continue;
      const Point* from = index.point(arrow.from);
      const Point* to = index.point(arrow.to);
      if (!from || !to) continue;
      const Nearest near = picker.toLine(from->position, to->position);
      if (near.distance <= options.radiusPx) {
        hits.push_back({ObjectKind::Arrow, arrow.id, near.distance, false, near.along});
      }
    }
  }
}

void pickSurfaces(std::vector<Hit>& hits, const Project& project, const ViewMapping& view, const Ground& ground,
                  const Picker& picker, glm::vec2 pixel, const PickOptions& options) {
  for (const Surface& surface : *project.surfaces) {
    if (surface.hidden || surface.locked || surface.id == options.ignore) continue;
    const float distance = picker.toPlace(surface.position);
    const std::size_t before = hits.size();
    if (distance <= options.radiusPx) {
      hits.push_back({ObjectKind::Surface, surface.id, distance});
    } else {
      pickOutline(hits, picker, surface, surface.position, ObjectKind::Surface, options.radiusPx);
    }
    // Its body stands over other ground than its outline, seen from the side.
    if (hits.size() == before && meets(surface, ground, view.ray(pixel)))
      hits.push_back({ObjectKind::Surface, surface.id, 0.0f, true});
  }
}

void pickRotors(std::vector<Hit>& hits, const Project& project, const ViewMapping& view, const Ground& ground,
                const Picker& picker, glm::vec2 pixel, const PickOptions& options) {
  for (const Rotor& rotor : *project.rotors) {
    if (rotor.hidden || rotor.locked || rotor.id == options.ignore) continue;
    const float distance = picker.toPlace(rotor.position);
    if (distance <= options.radiusPx) {
      hits.push_back({ObjectKind::Rotor, rotor.id, distance});
      continue;
    }
    float nearest = std::numeric_limits<float>::infinity();
    const std::vector<glm::vec3> ring = ringOf(rotor, ground);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto a = view.toScreen(ring[i]), b = view.toScreen(ring[(i + 1) % ring.size()]);
      if (a && b) nearest = std::min(nearest, nearestOnSegment(pixel, *a, *b).distance);
    }
    if (nearest <= options.radiusPx) hits.push_back({ObjectKind::Rotor, rotor.id, nearest, false, 0.0f, true});
  }
}

}  // namespace

std::vector<Hit> pick(const Project& project, const ViewMapping& view, const Ground& ground, glm::vec2 pixel,
                      const PickOptions& options) {
  std::vector<Hit> hits;
  const Picker picker(view, ground, pixel);
  pickGraph(hits, project, picker, options);
  if (options.probes) {
    for (const Probe& probe : *project.probes) {
      if (probe.hidden || probe.locked || probe.id == options.ignore) continue;
      const float distance = picker.toPlace(probe.position);
      if (distance <= options.radiusPx) hits.push_back({ObjectKind::Probe, probe.id, distance});
    }
  }
  if (options.obstacles) {
    for (const Obstacle& obstacle : *project.obstacles) {
      if (obstacle.hidden || obstacle.locked || obstacle.id == options.ignore) continue;
      pickOutline(hits, picker, obstacle, obstacle.centre, ObjectKind::Obstacle, options.radiusPx);
    }
  }
  if (options.surfaces) pickSurfaces(hits, project, view, ground, picker, pixel, options);
  if (options.rotors) pickRotors(hits, project, view, ground, picker, pixel, options);
  if (options.colliders) {
    for (const Collider& collider : *project.colliders) {
      if (collider.hidden || collider.locked || collider.id == options.ignore) continue;
      const Collider shown = shownAt(collider, options.seconds);
      const float distance = picker.toPlace(shown.position);
      if (distance <= options.radiusPx) {
        hits.push_back({ObjectKind::Collider, collider.id, distance});
      } else {
        pickOutline(hits, picker, shown, shown.position, ObjectKind::Collider, options.radiusPx);
      }
    }
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tuple(rank(a), a.distancePx, a.id) < std::tuple(rank(b), b.distancePx, b.id);
  });
  return hits;
}

PickOptions onlyGraph() {
  return {.obstacles = false, .colliders = false, .surfaces = false, .rotors = false, .probes = false};
}

PickOptions onlyPoints() {
  PickOptions options = onlyGraph();
  options.arrows = false;
  return options;
}

Id cycleHit(const std::vector<Hit>& hits, Id current) {
  if (hits.empty()) return 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].id == current) return hits[(i + 1) % hits.size()].id;
  }
  return hits.front().id;
}

std::vector<Id> pickBox(const Project& project, const ViewMapping& view, const Ground& ground, glm::vec2 cornerA,
                        glm::vec2 cornerB, double seconds) {
  const glm::vec2 low = glm::min(cornerA, cornerB), high = glm::max(cornerA, cornerB);
  const auto within = [&](glm::vec2 world) {
    const auto pixel = view.groundToScreen(world, ground);
    return pixel && pixel->x >= low.x && pixel->y >= low.y && pixel->x <= high.x && pixel->y <= high.y;
  };
  const IdIndex index(project);
  std::vector<Id> found;
  for (const Id id : selectableIds(project)) {
    const Arrow* arrow = index.arrow(id);
    const Point* point = index.point(arrow ? arrow->from : id);
    const Point* end = arrow ? index.point(arrow->to) : nullptr;
    const Obstacle* obstacle = index.obstacle(id);
    const Collider* collider = index.collider(id);
    const Surface* surface = index.surface(id);
    const Rotor* rotor = index.rotor(id);
    const Probe* probe = index.probe(id);
    const bool inside = arrow      ? point && end && within(point->position) && within(end->position)
                        : point    ? within(point->position)
                        : obstacle ? within(obstacle->centre)
                        : collider ? within(shownAt(*collider, seconds).position)
                        : surface  ? within(surface->position)
                        : rotor    ? within(rotor->position)
                                   : probe && within(probe->position);
    if (inside) found.push_back(id);
  }
  return found;
}

}  // namespace windloom::editor
