#include "editor/panels/outliner.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "editor/core/graph_edits.hpp"
#include "editor/core/object_kind.hpp"
#include "editor/widgets/icons.hpp"
#include "editor/widgets/number_field.hpp"

namespace windloom::editor {

namespace {

std::string named(const std::string& name, const char* kind, Id id) {
  return name.empty() ? std::string(kind) + " " + std::to_string(id) : name;
}

/// Arrow indices by the point they leave.
std::unordered_map<Id, std::vector<std::size_t>> leaving(const WindGraph& graph) {
  std::unordered_map<Id, std::vector<std::size_t>> map;
  for (std::size_t i = 0; i < graph.arrows.size(); ++i) map[graph.arrows[i].from].push_back(i);
  return map;
}

const char* symbolOf(ObstacleShape shape) {
  switch (shape) {
    case ObstacleShape::Circle:
      return icons::icon(icons::kObstacle, "o");
    case ObstacleShape::Box:
      return icons::icon(icons::kBox, "#");
    case ObstacleShape::Polygon:
      break;
  }
  return icons::icon(icons::kPolygon, "<>");
}

const char* symbolOf(PlantShape shape) {
  switch (shape) {
    case PlantShape::Blade:
      return icons::icon(icons::kLeaf, "|");
    case PlantShape::Daisy:
    case PlantShape::Poppy:
    case PlantShape::Spike:
      return icons::icon(icons::kPlant, "*");
    case PlantShape::Mesh:
      break;
  }
  return icons::icon(icons::kMesh, "[]");
}

const char* symbolOf(ColliderShape shape) {
  switch (shape) {
    case ColliderShape::Sphere:
      return icons::icon(icons::kBall, "o");
    case ColliderShape::Capsule:
      return icons::icon(icons::kCapsule, "=");
    case ColliderShape::Mesh:
      break;
  }
  return icons::icon(icons::kMesh, "[]");
}

// Groups of rows that no point's id can be.
constexpr Id kTrees = 0xfffffff1u, kObstacles = 0xfffffff2u, kProbes = 0xfffffff3u, kSpecies = 0xfffffff4u,
             kColliders = 0xfffffff5u, kSurfaces = 0xfffffff6u, kRotors = 0xfffffff7u;

/// Roots in the order of the list of points: that is what dragging changes.
std::vector<Id> rootsInOrder(const WindGraph& graph) {
  const std::vector<Id> sorted = findRoots(graph);
  std::vector<Id> roots;
  for (const Point& point : graph.points)
    if (std::ranges::binary_search(sorted, point.id)) roots.push_back(point.id);
  return roots;
}

}  // namespace

template <class Thing>
Outliner::Row Outliner::itemRow(const Thing& thing, const char* kind, const char* symbol) {
  Row row{.kind = Row::Kind::Item,
          .id = thing.id,
          .depth = 0,
          .symbol = symbol,
          .label = named(thing.name, kind, thing.id),
          .name = thing.name,
          .hidden = thing.hidden,
          .canMute = requires {thing.muted;
}
, .canLock = requires {
  thing.locked;
}
, .members = { thing.id }
};  // namespace windloom::editor
if constexpr (requires { thing.muted; }) row.muted = thing.muted;
if constexpr (requires { thing.locked; }) row.locked = thing.locked;
return row;
}

bool Outliner::takeChanges(const Project& project) {
  if (project.graph == m_graph && project.obstacles == m_obstacles && project.species == m_species &&
      project.colliders == m_colliders && project.surfaces == m_surfaces && project.rotors == m_rotors &&
      project.probes == m_probes)
    return false;
  m_graph = project.graph;
  m_obstacles = project.obstacles;
  m_species = project.species;
  m_colliders = project.colliders;
  m_surfaces = project.surfaces;
  m_rotors = project.rotors;
  m_probes = project.probes;
  return true;
}

void Outliner::addTrees(const Project& project) {
  const WindGraph& graph = *project.graph;
  const auto from = leaving(graph);
  std::unordered_map<Id, const Point*> points;
  for (const Point& point : graph.points) points[point.id] = &point;
  std::vector<bool> listed(graph.arrows.size(), false);

  for (const Id root : rootsInOrder(graph)) {
    const std::size_t head = m_rows.size();
    m_rows.push_back({.kind = Row::Kind::Tree,
                      .id = root,
                      .tree = root,
                      .group = kTrees,
                      .symbol = icons::icon(icons::kDraw, "T"),
                      .label = named(points[root]->name, "Tree", root),
                      .name = points[root]->name});
    Row tree = m_rows.back();
    tree.hidden = tree.muted = tree.locked = true;
    // Depth first, each arrow once: where flows merge it stands under the branch that comes first.
    std::vector<std::pair<std::size_t, int>> open;
    const auto openFrom = [&](Id point, int depth) {
      const auto found = from.find(point);
      if (found == from.end()) return;
      for (auto i = found->second.rbegin(); i != found->second.rend(); ++i) open.emplace_back(*i, depth);
    };
    openFrom(root, 1);
    while (!open.empty()) {
      const auto [index, depth] = open.back();
      open.pop_back();
      if (listed[index]) continue;
      listed[index] = true;
      const Arrow& arrow = graph.arrows[index];
      tree.members.push_back(arrow.id);
      tree.hidden = tree.hidden && arrow.hidden;
      tree.muted = tree.muted && arrow.muted;
      tree.locked = tree.locked && arrow.locked;
      // Only branching indents: a long chain stays readable.
      openFrom(arrow.to, from.at(arrow.from).size() > 1 ? depth + 1 : depth);
      if (m_closed.contains(root)) continue;
      Row row = itemRow(arrow, "Arrow", icons::icon(icons::kArrow, "->"));
      row.depth = depth;
      row.tree = root;
      row.group = arrow.from;
      m_rows.push_back(std::move(row));
    }
    m_rows[head] = std::move(tree);
  }
}

template <class Thing, class SymbolOf>
void Outliner::addGroup(const std::vector<Thing>& things, const char* heading, const char* kind, Id group,
                        SymbolOf&& symbol) {
  if (!things.empty()) m_rows.push_back({.kind = Row::Kind::Heading, .label = heading});
  for (const Thing& thing : things) {
    m_rows.push_back(itemRow(thing, kind, symbol(thing)));
    m_rows.back().group = group;
  }
}

void Outliner::rebuild(const Project& project) {
  m_rows.clear();
  m_rows.push_back({.kind = Row::Kind::Heading, .label = "Wind trees"});
  addTrees(project);
  const auto byShape = [](const auto& thing) { return symbolOf(thing.shape); };
  addGroup(*project.obstacles, "Obstacles", "Obstacle", kObstacles, byShape);
  addGroup(*project.species, "Species", "Species", kSpecies, byShape);
  addGroup(*project.colliders, "Colliders", "Collider", kColliders, byShape);
  addGroup(*project.surfaces, "Surfaces", "Surface", kSurfaces,
           [](const Surface&) { return icons::icon(icons::kSurface, "@"); });
  addGroup(*project.rotors, "Rotors", "Rotor", kRotors, [](const Rotor&) { return icons::icon(icons::kRotor, "x"); });
  addGroup(*project.probes, "Probes", "Probe", kProbes, [](const Probe&) { return icons::icon(icons::kProbe, "+"); });
}

void Outliner::click(PanelContext& context, const Row& row) {
  const ImGuiIO& io = ImGui::GetIO();
  const SelectMode mode = io.KeyCtrl ? SelectMode::Toggle : io.KeyShift ? SelectMode::Add : SelectMode::Replace;
  std::vector<Id> ids{row.id};
  if (row.kind == Row::Kind::Tree) ids.insert(ids.end(), row.members.begin(), row.members.end());
  select(context.workspace.selection, ids, mode);
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    m_renaming = row.id;
    m_focusName = true;
  }
}

