#include "editor/app/app.hpp"

#include <imgui_internal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "editor/app/frame_picture.hpp"
#include "editor/app/keys.hpp"
#include "editor/app/user_folders.hpp"
#include "editor/core/help_page.hpp"
#include "editor/panels/grass_view.hpp"
#include "editor/widgets/number_field.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"
#include "engine/io/terrain_file.hpp"

namespace windloom::editor {

namespace {

/// By then the project before and its wind and grass are gone.
constexpr double kTrimAfterS = 2;

constexpr std::pair<const char*, float Overlays::*> kOverlayRanges[] = {
    {"overlay.speedRange", &Overlays::speedRange},
    {"overlay.divergenceRange", &Overlays::divergenceRange},
    {"overlay.vorticityRange", &Overlays::vorticityRange}};

/// Shortcuts of files work while a field is typed into, too.
bool leavesField(const InputEvent& event, Key key) {
  const bool file = key == Key::S || key == Key::N || key == Key::O || key == Key::Q;
  return file && translateModifiers(event.modifiers).ctrl;
}

}  // namespace

Result<std::unique_ptr<App>> App::create(const CommandLine& line, LogFile& log) {
  const std::filesystem::path file = preferencesFile();
  const Preferences preferences = line.unattended() ? Preferences{} : editor::readPreferences(file);
  WindowOptions options;
  // A file that someone wrote by hand may ask for any size.
  const auto pixels = [&](const char* name, int least, int usual) {
    const double kept = preferences.number(name, usual);
    return kept >= least && kept <= 16384 ? int(kept) : usual;
  };
  options.width = line.width.value_or(pixels("window.width", 320, options.width));
  options.height = line.height.value_or(pixels("window.height", 240, options.height));
  options.maximised = !line.width && preferences.number("window.maximised", 0) != 0;
  auto window = Window::create(options);
  if (!window) return window.error();
  std::unique_ptr<App> app(new App(line, log, std::move(window).value()));
  app->m_preferencesFile = file;
  auto live = LiveView::create();
  if (!live) return live.error();
  app->m_live = std::move(live).value();
  app->readPreferences();
  app->applyLook();
  app->connect();
  app->registerActions();
  if (const Status keymap = app->m_workspace.actions.applyKeymap(app->m_workspace.preferences.keymap); !keymap)
    logWarning(keymap.error().text());
  if (!line.file.empty()) app->m_workspace.flow.requestOpen(line.file);
  app->m_workspace.selection.replace(std::vector<Id>(line.selected.begin(), line.selected.end()));
  app->m_workspace.selection.repair(app->m_workspace.document.project());
  return app;
}

App::App(const CommandLine& line, LogFile& log, std::unique_ptr<Window> window)
    : m_line(line), m_window(std::move(window)), m_log(log), m_autosave(autosaveFolder(), std::to_string(::getpid())) {
  ImGui::GetIO().UserData = &m_look;
  if (!line.uiMap.empty()) m_look.map.setFile(line.uiMap);
}

App::~App() {
  // The workspace's callbacks point here.
  m_workspace.flow.onFailure = {};
  m_workspace.flow.onDone = {};
  m_workspace.flow.onReplaced = {};
  m_workspace.flow.onFileUsed = {};
}

void App::connect() {
  m_workspace.readClipboard = [this] { return m_window->clipboard(); };
  m_workspace.writeClipboard = [this](const std::string& text) { m_window->setClipboard(text); };
  DocumentFlow& flow = m_workspace.flow;
  flow.onFailure = [this](const Error& error) {
    logError(error.text());
    m_dialogs.showError(error.text());
  };
  flow.onDone = [this](const std::string& text) {
    logInfo(text);
    m_workspace.say(MessageKind::Info, text);
  };
  // By the time that the question is answered, the work may have ended.
  flow.workUnderWay = [this] { return m_export.running() ? std::string("An export") : std::string(); };
  flow.onReplaced = [this, before = flow.onReplaced] {
    if (before) before();
    m_live->restart();
    m_trimAtS = ImGui::GetTime() + kTrimAfterS;
    ++m_opened;
  };
  flow.onFileUsed = [this](const std::filesystem::path& path) {
    m_workspace.preferences.usedFile(path);
    writePreferences();
  };
  if (!m_line.unattended()) m_dialogs.offerRescues(findRescues(m_autosave.folder()));
}

void App::readPreferences() {
  if (m_line.unattended()) return;
  if (m_preferencesFile.empty() || m_autosave.folder().empty())
    logWarning("There is no home folder: preferences, the log and unsaved work are not kept. Set HOME to a folder.");
  std::vector<std::string> warnings;
  m_workspace.preferences = editor::readPreferences(m_preferencesFile, &warnings);
  for (const std::string& warning : warnings) logWarning(warning);
  const Preferences& preferences = m_workspace.preferences;
  m_layout.left = float(preferences.number("layout.left", double(m_layout.left)));
  m_layout.right = float(preferences.number("layout.right", double(m_layout.right)));
  m_layout.bottom = float(preferences.number("layout.bottom", double(m_layout.bottom)));
  m_layout.timeline = float(preferences.number("layout.timeline", double(m_layout.timeline)));
  m_export.readPreferences(preferences);
  m_live->setLiveGrid(preferences.number("play.fullGrid", 0) != 0 ? LiveGrid::Full : LiveGrid::Automatic);
  readOverlays();
}

void App::readOverlays() {
  const Preferences& preferences = m_workspace.preferences;
  Overlays& overlays = m_viewport.overlays;
  for (const OverlayKind& kind : overlayKinds()) {
    setOn(overlays, kind, preferences.number("overlay." + std::string(kind.name), isOn(overlays, kind)) != 0);
  }
  for (const auto& [name, range] : kOverlayRanges) {
    const double value = preferences.number(name, double(overlays.*range));
    if (value >= kLeastRange && value <= kGreatestRange) overlays.*range = float(value);
  }
}

void App::writePreferences() {
  if (m_line.unattended() || m_preferencesFile.empty()) return;
  auto& numbers = m_workspace.preferences.numbers;
  numbers["layout.left"] = double(m_layout.left);
  numbers["layout.right"] = double(m_layout.right);
  numbers["layout.bottom"] = double(m_layout.bottom);
  numbers["layout.timeline"] = double(m_layout.timeline);
  numbers["play.fullGrid"] = m_live->liveGrid() == LiveGrid::Full;
  for (const OverlayKind& kind : overlayKinds()) {
    numbers["overlay." + std::string(kind.name)] = isOn(m_viewport.overlays, kind);
  }
  m_export.keepPreferences(m_workspace.preferences);
  for (const auto& [name, range] : kOverlayRanges) numbers[name] = double(m_viewport.overlays.*range);
  numbers["window.maximised"] = m_window->maximised();
  if (!m_window->maximised() && !m_line.width) {
    numbers["window.width"] = m_window->size().x;
    numbers["window.height"] = m_window->size().y;
  }
  if (const Status status = editor::writePreferences(m_preferencesFile, m_workspace.preferences); !status)
    logWarning(status.error().text());
}

void App::applyLook() {
  const Preferences& preferences = m_workspace.preferences;
  m_look.theme = preferences.theme;
  m_look.scale = m_line.scale > 0                 ? m_line.scale
                 : preferences.interfaceScale > 0 ? preferences.interfaceScale
                                                  : m_window->contentScale();
  applyTheme(m_look);
  loadFonts(m_look);
  m_window->remakeFonts();
  m_workspace.toolSettings.hitRadiusPx = kHitRadiusPx * m_look.scale;
  m_lookChanged = false;
}

int App::run() {
  if (!m_line.keys.empty()) return writeKeys();
  while (!m_exit) {
    if (m_lookChanged) applyLook();
    m_window->beginFrame(waitSeconds(), typingPending());
    if (!tryFrame()) continue;
    if (m_window->closeRequested()) {
      m_window->keepOpen();
      m_workspace.flow.requestQuit();
    }
    if (m_workspace.flow.quitConfirmed()) m_exit = 0;
  }
  // Else the side file is what the work is kept in.
  if (m_troubledFrames == 0 && m_lastWords.empty()) m_autosave.finish();
  writePreferences();
  return *m_exit;
}

int App::writeKeys() const {
  const Status status = writeFileAtomically(m_line.keys, helpMarkdown(helpPage(m_workspace.actions)));
  if (!status) logError(status.error().text());
  return status.ok() ? 0 : 3;
}

double App::waitSeconds() const {
  if (!m_line.screenshot.empty()) return 0;
  const Session* session = m_live->session();
  const bool playing = session && (session->playing() || session->seeking());
  // Nothing moves: wake for events, and now and then for the blinking text cursor.
  if (!playing && m_idleSeconds > 0.5) return 0.1;
  // Screens show 60 pictures a second; where swapping doesn't wait for them, this does.
  const double spent = std::chrono::duration<double>(Clock::now() - m_lastFrame).count();
  return std::max(0.0, 1.0 / 60 - spent - 0.001);
}

PanelContext App::panelContext() {
  PanelContext context{m_workspace, m_live->session(), m_live->facts()};
  context.facts.liveLink = m_export.share().state();
  context.facts.liveLinkFailed = m_export.share().failed();
  return context;
}

void App::passKeys() {
  const ImGuiIO& io = ImGui::GetIO();
  const bool popup = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup),
             busy = io.WantTextInput || m_dialogs.open() || popup;
  for (const InputEvent& event : m_window->events()) {
    if (event.kind == InputEvent::Kind::Focus && event.action == 0) {
      m_workspace.focusLost();
      m_timeline.focusLost(m_workspace);
      m_viewport.focusLost();
      m_outliner.cancelDrag();
    }
    if (event.kind != InputEvent::Kind::Key) continue;
    const Key key = translateKey(event.code, event.scancode);
    if (key == Key::None) continue;
    if (event.action == GLFW_RELEASE)
      m_workspace.keyReleased(key);
    else if (io.WantTextInput && !m_dialogs.open() && !popup && event.action == GLFW_PRESS && leavesField(event, key)) {
      // The field takes what was typed before the file is written.
      ImGui::ClearActiveID();
      m_afterFields = {key, translateModifiers(event.modifiers), false};
    } else if (key == Key::Escape && popup && !m_dialogs.open())
      ImGui::ClosePopupToLevel(0, false);  // ImGui leaves menus open
    else if (key == Key::Escape && m_outliner.cancelDrag())
      continue;
    else if (!busy) {
      const KeyPress press{key, translateModifiers(event.modifiers), event.action == GLFW_REPEAT};
      PanelContext context = panelContext();
      if (!m_timeline.keyPressed(press, context)) m_workspace.keyPressed(press);
    }
  }
}

