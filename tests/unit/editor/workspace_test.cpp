#include "editor/core/workspace.hpp"

#include "editor/core/graph_edits.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {

TEST(Workspace, DefaultShortcutsAreThoseOfTheKeyTable) {
  Bench b;
  const std::pair<const char*, const char*> table[] = {{"view.frame", "F"},
                                                       {"view.frame_all", "Shift+F"},
                                                       {"view.frame_all", "Home"},
                                                       {"view.top", "Numpad 7"},
                                                       {"view.front", "Numpad 1"},
                                                       {"view.side", "Numpad 3"},
                                                       {"view.orthographic", "Numpad 5"},
                                                       {"tool.select", "Q"},
                                                       {"tool.move", "W"},
                                                       {"tool.rotate", "E"},
                                                       {"tool.scale", "R"},
                                                       {"select.all", "A"},
                                                       {"select.none", "Alt+A"},
                                                       {"select.none", "Esc"},
                                                       {"tool.draw", "D"},
                                                       {"graph.extrude", "Shift+E"},
                                                       {"graph.merge", "Ctrl+J"},
                                                       {"graph.split", "Y"},
                                                       {"graph.reverse", "Ctrl+R"},
                                                       {"graph.reparent", "Ctrl+P"},
                                                       {"tool.obstacle", "O"},
                                                       {"tool.vortex", "V"},
                                                       {"tool.probe", "P"},
                                                       {"tool.brush", "B"},
                                                       {"graph.strength_up", "Shift+]"},
                                                       {"graph.strength_down", "Shift+["},
                                                       {"graph.radius_up", "]"},
                                                       {"graph.radius_down", "["},
                                                       {"edit.duplicate", "Ctrl+D"},
                                                       {"edit.duplicate_move", "Shift+D"},
                                                       {"edit.delete", "Del"},
                                                       {"edit.delete", "X"},
                                                       {"edit.copy", "Ctrl+C"},
                                                       {"edit.paste", "Ctrl+V"},
                                                       {"edit.undo", "Ctrl+Z"},
                                                       {"edit.redo", "Ctrl+Shift+Z"},
                                                       {"edit.redo", "Ctrl+Y"},
                                                       {"graph.mute", "M"},
                                                       {"graph.hide", "H"},
                                                       {"graph.show_all", "Alt+H"},
                                                       {"graph.isolate", "Numpad /"},
                                                       {"file.new", "Ctrl+N"},
                                                       {"file.open", "Ctrl+O"},
                                                       {"file.save", "Ctrl+S"},
                                                       {"file.save_as", "Ctrl+Shift+S"}};
  for (const auto& [id, text] : table) {
    const Action* action = b.w.actions.find(id);
    ASSERT_TRUE(action) << id;
    const auto& own = action->shortcuts;
    EXPECT_NE(std::find(own.begin(), own.end(), *parseShortcut(text)), own.end()) << id << " " << text;
  }
  EXPECT_TRUE(b.w.actions.conflicts().empty());
}

TEST(Workspace, EveryToolHasAnActionThatShowsItIsOn) {
  Bench b;
  for (const auto& tool : b.w.tools.tools()) {
    const std::string id = "tool." + tool->id();
    EXPECT_TRUE(b.w.actions.run(id)) << id;
    EXPECT_TRUE(b.w.actions.checked(id)) << id;
    EXPECT_EQ(b.w.tools.active().id(), tool->id());
    EXPECT_FALSE(b.w.tools.hint(b.w.context()).empty());
  }
}

TEST(Workspace, UndoRepairsTheSelection) {
  Bench b;
  const Id arrow = b.draw({-20, 0}, {0, 0});
  EXPECT_TRUE(b.w.selection.contains(arrow));
  b.key("Ctrl+Z");
  EXPECT_TRUE(b.w.selection.empty());
  EXPECT_FALSE(b.w.document.dirty());
  EXPECT_FALSE(b.key("Ctrl+Z"));  // nothing left to undo
  b.key("Ctrl+Y");
  EXPECT_EQ(b.graph().arrows.size(), 1u);
}

TEST(Workspace, EveryEditOfASessionCanBeUndoneAndRedone) {
  Bench b;
  b.draw({-30, 0}, {-10, 0});
  b.draw({-10, 0}, {10, 10});
  b.draw({-10, 0}, {10, -10});
  b.key("]");
  b.key("Shift+]");
  b.w.document.seal();
  b.key("M");
  b.key("Ctrl+D");
  b.key("Ctrl+R");
  b.key("O");
  b.drag({30, 30}, {34, 30});
  b.key("P");
  b.click({0, 30});
  b.key("Q");
  b.drag({0, 30}, {5, 35});
  b.key("A");
  b.key("Del");
  std::vector<Project> states;
  for (const auto& entry : b.w.document.history().entries()) states.push_back(entry.project);
  ASSERT_EQ(states.size(), 13u);
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    ASSERT_TRUE(b.key("Ctrl+Z"));
    EXPECT_TRUE(b.project().sameAs(states[i])) << i;
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    ASSERT_TRUE(b.key("Ctrl+Shift+Z"));
    EXPECT_TRUE(b.project().sameAs(states[i])) << i;
  }
  b.w.jumpTo(2);
  EXPECT_TRUE(b.project().sameAs(states[2]));
}

