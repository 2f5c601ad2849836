#include "editor/viewport/handles.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "editor/core/object_kind.hpp"
#include "editor/viewport/ground_brush.hpp"
#include "engine/model/collider_motion.hpp"

namespace windloom::editor {

namespace {

constexpr float kPointRadius = 4.5f, kRootRadius = 6.0f;

/// On a plate, so that it is readable over grass, discs and arrows.
void drawLabel(const GroundBrush& brush, ImVec2 corner, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  brush.list().AddRectFilled({corner.x - scaled(4), corner.y - scaled(2)},
                             {corner.x + size.x + scaled(4), corner.y + size.y + scaled(2)},
                             packed(look().palette.overlayBack), scaled(3));
  brush.list().AddText(corner, packed(look().palette.overlayText), text.c_str());
}

void handleDot(const GroundBrush& brush, ImVec2 at, float radius, bool selected, bool hovered) {
  const Palette& palette = look().palette;
  ImDrawList& list = brush.list();
  if (selected) list.AddCircle(at, radius + scaled(4), packed(palette.accent), 0, scaled(2));
  list.AddCircleFilled(at, radius + scaled(1.5f), IM_COL32(10, 12, 14, 190));
  const ImVec4 white{1, 1, 1, 1};
  list.AddCircleFilled(at, hovered ? radius + scaled(1) : radius, packed(hovered ? palette.accent : white));
}

void drawArrows(const GroundBrush& brush, const WindGraph& graph, const Marks& marks, bool withArrows) {
  const Palette& palette = look().palette;
  const bool mapped = brush.named(), many = isMany(graph);
  // Without a scene all arrows are drawn here; with one only the marked ones get a line on top.
  if (!withArrows && !mapped && marks.chosen.empty() && marks.hovered == 0) return;
  std::unordered_map<Id, glm::vec2> places;
  for (const Point& point : graph.points) places.emplace(point.id, point.position);
  for (const Arrow& arrow : graph.arrows) {
    if (arrow.hidden) continue;
    const bool selected = marks.selected(arrow.id), hovered = marks.hovered == arrow.id;
    if (!withArrows && !mapped && !selected && !hovered) continue;
    const auto from = places.find(arrow.from), to = places.find(arrow.to);
    if (from == places.end() || to == places.end()) continue;
    const glm::vec3 a = brush.ground().lift(from->second), b = brush.ground().lift(to->second);
    if (const auto middle = brush.screen((from->second + to->second) * 0.5f))
      name(brush, "arrow:" + std::to_string(arrow.id), *middle);
    const ImVec4 plain{0.85f, 0.93f, 1.0f, 0.9f};
    // Among many the scene's own highlight has to do.
    if (withArrows || (selected && !many) || hovered)
      brush.arrow(a, b, packed(selected ? palette.accent : plain, hovered || selected ? 1.0f : 0.75f),
                  scaled(selected ? 3.0f : 2.0f));
  }
}

void drawPoints(const GroundBrush& brush, const Project& project, const Marks& marks) {
  const WindGraph& graph = *project.graph;
  std::unordered_set<Id> ends, shown;
  for (const Arrow& arrow : graph.arrows) {
    ends.insert(arrow.to);
    if (arrow.hidden) continue;
    shown.insert(arrow.from);
    shown.insert(arrow.to);
  }
  const bool many = isMany(graph);
  const ImU32 accent = packed(look().palette.accent);
  for (const Point& point : graph.points) {
    if (!shown.contains(point.id) && ends.contains(point.id)) continue;
    const auto at = brush.screen(point.position);
    if (!at || !brush.inside(*at)) continue;
    const bool selected = marks.selected(point.id), hovered = marks.hovered == point.id;
    const float radius = scaled(ends.contains(point.id) ? kPointRadius : kRootRadius);
    if (many && !hovered)
      brush.list().AddRectFilled({at->x - 2, at->y - 2}, {at->x + 2, at->y + 2}, selected ? accent : IM_COL32_WHITE);
    else
      handleDot(brush, *at, radius, selected, hovered);
    name(brush, "point:" + std::to_string(point.id), *at);
    if (!point.name.empty() && (selected || hovered))
      drawLabel(brush, {at->x + radius + scaled(6), at->y - ImGui::GetTextLineHeight()}, point.name);
  }
}

void drawObstacles(const GroundBrush& brush, const Project& project, const Marks& marks, bool withOutlines) {
  const Palette& palette = look().palette;
  for (const Obstacle& o : *project.obstacles) {
    if (o.hidden) continue;
    const bool selected = marks.selected(o.id), hovered = marks.hovered == o.id;
    const auto at = brush.screen(o.centre);
    if (at) name(brush, "obstacle:" + std::to_string(o.id), *at);
    if (!withOutlines && !selected && !hovered) continue;
    const ImVec4 plain{0.9f, 0.85f, 0.75f, 0.9f};
    const ImU32 colour = packed(selected ? palette.accent : plain);
    brush.outline(o, colour, scaled(2));
  }
}

/// Where it goes; a dot for each key.
void drawWay(const GroundBrush& brush, const Collider& collider) {
  constexpr std::size_t kPieces = 8, kMostPieces = 1000;
  const ImU32 colour = packed(look().palette.accent, 0.8f);
  const auto lifted = [&](glm::vec3 offset) {
    const glm::vec2 place = collider.position + glm::vec2(offset.x, offset.z);
    return brush.ground().lift(place) + glm::vec3(0.0f, collider.lift + offset.y, 0.0f);
  };
  if (collider.keys.size() < 2) return;
  const double start = double(collider.keys.front().time), end = double(collider.keys.back().time);
  const std::size_t pieces = std::min(kPieces * (collider.keys.size() - 1), kMostPieces);
  Collider once = collider;
  once.loop = false;  // so that the last time is the last key's
  glm::vec3 before = lifted(once.keys.front().offset);
  for (std::size_t i = 1; i <= pieces; ++i) {
    const glm::vec3 here = lifted(colliderOffset(once, start + (end - start) * double(i) / double(pieces)));
    brush.line(before, here, colour, scaled(1.5f));
    before = here;
  }
  if (collider.keys.size() > kMostPieces) return;
  for (const ColliderKey& key : collider.keys) {
    if (const auto at = brush.screen(lifted(key.offset)); at && brush.inside(*at))
      brush.list().AddCircleFilled(*at, scaled(2.5f), colour);
  }
}

void drawColliders(const GroundBrush& brush, const Project& project, const Marks& marks, double seconds,
                   bool withOutlines) {
  const Palette& palette = look().palette;
  for (const Collider& collider : *project.colliders) {
    const Collider shown = shownAt(collider, seconds);
    const auto at = collider.hidden ? std::nullopt : brush.screen(shown.position);
    if (!at) continue;
    const bool selected = marks.selected(collider.id), hovered = marks.hovered == collider.id;
    const ImVec4 plain{0.78f, 0.82f, 1.0f, 0.95f};
    if (selected) drawWay(brush, collider);
    if (withOutlines || selected || hovered) brush.outline(shown, packed(selected ? palette.accent : plain), scaled(2));
    if (!brush.inside(*at)) continue;
    diamond(brush, *at, selected || hovered,
            packed(selected || hovered ? palette.accent : plain, collider.muted ? 0.5f : 1.0f));
    name(brush, "collider:" + std::to_string(collider.id), *at);
  }
}

void drawProbes(const GroundBrush& brush, const Project& project, const Marks& marks) {
  const Palette& palette = look().palette;
  for (const Probe& probe : *project.probes) {
    const auto at = probe.hidden ? std::nullopt : brush.screen(probe.position);
    if (!at || !brush.inside(*at)) continue;
    const bool marked = marks.selected(probe.id) || marks.hovered == probe.id;
    const ImVec4 yellow{0.98f, 0.86f, 0.36f, 1.0f};
    const ImU32 colour = packed(marked ? palette.accent : yellow);
    const float arm = scaled(9), gap = scaled(3);
    ImDrawList& list = brush.list();
    list.AddCircle(*at, scaled(5.5f), colour, 0, scaled(2));
    for (const ImVec2 way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)})
      list.AddLine({at->x + way.x * gap, at->y + way.y * gap}, {at->x + way.x * arm, at->y + way.y * arm}, colour,
                   scaled(2));
    name(brush, "probe:" + std::to_string(probe.id), *at);
  }
}