void App::runAfterFields() {
  if (m_afterFields.key != Key::None) m_workspace.keyPressed(m_afterFields);
  m_afterFields = {};
}

void App::openDropped() {
  for (const std::filesystem::path& path : m_window->takeDrops()) {
    if (path.string().ends_with(".json")) return m_workspace.flow.requestOpen(path);
    if (terrainKindOf(path)) {
      m_workspace.loadTerrain(path);
      continue;
    }
    m_workspace.say(MessageKind::Warning,
                    path.filename().string() + ": drop a project (NAME.wind.json), or terrain (.png, .glb, .gltf)");
  }
}

/// What must stay when the kind of grass changes, and how it is looked at.
void App::tellGrass() {
  UiMap& map = m_look.map;
  const GrassKind kind = m_workspace.document.project().grass->kind;
  const char* names[] = {"instanced", "bezier", "shell", "none"};
  map.fact("grass", names[static_cast<std::size_t>(kind)]);
  std::string tests;
  for (const CullingEntry& entry : kCullingTests)
    if (m_viewport.bezierCulling.*entry.on) tests.append(tests.empty() ? "" : " ").append(entry.name);
  map.fact("culling", tests);
  for (const GrassViewEntry& entry : kGrassViews)
    if (m_viewport.grassView == entry.view) map.fact("grass view", entry.name);
  const glm::vec3 eye = m_workspace.camera.position(), target = m_workspace.camera.target;
  std::string camera;
  for (const float part : {eye.x, eye.y, eye.z, target.x, target.y, target.z}) camera += shortest(part) + " ";
  map.fact("camera", camera);
  map.fact("wind", m_live->session() ? shortest(m_live->session()->status().wind.maxSpeed) : "");
}