TEST(Workspace, UndoDuringADragCancelsItFirst) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  const Project before = b.project();
  b.press({5, 5});
  b.move({10, 10});
  EXPECT_TRUE(b.w.tools.dragging());
  EXPECT_TRUE(b.key("Ctrl+Z"));  // belongs to the drag
  b.w.focusLost();
  EXPECT_TRUE(b.project().sameAs(before));
}

TEST(Workspace, ExtrudeGoesFromTheSelectionToThePointer) {
  Bench b;
  const Id arrow = b.draw({-20, 0}, {0, 0});
  b.hover({10, 10});
  b.key("Shift+E");
  ASSERT_EQ(b.graph().arrows.size(), 2u);
  EXPECT_EQ(b.graph().arrows[1].from, b.arrow(arrow).to);
  expectNear(b.place(b.graph().arrows[1].to), {10, 10});
  b.hover({20, 10});
  b.key("Shift+E");
  ASSERT_EQ(b.graph().arrows.size(), 3u);
  EXPECT_EQ(b.graph().arrows[2].from, b.graph().arrows[1].to);
}

TEST(Workspace, MergeKeyJoinsSelectedPoints) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  const Id second = b.draw({-20, 10}, {0, 10});
  b.w.selection.replace({b.arrow(first).to, b.arrow(second).to});
  b.key("Ctrl+J");
  EXPECT_EQ(b.graph().points.size(), 3u);
  EXPECT_EQ(b.arrow(first).to, b.arrow(second).to);
  expectNear(b.place(b.arrow(first).to), {0, 5});
  b.key("Ctrl+J");
  EXPECT_NE(b.w.message().text.find("two points"), std::string::npos);
}

TEST(Workspace, RadiusAndStrengthKeysMergeWhileHeld) {
  Bench b;
  const Id arrow = b.draw({-20, 0}, {0, 0});
  const std::size_t before = b.steps();
  for (int i = 0; i < 3; ++i) b.w.keyPressed({Key::BracketRight, {}, i > 0});
  EXPECT_NEAR(b.arrow(arrow).radius, 4.0f * 1.331f, 1e-3f);
  EXPECT_EQ(b.steps(), before + 1);
  b.key("Shift+[");
  EXPECT_NEAR(b.arrow(arrow).strength, 8.0f / 1.1f, 1e-4f);
  EXPECT_EQ(b.steps(), before + 2);
}

TEST(Workspace, MuteHideAndIsolateToggle) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  const Id second = b.draw({-20, 10}, {0, 10});
  b.w.selection.replace(first);
  b.key("M");
  EXPECT_TRUE(b.arrow(first).muted);
  b.key("M");
  EXPECT_FALSE(b.arrow(first).muted);
  b.key("Numpad /");
  EXPECT_TRUE(b.arrow(second).hidden);
  b.key("Numpad /");
  EXPECT_FALSE(b.arrow(second).hidden);
  b.key("H");
  EXPECT_TRUE(b.arrow(first).hidden);
  EXPECT_TRUE(b.w.selection.empty());
  b.key("Alt+H");
  EXPECT_FALSE(b.arrow(first).hidden);
}

TEST(Workspace, CopyAndPasteGoThroughText) {
  std::string clipboard;
  Bench from, to;
  for (Bench* b : {&from, &to}) {
    b->w.writeClipboard = [&](const std::string& text) { clipboard = text; };
    b->w.readClipboard = [&] { return clipboard; };
  }
  from.draw({-20, 0}, {0, 0});
  from.key("A");
  from.key("Ctrl+C");
  EXPECT_NE(clipboard.find("windloom-project"), std::string::npos);
  to.draw({30, 30}, {35, 30});
  to.hover({5, -20});
  to.key("Ctrl+V");
  ASSERT_EQ(to.graph().arrows.size(), 2u);
  const Arrow& pasted = to.graph().arrows[1];
  expectNear(to.place(pasted.from), {-5, -20});
  expectNear(to.place(pasted.to), {15, -20});
  EXPECT_TRUE(to.w.selection.contains(pasted.id));
  EXPECT_EQ(to.w.selection.size(), 3u);
}