ImU32 roleColour(ShapeRole role) {
  const Palette& palette = look().palette;
  switch (role) {
    case ShapeRole::Preview:
      return packed({1, 1, 1, 0.95f});
    case ShapeRole::Snap:
      return packed(palette.good);
    case ShapeRole::Refused:
      return packed(palette.error);
    case ShapeRole::Guide:
      return packed({1, 1, 1, 0.5f});
    case ShapeRole::AxisX:
      return packed(palette.axisX);
    case ShapeRole::AxisZ:
      return packed(palette.axisZ);
  }
  return IM_COL32_WHITE;
}

void drawGrip(const GroundBrush& brush, const PreviewShapes::Grip& grip) {
  const auto at = brush.screen(grip.at);
  if (!at) return;
  name(brush, grip.name, *at);
  ImDrawList& list = brush.list();
  const ImU32 dark = IM_COL32(10, 12, 14, 200);
  const ImU32 colour = grip.hot ? packed(look().palette.accent) : roleColour(grip.role);
  const float side = scaled(grip.hot ? 6.0f : 5.0f);
  if (grip.form == PreviewShapes::GripForm::Round) {
    list.AddCircleFilled(*at, side + scaled(1.5f), dark);
    list.AddCircleFilled(*at, side, colour);
  } else if (grip.form == PreviewShapes::GripForm::Square) {
    const float outer = side + scaled(1.5f);
    list.AddRectFilled({at->x - outer, at->y - outer}, {at->x + outer, at->y + outer}, dark);
    list.AddRectFilled({at->x - side, at->y - side}, {at->x + side, at->y + side}, colour);
  } else if (const auto from = brush.screen(grip.from)) {
    const float dx = at->x - from->x, dy = at->y - from->y, length = std::max(1.0f, std::hypot(dx, dy));
    const ImVec2 along{dx / length, dy / length}, across{-along.y, along.x};
    const float head = scaled(grip.hot ? 15.0f : 13.0f), wide = 0.45f * head;
    list.AddTriangleFilled(
        {at->x + along.x * head * 0.6f, at->y + along.y * head * 0.6f},
        {at->x - along.x * head * 0.4f + across.x * wide, at->y - along.y * head * 0.4f + across.y * wide},
        {at->x - along.x * head * 0.4f - across.x * wide, at->y - along.y * head * 0.4f - across.y * wide}, colour);
  }
}

}  // namespace