void Outliner::drawName(PanelContext& context, const Row& row, float width) {
  if (m_renaming == row.id) {
    std::string name = row.name;
    ImGui::SetNextItemWidth(width);
    if (m_focusName) ImGui::SetKeyboardFocusHere();
    if (textField("outliner/rename", name, "name")) {
      context.workspace.apply(renameEdit(context.workspace.document.committed(), row.id, name));
      context.workspace.document.seal();
    }
    if (ImGui::IsItemActive()) m_focusName = false;
    if (!m_focusName && !ImGui::IsItemActive()) m_renaming = 0;
    return;
  }
  const std::string label = std::string(row.symbol) + "  " + row.label;
  const bool selected = context.workspace.selection.contains(row.id);
  const bool dimmed = row.hidden || row.muted;
  ImGui::PushStyleColor(ImGuiCol_Text, dimmed ? look().palette.muted : look().palette.text);
  if (ImGui::Selectable(label.c_str(), selected, ImGuiSelectableFlags_AllowDoubleClick, {width, 0}) && !m_drag &&
      !m_dragOver)
    click(context, row);
  if (!m_drag && !m_dragOver && ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, scaled(5)))
    beginDrag(context, row);
  ImGui::PopStyleColor();
  markItem("outliner/" + std::to_string(row.id));
}

