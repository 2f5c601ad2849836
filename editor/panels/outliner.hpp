#pragma once
// Everything in the project by name: wind trees with their arrows, obstacles, probes. Eye shows and hides, speaker
// mutes, lock keeps from picking; double click renames.

#include <set>
#include <string>
#include <vector>

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

class Outliner {
 public:
  void draw(PanelContext& context);

 private:
  struct Row {
    enum class Kind { Heading, Tree, Item };
    Kind kind = Kind::Heading;
    Id id = 0;
    int depth = 0;
    const char* symbol = "";
    std::string label = {}, name = {};
    bool hidden = false, muted = false, locked = false, canMute = true;
    std::vector<Id> members = {};  ///< what the flags act on; Tree: its arrows
  };
  bool takeChanges(const Project& project);
  void rebuild(const Project& project);
  /// A row for an arrow, obstacle or probe.
  template <class Thing>
  static Row itemRow(const Thing& thing, const char* kind, const char* symbol);
  void addTrees(const Project& project);
  void drawRow(PanelContext& context, const Row& row);
  void drawName(PanelContext& context, const Row& row, float width);
  void drawFlags(PanelContext& context, const Row& row);
  void click(PanelContext& context, const Row& row);

  std::vector<Row> m_rows;
  std::set<Id> m_closed;  // trees shown without their arrows
  Shared<WindGraph> m_graph;
  Shared<std::vector<Obstacle>> m_obstacles;
  Shared<std::vector<Probe>> m_probes;
  Id m_renaming = 0;
  bool m_focusName = false;
};

}  // namespace windloom::editor