void App::tellMap(double seconds) {
  if (!m_look.map.on()) return;
  UiMap& map = m_look.map;
  const Document& document = m_workspace.document;
  map.fact("frame", std::to_string(m_frames));
  map.fact("title", m_title);
  map.fact("dirty", document.dirty() ? "yes" : "no");
  map.fact("steps", std::to_string(document.history().position()));
  map.fact("tool", m_workspace.tools.active().id());
  map.fact("hovered", std::to_string(m_workspace.tools.hovered()));
  map.fact("selection", describeIds(document.project(), m_workspace.selection.ids()));
  map.fact("dragging", m_workspace.tools.busy() ? "yes" : "no");
  map.fact("typing", ImGui::GetIO().WantTextInput ? "yes" : "no");
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  map.fact("pointer", std::to_string(int(pointer.x)) + " " + std::to_string(int(pointer.y)));
  const EditorCamera& camera = m_workspace.camera;
  map.fact("view", camera.orthographic && camera.pitch == 90 ? "top"
                   : camera.orthographic                     ? "orthographic"
                                                             : "perspective");
  std::string overlays;
  for (const OverlayKind& kind : overlayKinds()) {
    if (!isOn(m_viewport.overlays, kind)) continue;
    if (!overlays.empty()) overlays += ' ';
    overlays += kind.name;
  }
  map.fact("overlays", overlays);
  map.fact("terrain", document.project().terrain->heights ? document.project().terrain->file : "flat");
  map.fact("scene", m_live->session() ? "yes" : "no");
  map.fact("playing", m_live->session() && m_live->session()->playing() ? "yes" : "no");
  map.fact("help", m_helpOpen ? "yes" : "no");
  map.fact("palette", m_palette.isOpen() ? "yes" : "no");
  tellGrass();
  tellHealth(seconds);
  map.fact("strokes", std::to_string(m_workspace.strokes.size()));
}

