#include "editor/core/grips.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "editor/core/collider_shape.hpp"
#include "editor/core/object_edits.hpp"
#include "editor/core/surface_shape.hpp"
#include "engine/model/outline.hpp"

namespace windloom::editor {
namespace {

constexpr float kCentreGapPx = 14.0f;  // arms begin beside the centre
constexpr int kRingPieces = 48;

float scaleOf(const ToolContext& context) {
  return context.settings.hitRadiusPx / kHitRadiusPx;
}

/// Metres on the ground for so many pixels at a place.
float metresFor(const ToolContext& context, glm::vec2 place, float pixels) {
  return pixels * scaleOf(context) * context.view.metresPerPixel(context.ground.lift(place));
}

float toSegment(glm::vec2 pixel, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 ab = b - a;
  const float length2 = glm::dot(ab, ab);
  const float t = length2 > 1e-9f ? std::clamp(glm::dot(pixel - a, ab) / length2, 0.0f, 1.0f) : 0.0f;
  return glm::distance(pixel, a + t * ab);
}

void addGizmo(const ToolContext& context, SelectKind tool, std::vector<Grip>& grips) {
  const auto pivot = pivotOf(context.document.project(), context.selection.ids());
  if (!pivot) return;
  const float arm = metresFor(context, *pivot, kGizmoPx);
  if (tool == SelectKind::Rotate) {
    grips.push_back({GripKind::Ring, 0, 0, *pivot, *pivot});
    return;
  }
  grips.push_back({GripKind::Centre, 0, 0, *pivot, *pivot});
  grips.push_back({GripKind::AxisX, 0, 0, *pivot + glm::vec2(arm, 0.0f), *pivot});
  grips.push_back({GripKind::AxisZ, 0, 0, *pivot + glm::vec2(0.0f, arm), *pivot});
}

void addOutline(const ToolContext& context, std::vector<Grip>& grips) {
  const Obstacle* o = findObstacle(context.document.project(), context.selection.active());
  if (!o || o->hidden || o->locked) return;
  const auto add = [&](GripKind kind, int index, glm::vec2 own) {
    grips.push_back({kind, o->id, index, toWorld(*o, own), o->centre});
  };
  const float beyond = metresFor(context, o->centre, 28.0f);
  switch (o->shape) {
    case ObstacleShape::Circle:
      add(GripKind::Radius, 0, {o->radius, 0.0f});
      break;
    case ObstacleShape::Box:
      for (int side = 0; side < 4; ++side) {
        const float sign = side % 2 == 0 ? -0.5f : 0.5f;
        add(GripKind::Side, side, side < 2 ? glm::vec2(sign * o->size.x, 0.0f) : glm::vec2(0.0f, sign * o->size.y));
      }
      add(GripKind::Turn, 0, {0.5f * o->size.x + beyond, 0.0f});
      break;
    case ObstacleShape::Polygon:
      for (std::size_t i = 0; i < o->points.size(); ++i) add(GripKind::Corner, static_cast<int>(i), o->points[i]);
      add(GripKind::Turn, 0, {halfExtentOf(*o).x + beyond, 0.0f});
      break;
  }
}

void addCollider(const ToolContext& context, std::vector<Grip>& grips) {
  const Collider* c = findCollider(context.document.project(), context.selection.active());
  if (!c || c->hidden || c->locked) return;
  const Collider shown = shownAt(*c, context.windSeconds);
  const auto add = [&](GripKind kind, glm::vec2 own) {
    grips.push_back({kind, c->id, 0, toWorld(shown, own), shown.position});
  };
  if (c->shape == ColliderShape::Sphere) add(GripKind::Radius, {c->radius, 0.0f});
  if (c->shape == ColliderShape::Capsule) add(GripKind::Radius, {0.0f, c->radius});
  // One that moves points along its way.
  if (c->shape == ColliderShape::Sphere || c->keys.size() > 1) return;
  add(GripKind::Turn, {reachOf(*c) + metresFor(context, c->position, 28.0f), 0.0f});
}

void addSurface(const ToolContext& context, std::vector<Grip>& grips) {
  const Surface* s = findSurface(context.document.project(), context.selection.active());
  if (!s || s->hidden || s->locked) return;
  const float edge = boxOf(*s).high.x;
  const auto add = [&](GripKind kind, float along) {
    grips.push_back({kind, s->id, 0, toWorld(*s, {along, 0.0f}), s->position});
  };
  add(GripKind::Radius, edge);
  add(GripKind::Turn, edge + metresFor(context, s->position, 28.0f));
}

void addRotor(const ToolContext& context, std::vector<Grip>& grips) {
  const Rotor* r = findRotor(context.document.project(), context.selection.active());
  if (!r || r->hidden || r->locked) return;
  grips.push_back({GripKind::Radius, r->id, 0, r->position + glm::vec2(r->radius, 0.0f), r->position});
}

/// Pixels from the pointer; infinite behind the camera.
float distanceTo(const ToolContext& context, const Grip& grip, glm::vec2 pixel) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  const auto at = context.view.groundToScreen(grip.place, context.ground);
  if (!at) return kFar;
  if (grip.kind == GripKind::Ring) {
    const float radius = metresFor(context, grip.place, kGizmoPx);
    float best = kFar;
    std::optional<glm::vec2> before;
    for (int i = 0; i <= kRingPieces; ++i) {
      const float angle = glm::radians(360.0f * static_cast<float>(i) / kRingPieces);
      const auto here = context.view.groundToScreen(grip.place + radius * glm::vec2(std::cos(angle), std::sin(angle)),
                                                    context.ground);
      if (before && here) best = std::min(best, toSegment(pixel, *before, *here));
      before = here;
    }
    return best;
  }
  if (grip.kind != GripKind::AxisX && grip.kind != GripKind::AxisZ) return glm::distance(pixel, *at);
  const auto middle = context.view.groundToScreen(grip.pivot, context.ground);
  const float length = middle ? glm::distance(*middle, *at) : 0.0f;
  if (length < 1.0f) return kFar;
  const glm::vec2 start = *middle + (*at - *middle) * std::min(1.0f, kCentreGapPx * scaleOf(context) / length);
  return toSegment(pixel, start, *at);
}

bool yields(const Grip& grip) {
  return grip.kind == GripKind::AxisX || grip.kind == GripKind::AxisZ || grip.kind == GripKind::Ring;
}

const char* nameOf(GripKind kind) {
  switch (kind) {
    case GripKind::AxisX:
      return "x";
    case GripKind::AxisZ:
      return "z";
    case GripKind::Centre:
      return "centre";
    case GripKind::Ring:
      return "ring";
    case GripKind::Radius:
      return "radius";
    case GripKind::Side:
      return "side";
    case GripKind::Turn:
      return "turn";
    case GripKind::Corner:
      return "corner";
  }
  return "";
}

PreviewShapes::Grip shapeOf(const ToolContext& context, SelectKind tool, const Grip& grip) {
  PreviewShapes::Grip shape;
  shape.at = context.ground.lift(grip.place);
  shape.from = context.ground.lift(grip.pivot);
  const bool arm = grip.kind == GripKind::AxisX || grip.kind == GripKind::AxisZ;
  shape.form = arm && tool == SelectKind::Move                                ? PreviewShapes::GripForm::Tip
               : grip.kind == GripKind::Turn || grip.kind == GripKind::Corner ? PreviewShapes::GripForm::Round
                                                                              : PreviewShapes::GripForm::Square;
  shape.role = grip.kind == GripKind::AxisX   ? ShapeRole::AxisX
               : grip.kind == GripKind::AxisZ ? ShapeRole::AxisZ
                                              : ShapeRole::Preview;
  shape.name = std::string("grip:") + nameOf(grip.kind);
  if (grip.kind == GripKind::Side || grip.kind == GripKind::Corner)
    shape.name.append(":").append(std::to_string(grip.index));
  return shape;
}

}  // namespace

