#pragma once
// Everything in the project by name: wind trees with their arrows, obstacles, species, colliders, surfaces, rotors,
// probes. Eye shows and hides, speaker mutes, lock keeps from picking; double click or F2 renames; dragging changes the
// order of trees, of arrows that leave the same point, and of the things in every other list.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

class Outliner {
 public:
  void draw(PanelContext& context);
  /// Opens the name of a row for typing. False: there is no row for this id.
  bool rename(const Project& project, Id id);
  /// Esc, focus loss. True where a row was being dragged.
  bool cancelDrag();

 private:
  struct Row {
    enum class Kind { Heading, Tree, Item };
    Kind kind = Kind::Heading;
    Id id = 0;
    Id tree = 0;   ///< the root whose tree it stands under
    Id group = 0;  ///< rows change places only within their group: kOrder..., or for arrows the point they leave
    int depth = 0;
    const char* symbol = "";
    std::string label = {}, name = {};
    bool hidden = false, muted = false, locked = false, canMute = true, canLock = true;
    std::vector<Id> members = {};  ///< what the flags act on; Tree: its arrows
  };
  bool takeChanges(const Project& project);
  void rebuild(const Project& project);
  /// A row for an arrow or a thing of another list.
  template <class Thing>
  static Row itemRow(const Thing& thing, const char* kind, const char* symbol);
  void addTrees(const Project& project);
  /// All of a list under a heading; `symbol` gives a thing's icon.
  template <class Thing, class SymbolOf>
  void addGroup(const std::vector<Thing>& things, const char* heading, const char* kind, Id group, SymbolOf&& symbol);
  void drawRow(PanelContext& context, const Row& row);
  void drawName(PanelContext& context, const Row& row, float width);
  void drawFlags(PanelContext& context, const Row& row);
  void click(PanelContext& context, const Row& row);
  void beginDrag(const PanelContext& context, const Row& row);
  void followDrag(PanelContext& context, float top, float rowHeight);
  void showRow(const Project& project);

  /// Rows on their way to another place.
  struct RowDrag {
    Id group = 0;
    std::vector<Id> ids;
  };
  std::optional<RowDrag> m_drag;
  bool m_dragOver = false;  // cancelled, with the button still held
  std::vector<Row> m_rows;
  std::set<Id> m_closed;  // trees shown without their arrows
  Shared<WindGraph> m_graph;
  Shared<std::vector<Obstacle>> m_obstacles;
  Shared<std::vector<Species>> m_species;
  Shared<std::vector<Collider>> m_colliders;
  Shared<std::vector<Surface>> m_surfaces;
  Shared<std::vector<Rotor>> m_rotors;
  Shared<std::vector<Probe>> m_probes;
  Id m_renaming = 0;
  bool m_focusName = false;
  Id m_show = 0;  // a row to scroll to
};

}  // namespace windloom::editor
