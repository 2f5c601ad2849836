#pragma once
// The list of all keys and gestures, made from the action table: the help window shows it, docs/keys.md is written
// from it.

#include <string>
#include <vector>

#include "editor/core/actions.hpp"

namespace windloom::editor {

struct HelpRow {
  std::string what, keys;
  std::string help;  ///< one sentence more; may be empty
};
struct HelpSection {
  std::string title;
  std::vector<HelpRow> rows;
};

/// What the mouse does, then the actions that have a shortcut, by category.
std::vector<HelpSection> helpPage(const ActionTable& actions);
/// The page as a Markdown document.
std::string helpMarkdown(const std::vector<HelpSection>& page);

}  // namespace windloom::editor
