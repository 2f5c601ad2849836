#pragma once
// The one table of actions. It feeds menus, toolbar, keys, command palette and the help page. Core
// actions are added by registerCoreActions; the app adds its own (play, overlays, panels) to the same table.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/core/shortcut.hpp"
#include "engine/core/result.hpp"

namespace windloom::editor {

struct Action {
  std::string id;     ///< "edit.undo": category and verb; unique
  std::string label;  ///< "Undo"
  std::string
      category;  ///< menu and help heading: "File", "Edit", "Select", "Add", "Graph", "Tools", "View", "Play", "Help"
  std::string help;                                ///< one sentence for tooltip and palette; may be empty
  std::vector<Shortcut> shortcuts = {};            ///< the first is shown
  std::function<void()> run = {};                  ///< must be set
  std::function<bool()> enabled = {};              ///< empty: always
  std::function<bool()> checked = {};              ///< set for switches and modes: whether it is on
  std::function<std::string()> dynamicLabel = {};  ///< instead of label where set: "Undo Move point"
  bool repeats = false;                            ///< runs again while the key is held
};

class ActionTable {
 public:
  /// A second action with the same id, or a default shortcut that another action has, is a broken promise.
  void add(Action action);

  [[nodiscard]] const std::vector<Action>& all() const { return m_actions; }
  [[nodiscard]] const Action* find(std::string_view id) const;
  [[nodiscard]] bool enabled(std::string_view id) const;
  [[nodiscard]] bool checked(std::string_view id) const;
  [[nodiscard]] std::string label(std::string_view id) const;  ///< dynamic where it has one
  /// First shortcut as text, "" where there is none; for menus and tooltips.
  [[nodiscard]] std::string shortcutText(std::string_view id) const;
  /// "Draw tree (D): help"
  [[nodiscard]] std::string tooltip(std::string_view id) const;

  /// Runs the action where it is enabled. False: unknown or disabled.
  bool run(std::string_view id);
  /// Runs the enabled action with this shortcut. False: none; the key is free for others. Where several share
  /// a shortcut through a keymap, the first enabled one runs.
  bool dispatch(const KeyPress& press);

  /// Ids of enabled actions whose label, category or id matches the typed text (letters in order, words and
  /// beginnings first), best first. Empty text: all in table order.
  [[nodiscard]] std::vector<std::string> search(std::string_view text) const;

  /// Replaces shortcuts by a keymap: a JSON object of action id to a shortcut or an array of them, [] for
  /// none. What is wrong is reported and skipped; the rest is taken.
  Status applyKeymap(std::string_view json);
  /// The shortcuts that differ from the defaults, as such a JSON object.
  [[nodiscard]] std::string keymapJson() const;
  /// "Ctrl+K: edit.a, edit.b" for each shortcut that two actions have.
  [[nodiscard]] std::vector<std::string> conflicts() const;

 private:
  std::vector<Action> m_actions;
  std::vector<std::vector<Shortcut>> m_defaults;
};

}  // namespace windloom::editor