void drawHandles(const ViewArea& area, const Workspace& workspace, bool withArrows) {
  const GroundBrush brush(area, workspace);
  const Project& project = workspace.document.project();
  const auto ids = workspace.selection.ids();
  const Marks marks{{ids.begin(), ids.end()}, workspace.tools.hovered()};
  drawObstacles(brush, project, marks, withArrows);
  drawArrows(brush, *project.graph, marks, withArrows);
  drawPoints(brush, project, marks);
  drawColliders(brush, project, marks, workspace.windSeconds, withArrows);
  drawSurfaces(brush, project, marks, withArrows);
  drawRotors(brush, project, marks);
  drawProbes(brush, project, marks);
}

void drawPreview(const ViewArea& area, const Workspace& workspace, const PreviewShapes& shapes) {
  const GroundBrush brush(area, workspace);
  ImDrawList& list = brush.list();
  for (const auto& disc : shapes.discs)
    brush.ring(disc.centre, disc.radius, roleColour(disc.role), scaled(disc.bold ? 2.5f : 1.5f));
  for (const auto& line : shapes.lines)
    brush.line(line.a, line.b, roleColour(line.role), scaled(line.bold ? 2.5f : 1.5f));
  for (const auto& arrow : shapes.arrows) {
    brush.arrow(arrow.from, arrow.to, roleColour(arrow.role), scaled(3));
    brush.ring(arrow.to, arrow.radius, packed({1, 1, 1, 0.35f}), scaled(1));
  }
  for (const auto& dot : shapes.dots)
    if (const auto at = brush.screen(dot.at)) {
      list.AddCircleFilled(*at, scaled(kPointRadius + 1), IM_COL32(10, 12, 14, 190));
      list.AddCircleFilled(*at, scaled(kPointRadius), roleColour(dot.role));
    }
  for (const auto& grip : shapes.grips) drawGrip(brush, grip);
  for (const auto& box : shapes.rectangles) {
    list.AddRectFilled(area.at(box.low), area.at(box.high), packed(look().palette.accent, 0.15f));
    list.AddRect(area.at(box.low), area.at(box.high), packed(look().palette.accent), 0, 0, scaled(1));
  }
  for (const auto& label : shapes.labels) {
    const ImVec2 at = area.at(label.pixel), size = ImGui::CalcTextSize(label.text.c_str());
    // Kept inside: near the edge the text moves to where it can be read.
    const ImVec2 corner{std::min(at.x, area.max.x - size.x - scaled(8)),
                        std::min(at.y, area.max.y - size.y - scaled(6))};
    drawLabel(brush, corner, label.text);
  }
}

}  // namespace windloom::editor
