#include "editor/panels/outliner.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <unordered_map>

#include "editor/core/graph_edits.hpp"
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

}  // namespace

template <class Thing>
Outliner::Row Outliner::itemRow(const Thing& thing, const char* kind, const char* symbol) {
  return {.kind = Row::Kind::Item,
          .id = thing.id,
          .depth = 0,
          .symbol = symbol,
          .label = named(thing.name, kind, thing.id),
          .name = thing.name,
          .hidden = thing.hidden,
          .locked = thing.locked,
          .members = {thing.id}};
}

bool Outliner::takeChanges(const Project& project) {
  if (project.graph == m_graph && project.obstacles == m_obstacles && project.probes == m_probes) return false;
  m_graph = project.graph;
  m_obstacles = project.obstacles;
  m_probes = project.probes;
  return true;
}

void Outliner::addTrees(const Project& project) {
  const WindGraph& graph = *project.graph;
  const auto from = leaving(graph);
  std::unordered_map<Id, const Point*> points;
  for (const Point& point : graph.points) points[point.id] = &point;
  std::vector<bool> listed(graph.arrows.size(), false);

  for (const Id root : findRoots(graph)) {
    const std::size_t head = m_rows.size();
    m_rows.push_back({.kind = Row::Kind::Tree,
                      .id = root,
                      .symbol = icons::icon(icons::kDraw, "T"),
                      .label = named(points[root]->name, "Tree", root),
                      .name = points[root]->name});
    Row tree = m_rows.back();
    tree.hidden = tree.muted = tree.locked = true;
    // Depth first, each arrow once: where flows merge it stands under the branch that comes first.
    std::vector<std::pair<Id, int>> open{{root, 1}};
    while (!open.empty()) {
      const auto [point, depth] = open.back();
      open.pop_back();
      const auto found = from.find(point);
      if (found == from.end()) continue;
      // Only branching indents: a long chain stays readable.
      const int below = found->second.size() > 1 ? depth + 1 : depth;
      for (const std::size_t index : found->second) {
        if (listed[index]) continue;
        listed[index] = true;
        const Arrow& arrow = graph.arrows[index];
        tree.members.push_back(arrow.id);
        tree.hidden = tree.hidden && arrow.hidden;
        tree.muted = tree.muted && arrow.muted;
        tree.locked = tree.locked && arrow.locked;
        open.emplace_back(arrow.to, below);
        if (m_closed.contains(root)) continue;
        Row row = itemRow(arrow, "Arrow", icons::icon(icons::kArrow, "->"));
        row.depth = depth;
        row.muted = arrow.muted;
        m_rows.push_back(std::move(row));
      }
    }
    m_rows[head] = std::move(tree);
  }
}

void Outliner::rebuild(const Project& project) {
  m_rows.clear();
  const auto heading = [&](const char* label) { m_rows.push_back({.kind = Row::Kind::Heading, .label = label}); };
  heading("Wind trees");
  addTrees(project);
  if (!project.obstacles->empty()) heading("Obstacles");
  for (const Obstacle& o : *project.obstacles) {
    Row row = itemRow(o, "Obstacle", icons::icon(icons::kObstacle, "o"));
    row.muted = o.muted;
    m_rows.push_back(std::move(row));
  }
  if (!project.probes->empty()) heading("Probes");
  for (const Probe& p : *project.probes) {
    Row row = itemRow(p, "Probe", icons::icon(icons::kProbe, "+"));
    row.canMute = false;
    m_rows.push_back(std::move(row));
  }
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
  if (ImGui::Selectable(label.c_str(), selected, ImGuiSelectableFlags_AllowDoubleClick, {width, 0}))
    click(context, row);
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
      {Flag::Muted, row.muted, kSpeakerOff, kSpeaker, "-", "m", "Mute: it blows no wind and stops none"},
      {Flag::Locked, row.locked, kLock, kUnlock, "L", "u", "Lock: it can't be picked in the view"},
  };
  const float side = ImGui::GetFrameHeight();
  for (const Entry& entry : entries) {
    ImGui::SameLine(0, 0);
    if (entry.flag == Flag::Muted && !row.canMute) {
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

void Outliner::draw(PanelContext& context) {
  if (takeChanges(context.project())) rebuild(context.project());
  ImGui::BeginChild("outliner");
  ImGuiListClipper clipper;
  clipper.Begin(int(m_rows.size()));
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) drawRow(context, m_rows[std::size_t(i)]);
  if (m_rows.size() <= 1) ImGui::TextDisabled("None yet: press D and draw one.");
  ImGui::EndChild();
}

}  // namespace windloom::editor
