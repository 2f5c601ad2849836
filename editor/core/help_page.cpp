#include "editor/core/help_page.hpp"

#include <algorithm>

namespace windloom::editor {
namespace {

/// What the mouse does isn't an action; see Navigator and the tools.
HelpSection mouse() {
  return {
      "Mouse",
      {{"Orbit", "Middle button, or Alt + left", ""},
       {"Pan", "Shift + middle, or Alt + middle", ""},
       {"Zoom to the cursor", "Wheel, or Alt + right", ""},
       {"Fly", "Right button + W A S D Q E", "The wheel changes the speed, Shift is fast."},
       {"Box select", "Left on empty ground, drag", "Shift adds, Ctrl toggles."},
       {"Select the next thing that overlaps there", "Click again at the same place", ""},
       {"Insert a point", "Ctrl + click on an arrow", ""},
       {"Draw a tree", "D, then press, drag, release; or click, click, click",
        "Begins and ends on points nearby; Enter or right click ends, the wheel changes the radius, Shift+wheel the "
        "strength."},
       {"Draw an obstacle", "O, then drag", "C changes between circle and box."},
       {"Draw a polygon", "O, then click, click, click",
        "Enter, right click or the first corner closes; Backspace takes a corner back, Esc drops it."},
       {"Change a polygon", "Drag a corner, Ctrl + click on a side, Del on a corner", ""},
       {"Move, turn, scale", "Drag the arms, the ring or the ends of the gizmo", "An arm locks its axis."},
       {"Comb the wind", "B, then drag", "It fades, and is no part of the project."},
       {"Copy", "Alt + drag", ""},
       {"Lock the axis while dragging", "X, Z", "Type a number and Enter for an exact distance, angle or factor."},
       {"Cancel a drag", "Esc or right button", ""},
       {"Change the order", "Drag a row of the outliner", ""},
       {"Change a number", "Drag it", "Ctrl fine, Shift coarse, click to type, right click resets."}}};
}

}  // namespace

std::vector<HelpSection> helpPage(const ActionTable& actions) {
  std::vector<HelpSection> page{mouse()};
  for (const Action& action : actions.all()) {
    if (action.shortcuts.empty()) continue;
    auto section = std::ranges::find(page, action.category, &HelpSection::title);
    if (section == page.end()) section = page.insert(page.end(), {action.category, {}});
    std::string keys;
    for (const Shortcut& shortcut : action.shortcuts) keys += (keys.empty() ? "" : ", ") + toText(shortcut);
    section->rows.push_back({action.label, keys, action.help});
  }
  return page;
}

std::string helpMarkdown(const std::vector<HelpSection>& page) {
  const auto cell = [](std::string text) {
    // A bar would end the cell.
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
    return text;
  };
  std::string text =
      "# Keys and gestures\n\nWritten by `windloom-editor --keys docs/keys.md` from the table of actions; **F1** shows "
      "the "
      "same in the editor.\n";
  for (const HelpSection& section : page) {
    text += "\n## " + section.title + "\n| what | keys | |\n|---|---|---|\n";
    for (const HelpRow& row : section.rows)
      text += "| " + cell(row.what) + " | " + cell(row.keys) + " | " + cell(row.help) + " |\n";
  }
  return text;
}

}  // namespace windloom::editor