void App::frame() {
  const Clock::time_point now = Clock::now();
  const double seconds =
      m_line.screenshot.empty() ? std::chrono::duration<double>(now - m_lastFrame).count() : 1.0 / 30;
  m_lastFrame = now;
  m_idleSeconds = m_window->events().empty() ? m_idleSeconds + seconds : 0;
  // Slow frames must not break double clicks: press and release take a frame each.
  ImGui::GetIO().MouseDoubleClickTime = std::max(0.3f, float(seconds) * 6);

  passKeys();
  openDropped();
  const ImGuiIO& io = ImGui::GetIO();
  m_workspace.tick(seconds, {.ctrl = io.KeyCtrl, .shift = io.KeyShift, .alt = io.KeyAlt});
  followWind();
  drawInterface();
  runAfterFields();
  m_window->endFrame();
  drawPicture(seconds);
  if (m_line.screenshot.empty())
    if (const Status status = m_autosave.tick(m_workspace.document, ImGui::GetTime()); !status)
      m_workspace.say(MessageKind::Warning, status.error().text());

  if (const std::string title = m_workspace.document.title(); title != m_title) m_window->setTitle(m_title = title);
  if (m_trimAtS > 0 && ImGui::GetTime() > m_trimAtS) giveMemoryBack();
  tellMap(seconds);
  m_look.map.endFrame();
  ++m_frames;
  heedTrouble();
}

/// The picture behind what the interface draws is made after it and shows a later time: about as much later as the last
/// one did.
void App::followWind() {
  const Session* session = m_live->session();
  if (!session) return;
  constexpr double kMostS = 0.25;
  const double now = session->time(), before = std::exchange(m_windBefore, now);
  const bool runs = session->playing() && !session->seeking();
  m_workspace.windSeconds = now + (runs ? std::clamp(now - before, 0.0, kMostS) : 0.0);
}

void App::drawPicture(double seconds) {
  // The first frame shows the window at once; the scene's programs are built behind it.
  if (m_frames > 0) m_live->follow(m_workspace.document);
  m_live->advance(seconds, m_workspace.strokes);
  bool drawn = false;
  if (Session* session = m_live->session()) {
    PanelContext context = panelContext();
    m_probes.sample(context);
    m_export.follow(context);
    drawn = m_viewport.updatePicture(*session, m_workspace, m_window->pixelRatio(), m_live->detail());
  }
  const ImVec4& back = m_look.palette.border;
  m_window->clear({back.x, back.y, back.z});
  m_viewport.copyPicture(m_window->framebufferSize(), m_window->pixelRatio());
  m_window->paint();
  if (!m_line.screenshot.empty() && m_frames + 1 >= m_line.frames) finishScreenshot();
  m_window->swap();
  if (m_frames == 0) tellStart("Window");
  if (drawn && !std::exchange(m_pictureTold, true)) tellStart("Picture");
  m_live->frameDone(seconds, drawn);
}

void App::tellStart(const char* what) const {
  const double took = std::chrono::duration<double>(Clock::now() - m_started).count();
  logInfo(std::string(what) + " after " + std::to_string(int(took * 1000)) + " ms");
}

void App::finishScreenshot() {
  const Status status = saveFramePicture(m_line.screenshot, m_window->framebufferSize());
  if (!status) logError(status.error().text());
  m_exit = status.ok() ? 0 : 3;
}

}  // namespace windloom::editor