std::vector<Grip> gripsOf(const ToolContext& context, SelectKind tool) {
  std::vector<Grip> grips;
  if (context.selection.empty()) return grips;
  if (tool == SelectKind::Select || tool == SelectKind::Move) {
    addOutline(context, grips);
    addCollider(context, grips);
    addSurface(context, grips);
    addRotor(context, grips);
  }
  if (tool != SelectKind::Select) addGizmo(context, tool, grips);
  return grips;
}

std::optional<Grip> gripAt(const ToolContext& context, SelectKind tool, glm::vec2 pixel) {
  std::optional<Grip> best;
  float nearest = context.settings.hitRadiusPx;
  for (const Grip& grip : gripsOf(context, tool)) {
    const float distance = distanceTo(context, grip, pixel);
    // What comes later in the list is drawn on top.
    if (distance > nearest) continue;
    nearest = distance;
    best = grip;
  }
  if (best && yields(*best)) {
    for (const Hit& hit : context.hits(
             pixel, {.arrows = false, .obstacles = false, .colliders = false, .surfaces = false, .rotors = false})) {
      if (!context.selection.contains(hit.id)) return std::nullopt;
    }
  }
  return best;
}

void addGripShapes(const ToolContext& context, SelectKind tool, const std::optional<Grip>& hot, PreviewShapes& shapes) {
  for (const Grip& grip : gripsOf(context, tool)) {
    const bool isHot = hot && *hot == grip;
    PreviewShapes::Grip shape = shapeOf(context, tool, grip);
    shape.hot = isHot;
    if (grip.kind == GripKind::Ring) {
      const float radius = metresFor(context, grip.place, kGizmoPx);
      shapes.discs.push_back({shape.at, radius, isHot ? ShapeRole::Snap : ShapeRole::Preview, true});
      shape.at = context.ground.lift(grip.place + glm::vec2(radius, 0.0f));
      shape.form = PreviewShapes::GripForm::Round;
    } else if (grip.kind == GripKind::AxisX || grip.kind == GripKind::AxisZ) {
      shapes.lines.push_back({shape.from, shape.at, isHot ? ShapeRole::Snap : shape.role, true});
    } else if (grip.kind == GripKind::Turn) {
      shapes.lines.push_back({shape.from, shape.at, ShapeRole::Guide});
    }
    shapes.grips.push_back(std::move(shape));
  }
}

std::string gripHint(const Grip& grip) {
  switch (grip.kind) {
    case GripKind::AxisX:
      return "Drag along x";
    case GripKind::AxisZ:
      return "Drag along z";
    case GripKind::Centre:
      return "Drag both axes";
    case GripKind::Ring:
      return "Drag around to turn";
    case GripKind::Radius:
      return "Drag to change how large it is";
    case GripKind::Side:
      return "Drag to move this side; the opposite one stays";
    case GripKind::Turn:
      return "Drag around to turn it";
    case GripKind::Corner:
      return "Drag to move the corner, Del takes it out; Ctrl+click on a side puts one in";
  }
  return {};
}

}  // namespace windloom::editor
