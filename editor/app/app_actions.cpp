// The actions that need a window or a running session; the others are the core's.

#include <algorithm>
#include <functional>
#include <string>

#include "editor/app/app.hpp"
#include "editor/panels/grass_view.hpp"
#include "engine/session/solver_scheme.hpp"

namespace windloom::editor {

namespace {

struct OverlayEntry {
  const char *name, *label, *help;
  Key key;
};

constexpr OverlayEntry kOverlayEntries[] = {
    {"arrows", "Arrows", "Wind trees as arrows on the ground, coloured by strength.", Key::Digit5},
    {"streamlines", "Streamlines", "Short lines that run with the wind.", Key::Digit6},
    {"vectors", "Wind vectors", "The wind on a regular grid.", Key::None},
    {"speed", "Speed map", "Wind speed as colours on the ground.", Key::Digit7},
    {"divergence", "Divergence map", "Where air gathers (blue) and spreads (orange).", Key::Digit8},
    {"vorticity", "Vorticity map", "Where and which way the air turns: orange from +X towards +Z.", Key::None},
    {"lic", "Line integral convolution", "Streaks along the wind that move with it, coloured by speed.", Key::Digit9},
};

}  // namespace

void App::registerActions() {
  ActionTable& actions = m_workspace.actions;
  actions.add({.id = "file.export",
               .label = "Export...",
               .category = "File",
               .help = "Records the wind for a game.",
               .shortcuts = {{Key::E, {.ctrl = true, .shift = true}}},
               .run = [this] { m_export.show(); }});
  registerPlayActions();
  actions.add({.id = "edit.rename",
               .label = "Rename",
               .category = "Edit",
               .help = "Gives what is selected a name, in the outliner.",
               .shortcuts = {{Key::F2, {}}},
               .run =
                   [this] {
                     if (!m_outliner.rename(m_workspace.document.project(), m_workspace.selection.active()))
                       m_workspace.say(MessageKind::Warning, "Points within a tree are named in the inspector");
                   },
               .enabled = [this] { return !m_workspace.selection.empty(); }});
  registerSolverActions();
  registerFileActions();
  registerViewActions();
  actions.add({.id = "help.keys",
               .label = "Keys and mouse",
               .category = "Help",
               .help = "All shortcuts and gestures.",
               .shortcuts = {{Key::F1, {}}},
               .run = [this] { m_helpOpen = !m_helpOpen; },
               .checked = [this] { return m_helpOpen; }});
  actions.add({.id = "help.palette",
               .label = "Find a command",
               .category = "Help",
               .help = "Every command by name.",
               .shortcuts = {{Key::F3, {}}, {Key::P, {.ctrl = true, .shift = true}}},
               .run = [this] { m_palette.open(); }});
  actions.add({.id = "help.about", .label = "About Windloom", .category = "Help", .help = "", .run = [this] {
                 m_aboutOpen = true;
               }});
}

void App::registerPlayActions() {
  ActionTable& actions = m_workspace.actions;
  const auto hasSession = [this] { return m_live->session() != nullptr; };
  actions.add({.id = "play.toggle",
               .label = "Play",
               .category = "Play",
               .help = "Lets the wind run, or holds it.",
               .shortcuts = {{Key::Space, {}}},
               .run =
                   [this] {
                     Session& session = *m_live->session();
                     if (session.playing())
                       session.pause();
                     else
                       session.play();
                   },
               .enabled = hasSession,
               .checked = [this] { return m_live->session() && m_live->session()->playing(); }});
  actions.add({.id = "play.step",
               .label = "Step",
               .category = "Play",
               .help = "One time step of the solver, then holds.",
               .shortcuts = {{Key::Period, {}}},
               .run =
                   [this] {
                     m_live->session()->pause();
                     m_live->session()->stepOnce();
                   },
               .enabled = hasSession,
               .repeats = true});
  actions.add({.id = "play.restart",
               .label = "Restart",
               .category = "Play",
               .help = "Back to time 0 and the ambient wind.",
               .shortcuts = {{Key::Space, {.shift = true}}},
               .run = [this] { m_live->session()->restart(); },
               .enabled = hasSession});
  registerTimeActions();
  actions.add(
      {.id = "play.full_grid",
       .label = "Live wind on the project's grid",
       .category = "Play",
       .help = "Off: a slow machine may run the live wind on a coarser grid. Sample and bake always use the project's.",
       .run =
           [this] { m_live->setLiveGrid(m_live->liveGrid() == LiveGrid::Full ? LiveGrid::Automatic : LiveGrid::Full); },
       .checked = [this] { return m_live->liveGrid() == LiveGrid::Full; }});
}

void App::registerTimeActions() {
  ActionTable& actions = m_workspace.actions;
  const auto add = [&](const char* id, const char* label, const char* help, Shortcut shortcut,
                       std::function<void(Session&)> work, bool repeats = false) {
    Action action{.id = id, .label = label, .category = "Play", .help = help, .shortcuts = {shortcut}};
    action.run = [this, work = std::move(work)] { work(*m_live->session()); };
    action.enabled = [this] { return m_live->session() != nullptr; };
    action.repeats = repeats;
    if (action.id == "play.loop") action.checked = [this] { return m_live->session() && m_live->session()->loop().on; };
    actions.add(std::move(action));
  };
  add("play.loop", "Loop", "Plays the time between the loop's marks again and again.", {Key::L, {.shift = true}},
      [](Session& session) {
        LoopRange loop = session.loop();
        loop.on = !loop.on;
        session.setLoop(loop);
      });
  add("play.loop_in", "Loop starts here", "The loop begins at the present time.", {Key::I, {.shift = true}},
      [](Session& session) {
        LoopRange loop = session.loop();
        const double length = loop.out - loop.in;
        loop.in = session.time();
        if (loop.out <= loop.in) loop.out = loop.in + length;
        loop.on = true;
        session.setLoop(loop);
      });
  add("play.loop_out", "Loop ends here", "The loop ends at the present time.", {Key::O, {.shift = true}},
      [](Session& session) {
        LoopRange loop = session.loop();
        loop.out = session.time();
        if (loop.in >= loop.out) loop.in = 0;
        loop.on = true;
        session.setLoop(loop);
      });
  const auto jump = [](double seconds) {
    return [seconds](Session& session) {
      const auto seeking = session.seeking();
      session.seek(std::max(0.0, (seeking ? seeking->target : session.time()) + seconds));
    };
  };
  add("play.back", "Back one second", "Goes back in time by a second.", {Key::Left, {.alt = true}}, jump(-1), true);
  add("play.forward", "Forward one second", "Goes on by a second as fast as it can.", {Key::Right, {.alt = true}},
      jump(1), true);
}

/// New things whose shape is a file.
void App::registerFileActions() {
  ActionTable& actions = m_workspace.actions;
  actions.add({.id = "add.species_file",
               .label = "Add species from glTF...",
               .category = "Add",
               .help = "A plant or tuft from a file grows among the blades.",
               .run = [this] { m_inspector.assets().browse(m_workspace, {.use = AssetUse::Species}); }});
  actions.add({.id = "add.collider_file",
               .label = "Add collider from glTF...",
               .category = "Add",
               .help = "A thing from a file, in the middle of the view, that bends the grass.",
               .run = [this] {
                 constexpr float kReachM = 0.5f;
                 const glm::vec2 place = freePlace(m_workspace, kReachM);
                 m_inspector.assets().browse(m_workspace, {.use = AssetUse::Collider, .place = place});
               }});
  actions.add({.id = "add.surface_file",
               .label = "Add surface from glTF...",
               .category = "Add",
               .help = "A thing from a file, in the middle of the view, with Bezier or shell grass all over it.",
               .run = [this] {
                 constexpr float kReachM = 0.5f;
                 const glm::vec2 place = freePlace(m_workspace, kReachM);
                 m_inspector.assets().browse(m_workspace, {.use = AssetUse::Surface, .place = place});
               }});
}

/// One for each preset: its settings on the project, undone like any other edit.
void App::registerSolverActions() {
  for (const SolverPreset& preset : solverPresets()) {
    m_workspace.actions.add(
        {.id = "solver." + std::string(preset.name),
         .label = "Solver preset: " + std::string(preset.name),
         .category = "Play",
         .help = std::string(preset.help),
         .run =
             [this, &preset] {
               const SolverSettings& now = *m_workspace.document.committed().solver;
               Edit edit;
               edit.label = "Solver preset " + std::string(preset.name);
               if (!hasScheme(now, preset)) edit.steps.push_back(Set<SolverSettings>{withScheme(now, preset)});
               m_workspace.apply(edit);
             },
         .checked = [this, &preset] { return hasScheme(*m_workspace.document.project().solver, preset); }});
  }
}

/// How Bezier grass is looked at; no part of the project.
void App::registerGrassViewActions() {
  ActionTable& actions = m_workspace.actions;
  const auto grows = [this] { return m_workspace.document.project().grass->kind == GrassKind::Bezier; };
  for (const GrassViewEntry& entry : kGrassViews) {
    actions.add({.id = std::string("grass_view.") + entry.name,
                 .label = std::string("Grass view: ") + entry.label,
                 .category = "Grass",
                 .help = entry.help,
                 .run = [this, view = entry.view] { m_viewport.grassView = view; },
                 .enabled = grows,
                 .checked = [this, view = entry.view] { return m_viewport.grassView == view; }});
  }
  for (const CullingEntry& entry : kCullingTests) {
    const auto on = entry.on;
    actions.add({.id = std::string("cull.") + entry.name,
                 .label = std::string("Leave out blades: ") + entry.label,
                 .category = "Grass",
                 .help = entry.help,
                 .run = [this, on] { m_viewport.bezierCulling.*on = !(m_viewport.bezierCulling.*on); },
                 .enabled = grows,
                 .checked = [this, on] { return m_viewport.bezierCulling.*on; }});
  }
}

void App::registerViewActions() {
  ActionTable& actions = m_workspace.actions;
  for (const OverlayEntry& entry : kOverlayEntries) {
    const OverlayKind* kind = findOverlay(entry.name);
    WL_REQUIRE(kind != nullptr, "every entry names an overlay");
    std::vector<Shortcut> shortcuts;
    if (entry.key != Key::None) shortcuts.push_back({entry.key, {}});
    actions.add({.id = "overlay." + std::string(entry.name),
                 .label = entry.label,
                 .category = "View",
                 .help = entry.help,
                 .shortcuts = std::move(shortcuts),
                 .run = [this, kind] { setOn(m_viewport.overlays, *kind, !isOn(m_viewport.overlays, *kind)); },
                 .checked = [this, kind] { return isOn(m_viewport.overlays, *kind); }});
  }
  registerGrassViewActions();
  actions.add({.id = "view.full_quality",
               .label = "Full quality",
               .category = "View",
               .help = "Draws all the grass, however long a frame takes.",
               .run = [this] { m_live->setFullQuality(!m_live->fullQuality()); },
               .checked = [this] { return m_live->fullQuality(); }});
  actions.add({.id = "view.light_theme",
               .label = "Light theme",
               .category = "View",
               .help = "Dark text on light panels.",
               .run =
                   [this] {
                     Theme& theme = m_workspace.preferences.theme;
                     theme = theme == Theme::Dark ? Theme::Light : Theme::Dark;
                     m_lookChanged = true;
                   },
               .checked = [this] { return m_workspace.preferences.theme == Theme::Light; }});
  for (const int percent : {100, 125, 150, 200}) {
    const std::string number = std::to_string(percent);
    actions.add({.id = "view.scale_" + number,
                 .label = "Interface at " + number + "%",
                 .category = "View",
                 .help = "Size of text and controls.",
                 .run =
                     [this, percent] {
                       m_line.scale = 0;
                       m_workspace.preferences.interfaceScale = float(percent) / 100;
                       m_lookChanged = true;
                     },
                 .checked = [this, percent] { return int(m_look.scale * 100 + 0.5f) == percent; }});
  }
  actions.add({.id = "view.reset_panels",
               .label = "Reset panel sizes",
               .category = "View",
               .help = "Gives every panel the size it had at first.",
               .run = [this] { m_layout = {}; }});
  actions.add({.id = "view.reload_shaders",
               .label = "Reload shaders",
               .category = "View",
               .help = "Builds changed shader files again; errors are in the log.",
               .run = [this] { m_live->reloadShaders(); }});
}

}  // namespace windloom::editor