void Outliner::drawFlags(PanelContext& context, const Row& row) {
  using namespace icons;
  struct Entry {
    Flag flag;
    bool on;
    const char *symbolOn, *symbolOff, *textOn, *textOff, *help;
  };
  const Entry entries[] = {
      {Flag::Hidden, row.hidden, kEyeOff, kEye, "-", "v", "Show or hide"},
      {Flag::Muted, row.muted, kSpeakerOff, kSpeaker, "-", "m",
       "Mute: it blows no wind, stops none and bends no grass"},
      {Flag::Locked, row.locked, kLock, kUnlock, "L", "u", "Lock: it can't be picked in the view"},
  };
  const float side = ImGui::GetFrameHeight();
  for (const Entry& entry : entries) {
    ImGui::SameLine(0, 0);
    if ((entry.flag == Flag::Muted && !row.canMute) || (entry.flag == Flag::Locked && !row.canLock)) {
      ImGui::Dummy({side, 1});
      continue;
    }
    ImGui::PushID(int(entry.flag));
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, entry.on ? look().palette.accent : look().palette.muted);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (ImGui::Button(entry.on ? icon(entry.symbolOn, entry.textOn) : icon(entry.symbolOff, entry.textOff),
                      {side, ImGui::GetTextLineHeight()})) {
      context.workspace.apply(flagEdit(context.workspace.document.committed(), row.members, entry.flag, !entry.on));
      context.workspace.document.seal();
    }
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", entry.help);
    ImGui::PopID();
  }
}

void Outliner::drawRow(PanelContext& context, const Row& row) {
  if (row.kind == Row::Kind::Heading) {
    ImGui::PushFont(look().strong);
    ImGui::TextDisabled("%s", row.label.c_str());
    ImGui::PopFont();
    return;
  }
  ImGui::PushID(int(row.id));
  const float arrowWidth = scaled(16);
  // Deep trees stay within the panel: indentation stops where names would have no room.
  const float indent = scaled(10) * float(std::min(row.depth, 8));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  if (row.kind == Row::Kind::Tree) {
    const bool closed = m_closed.contains(row.id);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0, 0));
    if (ImGui::ArrowButtonEx("##fold", closed ? ImGuiDir_Right : ImGuiDir_Down,
                             {arrowWidth, ImGui::GetTextLineHeight()})) {
      if (closed)
        m_closed.erase(row.id);
      else
        m_closed.insert(row.id);
      m_graph = nullptr;  // rows are made again
    }
    ImGui::PopStyleVar();
  } else {
    ImGui::Dummy({arrowWidth, 1});
  }
  ImGui::SameLine(0, scaled(4));
  const float width = ImGui::GetContentRegionAvail().x - ImGui::GetFrameHeight() * 3;
  drawName(context, row, std::max(width, scaled(24)));
  drawFlags(context, row);
  ImGui::PopID();
}

