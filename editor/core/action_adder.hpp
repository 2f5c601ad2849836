#pragma once
// How the core's files of actions put them into the table. For them only.

#include <functional>
#include <initializer_list>
#include <string>
#include <utility>

#include "editor/core/workspace.hpp"
#include "engine/core/contract.hpp"

namespace windloom::editor {

/// Adds actions of one category to a workspace's table.
class Adder {
 public:
  Adder(Workspace& workspace, std::string category) : w(workspace), m_category(std::move(category)) {}

  void add(Action action, std::initializer_list<const char*> shortcuts) {
    action.category = m_category;
    for (const char* text : shortcuts) {
      const auto shortcut = parseShortcut(text);
      WL_REQUIRE(shortcut.has_value(), "a default shortcut can't be read");
      action.shortcuts.push_back(*shortcut);
    }
    w.actions.add(std::move(action));
  }

  /// An action on what is selected.
  void onSelection(std::string id, std::string label, std::string help, std::initializer_list<const char*> shortcuts,
                   std::function<void(Workspace&)> work, bool repeats = false) {
    Workspace* workspace = &w;
    Action action;
    action.id = std::move(id);
    action.label = std::move(label);
    action.help = std::move(help);
    action.run = [workspace, work = std::move(work)] { work(*workspace); };
    action.enabled = [workspace] { return !workspace->selection.empty(); };
    action.repeats = repeats;
    add(std::move(action), shortcuts);
  }

  void always(std::string id, std::string label, std::string help, std::initializer_list<const char*> shortcuts,
              std::function<void(Workspace&)> work, std::function<bool(Workspace&)> checked = {}) {
    Workspace* workspace = &w;
    Action action;
    action.id = std::move(id);
    action.label = std::move(label);
    action.help = std::move(help);
    action.run = [workspace, work = std::move(work)] { work(*workspace); };
    if (checked) action.checked = [workspace, checked = std::move(checked)] { return checked(*workspace); };
    add(std::move(action), shortcuts);
  }

  Workspace& w;

 private:
  std::string m_category;
};

/// What puts new things into the project: add_actions.cpp.
void addAddActions(Workspace& workspace);

}  // namespace windloom::editor