TEST(Workspace, PasteOfOtherTextIsRefused) {
  Bench b;
  for (const char* text : {"", "hello", "{\"format\": \"windloom-project\", \"version\": 1, \"graph\": 5}"}) {
    b.w.readClipboard = [text] { return std::string(text); };
    const auto number = b.w.messageNumber();
    b.key("Ctrl+V");
    EXPECT_FALSE(b.w.document.dirty());
    EXPECT_GT(b.w.messageNumber(), number);
    EXPECT_NE(b.w.message().text.find("Can't paste"), std::string::npos);
  }
}

TEST(Workspace, CutTakesAwayAndPasteBringsBack) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.key("Ctrl+X");
  EXPECT_TRUE(b.graph().arrows.empty());
  b.hover({-10, 0});
  b.key("Ctrl+V");
  ASSERT_EQ(b.graph().arrows.size(), 1u);
  expectNear(b.place(b.graph().arrows[0].from), {-20, 0});
}

TEST(Workspace, DuplicateAndMoveFollowsThePointerUntilAClick) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  b.key("Q");
  b.hover({0, -20});
  b.key("Shift+D");
  EXPECT_TRUE(b.w.tools.dragging());
  b.move({0, -10});
  b.press({0, -10});
  b.release({0, -10});
  EXPECT_FALSE(b.w.tools.dragging());
  ASSERT_EQ(b.graph().arrows.size(), 2u);
  expectNear(b.place(b.graph().arrows[1].from), {-20, 10});
  EXPECT_NE(b.w.selection.active(), first);
  b.hover({0, -20});
  b.key("Shift+D");
  b.move({0, 5});
  b.key("Esc");
  EXPECT_EQ(b.graph().arrows.size(), 2u);
}

TEST(Workspace, SelectAllNoneInvertAndTree) {
  Bench b;
  const Id first = b.draw({-20, 0}, {0, 0});
  b.draw({-20, 10}, {0, 10});
  b.key("A");
  EXPECT_EQ(b.w.selection.size(), 6u);
  b.key("Esc");
  EXPECT_TRUE(b.w.selection.empty());
  b.w.selection.replace(first);
  b.key("Ctrl+L");
  EXPECT_EQ(b.w.selection.size(), 3u);
  b.key("Ctrl+I");
  EXPECT_EQ(b.w.selection.size(), 3u);
  EXPECT_FALSE(b.w.selection.contains(first));
}

TEST(Workspace, ViewKeysDoNotTouchTheProject) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  const Project before = b.project();
  b.key("Numpad 1");
  EXPECT_FLOAT_EQ(b.w.camera.pitch, 0.0f);
  b.key("Numpad 3");
  EXPECT_FLOAT_EQ(b.w.camera.yaw, 90.0f);
  b.key("Numpad 7");
  EXPECT_FLOAT_EQ(b.w.camera.pitch, 90.0f);
  b.key("Numpad 5");
  EXPECT_FALSE(b.w.camera.orthographic);
  b.key("F");
  EXPECT_NEAR(b.w.camera.target.x, -10.0f, 1e-3f);
  EXPECT_TRUE(b.project().sameAs(before));
}

TEST(Workspace, OpenClearsTheSelectionAndRemembersTheFile) {
  TempFolder folder;
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.key("Ctrl+S");
  EXPECT_EQ(b.w.flow.prompt(), Prompt::ChooseSavePath);
  b.w.flow.answerPath(folder / "tree.wind.json");
  EXPECT_FALSE(b.w.document.dirty());
  EXPECT_EQ(b.w.message().text, "Saved tree.wind.json");
  b.w.flow.requestOpen(folder / "tree.wind.json");
  EXPECT_TRUE(b.w.selection.empty());
  EXPECT_EQ(b.graph().arrows.size(), 1u);
  ASSERT_EQ(b.w.preferences.recentFiles.size(), 1u);
  b.w.flow.requestOpen(folder / "none.wind.json");
  EXPECT_EQ(b.w.message().kind, MessageKind::Error);
  EXPECT_EQ(b.graph().arrows.size(), 1u);
}

TEST(Workspace, AltPressOrbitsWhereTheToolHasNoUseForIt) {
  Bench b;
  b.draw({-20, 0}, {0, 0});
  b.drag({0, 0}, {10, 10}, kAlt);  // the draw tool, on a handle
  EXPECT_EQ(b.graph().arrows.size(), 1u);
  EXPECT_NE(b.w.camera.yaw, 0.0f);
}

TEST(Workspace, RefusedPanelEditIsTold) {
  Bench b;
  EXPECT_FALSE(b.w.apply(treeEdit(b.project(), {0, 0}, {0, 0}, Arrow{}).edit));
  EXPECT_EQ(b.w.message().kind, MessageKind::Warning);
  EXPECT_EQ(b.w.message().text.find("The arrow has no length"), 0u) << b.w.message().text;
}

}  // namespace windloom::editor
