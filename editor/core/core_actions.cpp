// The actions that need no window, by menu.
#include <utility>

#include "editor/core/action_adder.hpp"
#include "editor/core/clipboard.hpp"
#include "editor/core/graph_edits.hpp"
#include "editor/core/move_drag.hpp"
#include "editor/core/object_edits.hpp"
#include "editor/core/project_cameras.hpp"
#include "editor/core/workspace.hpp"

namespace windloom::editor {
namespace {

constexpr float kStepFactor = 1.1f;  // one press of a strength or radius key

/// Allowed or not for this project's folder; the project is opened again, so that its files are read or not.
void toggleOutside(Workspace& w) {
  const std::filesystem::path path = w.document.path();
  const bool allowed = w.preferences.outsideFor(path) == OutsideFiles::Allow;
  w.preferences.setOutside(path, allowed ? OutsideFiles::Refuse : OutsideFiles::Allow);
  w.flow.requestOpen(path);
}

void addOutsideAction(Adder& file) {
  Workspace* w = &file.w;
  Action action{.id = "file.outside",
                .label = "Read files outside its folder",
                .category = {},
                .help = "Lets projects of this folder have files read that lie elsewhere, such as a shared library"};
  action.run = [w] { toggleOutside(*w); };
  action.enabled = [w] { return !w->document.path().empty(); };
  action.checked = [w] { return w->preferences.outsideFor(w->document.path()) == OutsideFiles::Allow; };
  file.add(std::move(action), {});
}

void addFileActions(Workspace& workspace) {
  Adder file(workspace, "File");
  file.always("file.new", "New", "Starts an empty project", {"Ctrl+N"}, [](Workspace& w) { w.flow.requestNew(); });
  file.always("file.open", "Open...", "Opens a project", {"Ctrl+O"}, [](Workspace& w) { w.flow.requestOpen(); });
  file.always("file.save", "Save", "Writes the project to its file; the old one stays as .bak", {"Ctrl+S"},
              [](Workspace& w) { w.flow.requestSave(); });
  file.always("file.save_as", "Save as...", "Writes the project to another file", {"Ctrl+Shift+S"},
              [](Workspace& w) { w.flow.requestSaveAs(); });
  addOutsideAction(file);
  file.always("file.quit", "Quit", "Closes the editor", {"Ctrl+Q"}, [](Workspace& w) { w.flow.requestQuit(); });
}

void addHistoryActions(Workspace& workspace) {
  Adder edit(workspace, "Edit");
  Workspace* w = &workspace;
  Action undo{.id = "edit.undo", .label = "Undo", .category = {}, .help = "Takes the last edit back"};
  undo.run = [w] { w->undo(); };
  undo.enabled = [w] { return w->document.history().canUndo(); };
  undo.dynamicLabel = [w] { return w->document.undoLabel(); };
  undo.repeats = true;
  edit.add(std::move(undo), {"Ctrl+Z"});
  Action redo{.id = "edit.redo", .label = "Redo", .category = {}, .help = "Does again what was taken back"};
  redo.run = [w] { w->redo(); };
  redo.enabled = [w] { return w->document.history().canRedo(); };
  redo.dynamicLabel = [w] { return w->document.redoLabel(); };
  redo.repeats = true;
  edit.add(std::move(redo), {"Ctrl+Shift+Z", "Ctrl+Y"});
}

void deleteSelected(Workspace& w) {
  w.apply(deleteEdit(w.document.committed(), w.selection.ids()));
}

/// Copies beside the originals, as far off as 24 pixels are there.
void duplicateSelected(Workspace& w) {
  const auto pivot = pivotOf(w.document.committed(), w.selection.ids());
  const float metres = 24.0f * w.view().metresPerPixel(w.ground.lift(pivot.value_or(glm::vec2(0.0f))));
  DuplicateResult copies = duplicateEdit(w.document.committed(), w.selection.ids(), glm::vec2(metres));
  if (w.apply(copies.edit)) w.selection.replace(std::move(copies.ids));
}

/// Copies that follow the pointer until a click.
void grabCopies(Workspace& w) {
  ToolContext context = w.context();
  const auto place = context.groundAt(w.pointer());
  if (!place) return;
  const glm::vec2 anchor = pivotOf(w.document.committed(), w.selection.ids()).value_or(*place);
  PointerEvent pointer;
  pointer.pixel = w.pointer();
  w.tools.startDrag(context, std::make_unique<MoveDrag>(context, *place, anchor, MoveWhat::Copies), pointer);
}

void addEditActions(Workspace& workspace) {
  Adder edit(workspace, "Edit");
  edit.onSelection("edit.cut", "Cut", "Copies the selection and deletes it", {"Ctrl+X"}, [](Workspace& w) {
    copySelection(w);
    deleteSelected(w);
  });
  edit.onSelection("edit.copy", "Copy", "Copies the selection as text that can be mailed", {"Ctrl+C"},
                   [](Workspace& w) { copySelection(w); });
  edit.always("edit.paste", "Paste", "Puts what was copied under the pointer", {"Ctrl+V"},
              [](Workspace& w) { pasteAtPointer(w); });
  edit.onSelection("edit.duplicate", "Duplicate", "Copies the selection beside itself", {"Ctrl+D"}, duplicateSelected);
  edit.onSelection("edit.duplicate_move", "Duplicate and move", "Copies that follow the pointer until a click",
                   {"Shift+D"}, grabCopies);
  edit.onSelection("edit.delete", "Delete", "Deletes the selection", {"Del", "X"}, deleteSelected);
}

void addSelectActions(Workspace& workspace) {
  Adder select(workspace, "Select");
  select.always("select.all", "All", "Selects everything that is not hidden or locked", {"A"},
                [](Workspace& w) { w.selection.replace(selectableIds(w.document.project())); });
  select.always("select.none", "None", "Selects nothing", {"Alt+A", "Esc"}, [](Workspace& w) { w.selection.clear(); });
  select.always("select.invert", "Invert", "Selects what is not selected", {"Ctrl+I"}, [](Workspace& w) {
    const std::vector<Id> all = selectableIds(w.document.project());
    windloom::editor::select(w.selection, all, SelectMode::Toggle);
  });
  select.onSelection("select.linked", "Whole tree", "Adds all that is joined to the selection", {"Ctrl+L"},
                     [](Workspace& w) { w.selection.replace(linkedIds(w.document.project(), w.selection.ids())); });
}

/// A new branch from the selected point, or from the end of the selected arrow, to the pointer.
void extrude(Workspace& w) {
  const Project& project = w.document.committed();
  const Arrow* arrow = findArrow(*project.graph, w.selection.active());
  const Id from = arrow ? arrow->to : w.selection.active();
  const auto place = w.context().groundAt(w.pointer());
  if (!findPoint(*project.graph, from) || !place) {
    w.say(MessageKind::Warning, "Select a point, and hold the pointer where the new one is to be");
    return;
  }
  BranchResult branch = branchEdit(project, from, *place, arrow ? *arrow : w.toolSettings.newArrow);
  branch.edit.label = "Extrude";
  if (w.apply(branch.edit)) w.selection.replace(branch.point);
}

void reportIfNothing(Workspace& w, const Edit& edit, const char* what) {
  if (edit.steps.empty()) {
    w.say(MessageKind::Warning, what);
  } else {
    w.apply(edit);
  }
}

/// The selected points; of a single one also those it was put on.
std::vector<Id> pointsToMerge(const Workspace& w) {
  constexpr float kSamePlaceM = 1e-3f;
  std::vector<Id> ids(w.selection.ids().begin(), w.selection.ids().end());
  const WindGraph& graph = *w.document.committed().graph;
  const Point* only = ids.size() == 1 ? findPoint(graph, ids[0]) : nullptr;
  if (!only) return ids;
  for (const Point& point : graph.points) {
    if (point.id != only->id && glm::distance(point.position, only->position) < kSamePlaceM) ids.push_back(point.id);
  }
  return ids;
}

void addGraphActions(Workspace& workspace) {
  Adder graph(workspace, "Graph");
  graph.onSelection("graph.extrude", "Extrude", "Adds a branch from the selected point to the pointer", {"Shift+E"},
                    extrude);
  graph.onSelection("graph.merge", "Merge points", "Merges the selected points into one; their flows merge", {"Ctrl+J"},
                    [](Workspace& w) {
                      reportIfNothing(w, mergePointsEdit(w.document.committed(), pointsToMerge(w)),
                                      "Select two points or more to merge them");
                    });
  graph.onSelection("graph.split", "Split", "Cuts the tree at the selected points", {"Y"}, [](Workspace& w) {
    SplitResult split = splitEdit(w.document.committed(), w.selection.ids());
    if (split.points.empty()) {
      w.say(MessageKind::Warning, "Select a point where arrows meet to split it");
    } else if (w.apply(split.edit)) {
      w.selection.replace(std::move(split.points));
    }
  });
  graph.onSelection("graph.dissolve", "Dissolve points", "Takes points out; the arrows before and after become one",
                    {"Ctrl+Del"},
                    [](Workspace& w) { w.apply(dissolveEdit(w.document.committed(), w.selection.ids())); });
  graph.onSelection("graph.reverse", "Reverse", "Turns the selected arrows around", {"Ctrl+R"},
                    [](Workspace& w) { w.apply(reverseEdit(w.document.committed(), w.selection.ids())); });
  graph.onSelection("graph.reparent", "Reparent", "Lets the selected points branch from the last selected one",
                    {"Ctrl+P"}, [](Workspace& w) {
                      reportIfNothing(w, reparentEdit(w.document.committed(), w.selection.ids()),
                                      "Select points that have a parent, then the new parent");
                    });
}

void toggleFlag(Workspace& w, Flag flag) {
  const Project& project = w.document.committed();
  w.apply(flagEdit(project, w.selection.ids(), flag, !allFlagged(project, w.selection.ids(), flag)));
}

/// Hides all but the selection; a second time shows all again.
void isolate(Workspace& w) {
  const Edit edit = isolateEdit(w.document.committed(), w.selection.ids());
  w.apply(edit.steps.empty() || w.selection.empty() ? clearFlagEdit(w.document.committed(), Flag::Hidden) : edit);
}

void addFlagActions(Workspace& workspace) {
  Adder graph(workspace, "Graph");
  graph.onSelection("graph.mute", "Mute", "Lets the selected arrows blow or not", {"M"},
                    [](Workspace& w) { toggleFlag(w, Flag::Muted); });
  graph.onSelection("graph.hide", "Hide", "Draws the selection no more", {"H"}, [](Workspace& w) {
    if (w.apply(flagEdit(w.document.committed(), w.selection.ids(), Flag::Hidden, true))) w.selection.clear();
  });
  graph.always("graph.show_all", "Show all", "Shows what was hidden", {"Alt+H"},
               [](Workspace& w) { w.apply(clearFlagEdit(w.document.committed(), Flag::Hidden)); });
  graph.always("graph.isolate", "Isolate", "Hides all but the selection; again shows all", {"Numpad /"}, isolate);
  graph.onSelection("graph.lock", "Lock", "Locked things can't be picked in the view", {},
                    [](Workspace& w) { toggleFlag(w, Flag::Locked); });
  graph.always("graph.unlock_all", "Unlock all", "Lets locked things be picked again", {},
               [](Workspace& w) { w.apply(clearFlagEdit(w.document.committed(), Flag::Locked)); });
  const auto steps = [&](const char* id, const char* label, const char* shortcut, auto make, float factor) {
    graph.onSelection(
        id, label, "", {shortcut},
        [make, factor](Workspace& w) { w.apply(make(w.document.committed(), w.selection.ids(), factor)); }, true);
  };
  steps("graph.strength_up", "Stronger", "Shift+]", scaleStrengthEdit, kStepFactor);
  steps("graph.strength_down", "Weaker", "Shift+[", scaleStrengthEdit, 1.0f / kStepFactor);
  steps("graph.radius_up", "Wider", "]", scaleRadiusEdit, kStepFactor);
  steps("graph.radius_down", "Narrower", "[", scaleRadiusEdit, 1.0f / kStepFactor);
}

void addToolActions(Workspace& workspace) {
  Adder tools(workspace, "Tools");
  constexpr std::pair<const char*, const char*> keys[] = {
      {"select", "Q"},   {"move", "W"},   {"rotate", "E"}, {"scale", "R"}, {"draw", "D"},
      {"obstacle", "O"}, {"vortex", "V"}, {"probe", "P"},  {"brush", "B"}, {"delete", nullptr}};
  for (const auto& [id, key] : keys) {
    const std::string tool = id;
    std::string label;
    for (const auto& candidate : workspace.tools.tools()) {
      if (candidate->id() == tool) label = candidate->label();
    }
    const auto run = [tool](Workspace& w) { w.activateTool(tool); };
    const auto checked = [tool](Workspace& w) { return w.tools.active().id() == tool; };
    if (key) {
      tools.always("tool." + tool, label, "", {key}, run, checked);
    } else {
      tools.always("tool." + tool, label + " tool", "", {}, run, checked);
    }
  }
  tools.always("tool.cancel", "Cancel", "Ends what is under way", {}, [](Workspace& w) { w.focusLost(); });
  const auto snapSwitch = [&](const char* id, const char* label, const char* help, bool SnapSettings::*flag) {
    tools.always(
        id, label, help, {}, [flag](Workspace& w) { w.toolSettings.snap.*flag = !(w.toolSettings.snap.*flag); },
        [flag](Workspace& w) { return w.toolSettings.snap.*flag; });
  };
  snapSwitch("snap.grid", "Snap to grid", "Ctrl while dragging turns it around", &SnapSettings::grid);
  snapSwitch("snap.angle", "Snap angles", "Ctrl while dragging turns it around", &SnapSettings::angle);
  snapSwitch("snap.points", "Snap to points", "Drawn arrows join the points they end at", &SnapSettings::points);
}

/// Through the project's cameras in turn.
void nextCamera(Workspace& w) {
  const std::vector<Camera>& cameras = *w.document.project().cameras;
  if (cameras.empty()) return w.say(MessageKind::Warning, "The project has no camera yet: store the view as one");
  std::size_t next = 0;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (cameras[i].id == w.lookedThrough()) next = (i + 1) % cameras.size();
  }
  w.lookAs(cameras[next].id);
  w.say(MessageKind::Info, describeIds(w.document.project(), std::span(&cameras[next].id, 1)));
}

void addCameraActions(Workspace& workspace) {
  Adder view(workspace, "View");
  view.always("view.camera_next", "Next project camera", "Looks through the project's cameras in turn", {}, nextCamera);
  view.always("view.camera_store", "Camera from view", "Stores the view in the project as a camera", {},
              [](Workspace& w) {
                const AddResult added = addCameraEdit(w.document.committed(), w.camera);
                if (!w.apply(added.edit)) return;
                w.lookAs(added.id);
                const std::string name = nameOf(w.document.project(), added.id);
                w.say(MessageKind::Info, "Stored as " + name);
              });
}

void addViewActions(Workspace& workspace) {
  Adder view(workspace, "View");
  view.always("view.frame", "Frame selection", "Shows the selection, or everything", {"F"},
              [](Workspace& w) { w.frame(w.selection.ids()); });
  view.always("view.frame_all", "Frame all", "Shows everything", {"Shift+F", "Home"},
              [](Workspace& w) { w.frame({}); });
  view.always("view.top", "Top view", "Looks straight down", {"Numpad 7"},
              [](Workspace& w) { w.camera = lookAlong(w.camera, ViewDirection::Top); });
  view.always("view.front", "Front view", "Looks along -Z", {"Numpad 1"},
              [](Workspace& w) { w.camera = lookAlong(w.camera, ViewDirection::Front); });
  view.always("view.side", "Side view", "Looks along -X", {"Numpad 3"},
              [](Workspace& w) { w.camera = lookAlong(w.camera, ViewDirection::Side); });
  view.always(
      "view.orthographic", "Orthographic", "Without perspective", {"Numpad 5"},
      [](Workspace& w) { w.camera.orthographic = !w.camera.orthographic; },
      [](Workspace& w) { return w.camera.orthographic; });
  addCameraActions(workspace);
}

/// The kind is the project's: a key switches it as an edit.
void addGrassActions(Workspace& workspace) {
  Adder view(workspace, "View");
  const auto kind = [&](const char* id, const char* label, const char* help, const char* key, GrassKind wanted) {
    view.always(
        id, label, help, {key},
        [wanted, label](Workspace& w) {
          GrassSettings grass = *w.document.committed().grass;
          if (grass.kind == wanted) return;
          grass.kind = wanted;
          w.apply(Edit{label, {Set<GrassSettings>{grass}}, {}});
        },
        [wanted](Workspace& w) { return w.document.project().grass->kind == wanted; });
  };
  kind("grass.instanced", "Instanced grass", "Grass of single blades, each drawn", "1", GrassKind::Instanced);
  kind("grass.bezier", "Bezier grass", "Blades with a memory each, on ground and surfaces", "2", GrassKind::Bezier);
  kind("grass.shell", "Shell grass",
       "Layers with cuts through blades, on ground and surfaces: quick, and good from afar", "3", GrassKind::Shell);
  kind("grass.none", "No grass", "Bare ground, to see the wind alone", "4", GrassKind::None);
}

}  // namespace

void registerCoreActions(Workspace& workspace) {
  addFileActions(workspace);
  addHistoryActions(workspace);
  addEditActions(workspace);
  addSelectActions(workspace);
  addAddActions(workspace);
  addGraphActions(workspace);
  addFlagActions(workspace);
  addToolActions(workspace);
  addViewActions(workspace);
  addGrassActions(workspace);
}

}  // namespace windloom::editor