bool Outliner::rename(const Project& project, Id id) {
  const Arrow* arrow = findArrow(*project.graph, id);
  const bool root = std::ranges::binary_search(findRoots(*project.graph), id);
  if (!arrow && !root && findPoint(*project.graph, id)) return false;
  m_renaming = m_show = id;
  m_focusName = true;
  if (arrow) m_closed.clear();
  m_graph = nullptr;  // rows are made again, with its tree open
  return true;
}

bool Outliner::cancelDrag() {
  m_dragOver = m_drag.has_value();
  m_drag.reset();
  return m_dragOver;
}

/// With a selected row go the selected ones of its group.
void Outliner::beginDrag(const PanelContext& context, const Row& row) {
  m_drag = RowDrag{row.group, {}};
  const Selection& selection = context.workspace.selection;
  for (const Row& other : m_rows) {
    const bool along = selection.contains(row.id) && selection.contains(other.id) && other.group == row.group;
    if (other.kind != Row::Kind::Heading && (other.id == row.id || along)) m_drag->ids.push_back(other.id);
  }
}

/// A line where the rows would come to stand; the drop is one edit.
void Outliner::followDrag(PanelContext& context, float top, float rowHeight) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const float edge = rowHeight, speed = 12 * rowHeight * io.DeltaTime;
  if (io.MousePos.y < low.y + edge) ImGui::SetScrollY(ImGui::GetScrollY() - speed);
  if (io.MousePos.y > low.y + size.y - edge) ImGui::SetScrollY(ImGui::GetScrollY() + speed);
  float nearest = FLT_MAX, line = 0;
  Id before = 0;
  const auto consider = [&](std::size_t row, Id id) {
    const float y = top + float(row) * rowHeight;
    if (std::abs(y - io.MousePos.y) >= nearest) return;
    nearest = std::abs(y - io.MousePos.y);
    line = y;
    before = id;
  };
  std::size_t end = 0;  // behind the last row of the group and what stands under it
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const Row& row = m_rows[i];
    const bool ours = row.kind != Row::Kind::Heading && row.group == m_drag->group;
    if (ours) consider(i, row.id);
    if (ours || (end == i && end > 0 && m_drag->group == kTrees && row.tree != 0)) end = i + 1;
  }
  consider(end, 0);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({low.x + scaled(4), line}, {low.x + size.x - scaled(4), line}, packed(look().palette.accent), scaled(2));
  ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) {
    if (!io.MouseDown[0]) m_drag.reset();
    return;
  }
  context.workspace.apply(reorderEdit(context.workspace.document.committed(), m_drag->ids, before));
  context.workspace.document.seal();
  m_drag.reset();
}

/// Scrolls to a row that was asked for.
void Outliner::showRow(const Project& project) {
  if (m_show == 0 || !kindOf(project, m_show)) return;
  const auto row = std::ranges::find(m_rows, m_show, &Row::id);
  const float y = float(row - m_rows.begin()) * ImGui::GetTextLineHeightWithSpacing();
  const float high = ImGui::GetWindowHeight();
  if (row != m_rows.end() && (y < ImGui::GetScrollY() || y > ImGui::GetScrollY() + high - 2 * ImGui::GetFrameHeight()))
    ImGui::SetScrollY(std::max(0.0f, y - 0.5f * high));
  m_show = 0;
}

void Outliner::draw(PanelContext& context) {
  if (takeChanges(context.project())) rebuild(context.project());
  ImGui::BeginChild("outliner");
  showRow(context.project());
  const float top = ImGui::GetCursorScreenPos().y;
  ImGuiListClipper clipper;
  clipper.Begin(int(m_rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawRow(context, m_rows[std::size_t(i)]);
  // The button is still held after a cancel: that is no new drag.
  m_dragOver = m_dragOver && ImGui::GetIO().MouseDown[0];
  if (m_drag) followDrag(context, top, clipper.ItemsHeight);
  if (m_rows.size() <= 1) ImGui::TextDisabled("None yet: press D and draw one.");
  ImGui::EndChild();
}

}  // namespace windloom::editor
