#include "editor/core/actions.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windloom::editor {
namespace {

Shortcut key(const char* text) {
  return parseShortcut(text).value();
}

struct Table {
  ActionTable actions;
  std::vector<std::string> ran;
  bool allowed = true;
  Table() {
    add("edit.undo", "Undo", {key("Ctrl+Z")}, true);
    add("edit.redo", "Redo", {key("Ctrl+Shift+Z"), key("Ctrl+Y")}, true);
    add("tool.draw", "Draw tree", {key("D")}, false);
    Action guarded{
        .id = "edit.delete", .label = "Delete", .category = "Edit", .help = "Deletes", .shortcuts = {key("X")}};
    guarded.run = [this] { ran.push_back("edit.delete"); };
    guarded.enabled = [this] { return allowed; };
    actions.add(std::move(guarded));
  }
  void add(std::string id, const char* label, std::vector<Shortcut> shortcuts, bool repeats) {
    Action action{.id = id, .label = label, .category = "Edit", .help = ""};
    action.shortcuts = std::move(shortcuts);
    action.run = [this, id] { ran.push_back(id); };
    action.repeats = repeats;
    actions.add(std::move(action));
  }
};

}  // namespace

TEST(Shortcut, TextReadsBackForEveryKey) {
  for (int i = 1; i < static_cast<int>(Key::Count); ++i) {
    for (int bits = 0; bits < 8; ++bits) {
      const Shortcut shortcut{static_cast<Key>(i), {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0}};
      const std::string text = toText(shortcut);
      EXPECT_FALSE(text.empty());
      EXPECT_EQ(parseShortcut(text), shortcut) << text;
    }
  }
}

TEST(Shortcut, ParsesWhatPeopleWrite) {
  EXPECT_EQ(parseShortcut(" shift + ctrl+ z "), (Shortcut{Key::Z, {true, true, false}}));
  EXPECT_EQ(toText(*parseShortcut("control+ALT+delete")), "Ctrl+Alt+Del");
  EXPECT_EQ(toText(*parseShortcut("numpad 7")), "Numpad 7");
  EXPECT_EQ(parseShortcut("escape"), parseShortcut("Esc"));
  for (const char* bad : {"", "Ctrl+", "Ctrl", "Ctrl+Ctrl+Z", "Hyper+Z", "ZZ", "F13", "+", "Numpad 77"}) {
    EXPECT_FALSE(parseShortcut(bad)) << bad;
  }
}

TEST(ActionTable, DispatchRunsTheExactShortcutOnly) {
  Table t;
  EXPECT_TRUE(t.actions.dispatch({Key::Z, {true, false, false}}));
  EXPECT_TRUE(t.actions.dispatch({Key::Y, {true, false, false}}));
  EXPECT_FALSE(t.actions.dispatch({Key::Z, {}}));
  EXPECT_FALSE(t.actions.dispatch({Key::D, {true, false, false}}));
  EXPECT_EQ(t.ran, (std::vector<std::string>{"edit.undo", "edit.redo"}));
}

TEST(ActionTable, DisabledActionsDoNotRun) {
  Table t;
  t.allowed = false;
  EXPECT_FALSE(t.actions.dispatch({Key::X, {}}));
  EXPECT_FALSE(t.actions.run("edit.delete"));
  EXPECT_FALSE(t.actions.run("no.such"));
  EXPECT_TRUE(t.ran.empty());
}

TEST(ActionTable, HeldKeysRepeatOnlyWhereItMakesSense) {
  Table t;
  EXPECT_TRUE(t.actions.dispatch({Key::Z, {true, false, false}, true}));
  EXPECT_TRUE(t.actions.dispatch({Key::D, {}, true}));
  EXPECT_EQ(t.ran, std::vector<std::string>{"edit.undo"});
}

TEST(ActionTable, TooltipNamesTheShortcut) {
  Table t;
  EXPECT_EQ(t.actions.tooltip("edit.delete"), "Delete (X): Deletes");
  EXPECT_EQ(t.actions.shortcutText("edit.redo"), "Ctrl+Shift+Z");
}

TEST(ActionTable, KeymapReplacesShortcutsAndIsWrittenBack) {
  Table t;
  EXPECT_EQ(t.actions.keymapJson(), "{}");
  ASSERT_TRUE(t.actions.applyKeymap(R"({"tool.draw": "Ctrl+K", "edit.redo": []})"));
  EXPECT_FALSE(t.actions.dispatch({Key::D, {}}));
  EXPECT_FALSE(t.actions.dispatch({Key::Y, {true, false, false}}));
  EXPECT_TRUE(t.actions.dispatch({Key::K, {true, false, false}}));
  Table other;
  ASSERT_TRUE(other.actions.applyKeymap(t.actions.keymapJson()));
  EXPECT_EQ(other.actions.shortcutText("tool.draw"), "Ctrl+K");
  EXPECT_EQ(other.actions.shortcutText("edit.redo"), "");
}

TEST(ActionTable, KeymapReportsWhatIsWrongAndTakesTheRest) {
  Table t;
  const Status status =
      t.actions.applyKeymap(R"({"no.such": "A", "edit.undo": "Foo+Z", "tool.draw": "K", "edit.redo": 5})");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().problems.size(), 3u);
  EXPECT_EQ(t.actions.shortcutText("tool.draw"), "K");
  EXPECT_EQ(t.actions.shortcutText("edit.undo"), "Ctrl+Z");
  EXPECT_FALSE(t.actions.applyKeymap("[1]"));
  EXPECT_FALSE(t.actions.applyKeymap("{"));
}

TEST(ActionTable, ConflictsOfAKeymapAreNamed) {
  Table t;
  EXPECT_TRUE(t.actions.conflicts().empty());
  ASSERT_TRUE(t.actions.applyKeymap(R"({"tool.draw": "X"})"));
  EXPECT_EQ(t.actions.conflicts(), std::vector<std::string>{"X: tool.draw, edit.delete"});
}

TEST(ActionTable, SearchFindsByWordsAndLetters) {
  Table t;
  EXPECT_EQ(t.actions.search("").size(), 4u);
  EXPECT_EQ(t.actions.search("draw").front(), "tool.draw");
  EXPECT_EQ(t.actions.search("tree").front(), "tool.draw");
  EXPECT_EQ(t.actions.search("dt").front(), "tool.draw");
  EXPECT_TRUE(t.actions.search("qqq").empty());
  t.allowed = false;
  EXPECT_TRUE(t.actions.search("delete").empty());
}

}  // namespace windloom::editor
